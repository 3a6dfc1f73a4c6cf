#include "process/bounded_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trace {

void BoundedText::append(std::string_view bytes) {
  const std::size_t to_head = std::min(bytes.size(), head_bytes - head_.size());
  head_.append(bytes.substr(0, to_head));
  bytes.remove_prefix(to_head);

  if (bytes.size() > tail_bytes) {
    left_out_ += tail_.size() + bytes.size() - tail_bytes;
    tail_ = bytes.substr(bytes.size() - tail_bytes);
    return;
  }
  tail_.append(bytes);
  if (tail_.size() > 2 * tail_bytes) {
    left_out_ += tail_.size() - tail_bytes;
    tail_.erase(0, tail_.size() - tail_bytes);
  }
}

std::string BoundedText::text() const {
  const std::size_t kept = std::min(tail_.size(), tail_bytes);
  const std::uint64_t left_out = left_out_ + (tail_.size() - kept);
  std::string all = head_;
  if (left_out > 0) all += fmt::format("\n[... {} bytes left out ...]\n", left_out);
  return all.append(tail_, tail_.size() - kept);
}

}  // namespace trace
