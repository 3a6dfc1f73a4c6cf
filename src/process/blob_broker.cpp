#include "process/blob_broker.hpp"

#include <algorithm>
#include <utility>

namespace trace {

bool BlobBroker::is_making(WorkerId worker) const {
  return std::any_of(making_.begin(), making_.end(),
                     [&](const auto& entry) { return entry.second.maker == worker; });
}

std::vector<BlobBroker::Reply> BlobBroker::wanted(WorkerId worker, const std::string& key) {
  std::vector<Reply> replies;
  if (const Descriptor* blob = kept_.find(key)) {
    replies.push_back({worker, blob->duplicate()});
  } else if (const auto found = making_.find(key); found == making_.end()) {
    making_[key] = {worker, {}};
    replies.push_back({worker, {}});
  } else if (is_making(worker)) {
    replies.push_back({worker, {}});
  } else {
    found->second.waiting.push_back(worker);
  }
  return replies;
}

std::vector<BlobBroker::Reply> BlobBroker::made(WorkerId worker, const std::string& key, Descriptor blob) {
  std::vector<Reply> replies;
  const auto found = making_.find(key);
  const bool awaited = found != making_.end() && found->second.maker == worker;
  if (awaited && blob) {
    for (WorkerId waiting : found->second.waiting) replies.push_back({waiting, blob.duplicate()});
    making_.erase(found);
  } else if (awaited && !found->second.waiting.empty()) {
    found->second.maker = found->second.waiting.front();
    found->second.waiting.pop_front();
    replies.push_back({found->second.maker, {}});
  } else if (awaited) {
    making_.erase(found);
  }
  if (blob) {
    const std::uint64_t size = shared_size(blob);
    kept_.put(key, std::move(blob), size);
  }
  return replies;
}

std::vector<BlobBroker::Reply> BlobBroker::gone(WorkerId worker) {
  std::vector<std::string> unfinished;
  for (auto& [key, making] : making_) {
    std::erase(making.waiting, worker);
    if (making.maker == worker) unfinished.push_back(key);
  }
  std::vector<Reply> replies;
  for (const std::string& key : unfinished) {
    for (Reply& reply : made(worker, key, {})) replies.push_back(std::move(reply));
  }
  return replies;
}

void BlobBroker::clear() {
  making_.clear();
  kept_.clear();
}

}  // namespace trace
