// Values by name up to a total size; what was used longest ago goes first.
#pragma once

#include <cstddef>
#include <list>
#include <string>
#include <unordered_map>
#include <utility>

namespace trace {

template <typename Value>
class LruCache {
 public:
  LruCache(std::size_t most_bytes, std::size_t most_entries)
      : most_bytes_(most_bytes), most_entries_(most_entries) {}

  // Null where there is none. Good until the next put().
  Value* find(const std::string& key) {
    const auto found = by_key_.find(key);
    if (found == by_key_.end()) return nullptr;
    entries_.splice(entries_.begin(), entries_, found->second);
    return &found->second->value;
  }

  // Replaces what had the key. A value larger than everything together is not kept.
  void put(const std::string& key, Value value, std::size_t bytes) {
    if (const auto found = by_key_.find(key); found != by_key_.end()) drop(found->second);
    entries_.push_front({key, std::move(value), bytes});
    by_key_[key] = entries_.begin();
    bytes_ += bytes;
    while (!entries_.empty() && (bytes_ > most_bytes_ || entries_.size() > most_entries_))
      drop(std::prev(entries_.end()));
  }

  void clear() {
    entries_.clear();
    by_key_.clear();
    bytes_ = 0;
  }
  std::size_t size() const { return entries_.size(); }
  std::size_t bytes() const { return bytes_; }

 private:
  struct Entry {
    std::string key;
    Value value;
    std::size_t bytes;
  };
  using Place = typename std::list<Entry>::iterator;

  void drop(Place place) {
    bytes_ -= place->bytes;
    by_key_.erase(place->key);
    entries_.erase(place);
  }

  std::size_t most_bytes_, most_entries_;
  std::size_t bytes_ = 0;
  std::list<Entry> entries_;  // most recently used first
  std::unordered_map<std::string, Place> by_key_;
};

}  // namespace trace
