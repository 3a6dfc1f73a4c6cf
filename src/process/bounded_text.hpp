// The beginning and the end of what a program writes, however much that is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace trace {

// The first 32 KiB are kept because the first error is the one that matters, the last 32 KiB because a
// program's last words tell why it stopped.
class BoundedText {
 public:
  static constexpr std::size_t head_bytes = 32 << 10, tail_bytes = 32 << 10;

  void append(std::string_view bytes);
  // Head and tail, between them a line "[... 123 bytes left out ...]" where something is missing.
  std::string text() const;
  void clear() { *this = BoundedText(); }

 private:
  std::string head_, tail_;     // tail_ may hold up to twice what is kept of it
  std::uint64_t left_out_ = 0;  // between the two
};

}  // namespace trace
