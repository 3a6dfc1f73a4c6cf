#include "process/bounded_text.hpp"

#include <catch2/catch.hpp>
#include <string>

namespace trace::test {
namespace {

constexpr std::size_t all_kept = BoundedText::head_bytes + BoundedText::tail_bytes;

std::string letters(std::size_t count) {
  std::string text(count, ' ');
  for (std::size_t i = 0; i < count; ++i) text[i] = char('a' + i % 23);
  return text;
}

std::string kept(const std::string& text, std::size_t part) {
  BoundedText bounded;
  for (std::size_t at = 0; at < text.size(); at += part) bounded.append(text.substr(at, part));
  return bounded.text();
}

}  // namespace

TEST_CASE("a text that fits is kept as it is, in whatever parts it comes") {
  for (std::size_t part : {7, 1000, 50'000, 1'000'000}) {
    CHECK(kept(letters(all_kept), part) == letters(all_kept));
    CHECK(kept("", part).empty());
  }
}

TEST_CASE("of a longer text the beginning and the end are kept, and how much is missing") {
  for (std::size_t part : {7, 1000, 50'000, 1'000'000}) {
    const std::string text = letters(300'000);
    const std::string expected = text.substr(0, BoundedText::head_bytes) +
                                 "\n[... 234464 bytes left out ...]\n" +
                                 text.substr(text.size() - BoundedText::tail_bytes);
    CHECK(kept(text, part) == expected);
  }
}

}  // namespace trace::test
