#include "rendering/non_finite.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace trace {
namespace {

constexpr std::array<const char*, 3> channel_names{"red", "green", "blue"};

constexpr std::uint8_t undefined_bit(int channel) {
  return static_cast<std::uint8_t>(1 << channel);
}
constexpr std::uint8_t infinite_bit(int channel) {
  return static_cast<std::uint8_t>(8 << channel);
}

// "red", "red and blue", "red, green and blue"
std::string list(Channels channels) {
  std::string text;
  int left = 0;
  for (int channel = 0; channel < 3; ++channel) left += channels.has(channel);
  for (int channel = 0; channel < 3; ++channel) {
    if (!channels.has(channel)) continue;
    text += channel_names[static_cast<std::size_t>(channel)];
    --left;
    if (left > 0) text += left == 1 ? " and " : ", ";
  }
  return text;
}

std::string clause(Channels channels, const char* what) {
  const bool one = channels == Channels(0) || channels == Channels(1) || channels == Channels(2);
  return fmt::format("{} {} {}", list(channels), one ? "is" : "are", what);
}

}  // namespace

std::string to_text(const NonFinitePixels& found) {
  std::string why;
  if (found.infinite.any()) why = clause(found.infinite, "infinite");
  if (found.undefined.any()) {
    why += (why.empty() ? "" : ", ") + clause(found.undefined, "undefined and drawn black");
  }
  if (found.count == 1) {
    return fmt::format("one pixel has a colour that is not finite, at ({}, {}): {}", found.x, found.y, why);
  }
  return fmt::format("{} pixels have a colour that is not finite, the first at ({}, {}): {}", found.count,
                     found.x, found.y, why);
}

void NonFiniteMap::note(int i, int j, const PartialRgb& color) {
  const auto width = static_cast<std::size_t>(width_), height = static_cast<std::size_t>(height_);
  std::call_once(allocated_, [&] { marks_.resize(width * height); });
  std::uint8_t& mark =
      marks_[(height - 1 - static_cast<std::size_t>(j)) * width + static_cast<std::size_t>(i)];
  for (int channel = 0; channel < 3; ++channel) {
    if (color.undefined.has(channel)) {
      mark |= undefined_bit(channel);
    } else if (std::isinf(color.value[channel])) {
      mark |= infinite_bit(channel);
    }
  }
}

NonFinitePixels NonFiniteMap::found() const {
  NonFinitePixels result;
  const auto is_marked = [](std::uint8_t mark) { return mark != 0; };
  const auto first = std::find_if(marks_.begin(), marks_.end(), is_marked);
  if (first == marks_.end()) return result;
  result.count = static_cast<std::uint64_t>(std::count_if(first, marks_.end(), is_marked));
  const auto place = first - marks_.begin();
  result.x = static_cast<int>(place % width_);
  result.y = static_cast<int>(place / width_);
  for (int channel = 0; channel < 3; ++channel) {
    if ((*first & undefined_bit(channel)) != 0) result.undefined |= Channels(channel);
    if ((*first & infinite_bit(channel)) != 0) result.infinite |= Channels(channel);
  }
  return result;
}

}  // namespace trace
