#include "parser/list_reader.hpp"

#include <fmt/format.h>
#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "parser/comments.hpp"
#include "parser/number.hpp"
#include "parser/plain_number.hpp"
#include "parser/printable.hpp"

namespace trace::parser {

namespace {

// Memory that will be written from end to end: fewer, larger pages are sooner had. Only advice.
void use_large_pages(void* memory, std::size_t bytes) {
  constexpr std::uintptr_t large_page = std::uintptr_t{2} << 20;
  const auto begin = (reinterpret_cast<std::uintptr_t>(memory) + large_page - 1) / large_page * large_page;
  const auto end = (reinterpret_cast<std::uintptr_t>(memory) + bytes) / large_page * large_page;
  if (begin < end) ::madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
}

class ListReader {
 public:
  // `first` is how many values the vector held before.
  ListReader(const Source& source, std::uint32_t begin, std::size_t first, Diagnostics& diagnostics)
      : text_(source.text().data()),
        end_(text_ + source.text().size()),
        begin_(text_ + begin),
        at_(begin_),
        first_(first),
        diagnostics_(diagnostics) {}

  // The character behind blanks and comments, which `at_` then stands at.
  char peek() {
    while (is_blank(*at_)) ++at_;
    if (*at_ == '/') at_ = skip_blanks(at_, end_);
    return *at_;
  }
  bool take(char c) {
    if (*at_ != c && peek() != c) return false;
    ++at_;
    return true;
  }
  bool number(double& value) {
    if (!begins_number(peek())) return false;
    if (!fast_number(value)) slow_number(value);
    return true;
  }
  bool index(std::uint32_t& value);
  // Appends the entries from here on that have nothing but good numbers (and blanks) in them and a ',' behind
  // them, and stops in front of the first other one. Whether there was one.
  template <class Value>
  bool plain_entries(std::vector<Value>& values);
  void too_few_corners(const char* begin, std::size_t count);

  // Makes room for `count` more. How much more will come is judged by the distance to the ';' behind the list
  // (looked for no further than a multiple of what was read, so that all the looking takes linear time):
  // growing in small steps would cost as much as the reading.
  template <class Value>
  void make_room(std::vector<Value>& values, std::size_t count) const {
    if (values.capacity() - values.size() >= count) return;
    constexpr std::size_t look = 32;
    const auto read = static_cast<std::size_t>(at_ - begin_) + 1;
    const std::size_t ahead = std::min(static_cast<std::size_t>(end_ - at_), look * read);
    const void* const stop = std::memchr(at_, ';', ahead);
    const std::size_t bytes =
        stop == nullptr ? ahead : static_cast<std::size_t>(static_cast<const char*>(stop) - at_);
    const std::size_t more = static_cast<std::size_t>(1.02 * static_cast<double>(values.size() - first_) *
                                                      static_cast<double>(bytes) / static_cast<double>(read));
    values.reserve(values.size() + std::max({more, values.size() / 2, std::size_t{48}}));
    use_large_pages(values.data(), values.capacity() * sizeof(Value));
  }

  const char* place() const { return at_; }
  ListStop stop(ListNeed need, bool inside) {
    peek();
    return {need, static_cast<std::uint32_t>(at_ - text_), inside};
  }
  ListStop done() { return {ListNeed::nothing, static_cast<std::uint32_t>(at_ - text_), false}; }

 private:
  Span span(const char* begin, const char* end) const {
    return {static_cast<std::uint32_t>(begin - text_), static_cast<std::uint32_t>(end - text_)};
  }
  bool fast_number(double& value);
  void slow_number(double& value);

  const char* text_;
  const char* end_;
  const char* begin_;
  const char* at_;
  std::size_t first_;
  Diagnostics& diagnostics_;
};

// Whether a number ends where this character follows: what else may stand there is left to read_number.
bool ends_number(char c) {
  return c == ',' || c == ')' || is_blank(c);
}

bool ListReader::fast_number(double& value) {
  const char* const behind = read_plain_number(at_, value);
  if (behind == nullptr || !ends_number(*behind)) return false;
  at_ = behind;
  return true;
}

const char* behind_blanks(const char* at) {
  while (is_blank(*at)) ++at;
  return at;
}

// What read_plain_number leaves; null where it is not good.
[[gnu::noinline]] const char* good_number(const char* at, const char* end, double& value) {
  if (!begins_number(*at)) return nullptr;
  const NumberText number = read_number(at, end);
  value = number.value;
  return number.state == NumberState::good ? number.end : nullptr;
}

[[gnu::always_inline]] inline const char* plain_value(const char* at, const char* end, double& value) {
  const char* const behind = read_plain_number(at, value);
  return behind != nullptr && ends_number(*behind) ? behind : good_number(at, end, value);
}

[[gnu::always_inline]] inline const char* plain_value(const char* at, const char*, std::uint32_t& value) {
  const DigitRun run = read_digits(at);
  value = static_cast<std::uint32_t>(run.value);
  return run.count != 0 && ends_number(at[run.count]) ? at + run.count : nullptr;
}

// Behind the `opener`, a value and the blanks on both sides of it; null where that does not stand at `at`.
template <class Value>
[[gnu::always_inline]] inline const char* plain_part(const char* at, const char* end, char opener,
                                                     Value& value) {
  if (*at != opener) return nullptr;
  at = plain_value(behind_blanks(at + 1), end, value);
  return at == nullptr ? nullptr : behind_blanks(at);
}

// The three values of an entry that begins at `at`, or in blanks before it; returns behind its ',', null
// where it is not plain.
template <class Value>
[[gnu::always_inline]] inline const char* plain_entry(const char* at, const char* end, Value* values) {
  at = plain_part(behind_blanks(at), end, '(', values[0]);
  if (at != nullptr) at = plain_part(at, end, ',', values[1]);
  if (at != nullptr) at = plain_part(at, end, ',', values[2]);
  if (at == nullptr || *at != ')') return nullptr;
  at = behind_blanks(at + 1);
  return *at == ',' ? at + 1 : nullptr;
}

template <class Value>
bool ListReader::plain_entries(std::vector<Value>& values) {
  bool any = false;
  constexpr std::size_t most = 192;  // values gathered before the vector is looked at again
  std::array<Value, most> some;
  for (std::size_t count = most; count == most;) {
    count = 0;
    const char* at = at_;
    while (count < most && (at = plain_entry(at, end_, &some[count])) != nullptr) {
      at_ = at;
      count += 3;
    }
    if (count == 0) break;
    any = true;
    make_room(values, count);
    values.insert(values.end(), some.begin(), some.begin() + static_cast<std::ptrdiff_t>(count));
  }
  return any;
}

void ListReader::slow_number(double& value) {
  const NumberText read = read_number(at_, end_);
  const std::string_view run(at_, static_cast<std::size_t>(read.end - at_));
  if (read.state == NumberState::malformed) {
    diagnostics_.error(span(at_, read.end), "malformed number " + in_quotes(run));
  } else if (read.state == NumberState::out_of_range) {
    diagnostics_.error(span(at_, read.end), "number " + in_quotes(run) + " is out of range");
  }
  value = read.value;
  at_ = read.end;
}

bool ListReader::index(std::uint32_t& value) {
  const char c = peek();
  if (!begins_number(c)) return false;
  const char* const begin = at_;
  std::uint32_t digits = 0;
  const char* p = begin;
  while (is_digit(*p) && p - begin < 9) digits = digits * 10 + static_cast<unsigned>(*p++ - '0');
  if (p != begin && ends_number(*p)) {
    at_ = p;
    value = digits;
    return true;
  }
  double number = 0;
  slow_number(number);
  const std::string_view written(begin, static_cast<std::size_t>(at_ - begin));
  if (number != std::floor(number)) {
    diagnostics_.error(span(begin, at_), fmt::format("face index {} is not a whole number", written));
  } else if (number < 0) {
    diagnostics_.error(span(begin, at_), fmt::format("face index {} is negative", written));
  }
  constexpr double most = std::numeric_limits<std::uint32_t>::max();
  value = static_cast<std::uint32_t>(number < 0 ? 0 : number > most ? most : number);
  return true;
}

void ListReader::too_few_corners(const char* begin, std::size_t count) {
  diagnostics_.error(span(begin, at_), fmt::format("a face has at least three corners, this one has {}",
                                                   count == 1 ? "one" : "two"));
}

}  // namespace

ListStop read_tuples(std::size_t count, const Source& source, std::uint32_t begin,
                     std::vector<double>& numbers, Diagnostics& diagnostics) {
  ListReader list(source, begin, numbers.size(), diagnostics);
  if (list.take(')')) return list.done();
  for (ListNeed need = ListNeed::first_entry;; need = ListNeed::entry) {
    if (count == 3 && list.plain_entries(numbers)) need = ListNeed::entry;
    if (need == ListNeed::entry && list.take(')')) return list.done();
    if (!list.take('(')) return list.stop(need, false);
    for (std::size_t i = 0; count == 0 || i < count; ++i) {
      if (i > 0 && !list.take(',')) {
        if (count == 0) break;
        return list.stop(ListNeed::comma, true);
      }
      double number = 0;
      if (!list.number(number)) return list.stop(ListNeed::number, true);
      list.make_room(numbers, 1);
      numbers.push_back(number);
    }
    if (!list.take(')')) return list.stop(count == 0 ? ListNeed::comma_or_close : ListNeed::close, true);
    if (list.take(',')) continue;
    if (list.take(')')) return list.done();
    return list.stop(ListNeed::comma_or_end, false);
  }
}

ListStop read_faces(const Source& source, std::uint32_t begin, std::vector<std::uint32_t>& corners,
                    std::vector<std::uint32_t>& sizes, Diagnostics& diagnostics) {
  ListReader list(source, begin, corners.size(), diagnostics);
  if (list.take(')')) return list.done();
  for (ListNeed need = ListNeed::first_entry;; need = ListNeed::entry) {
    if (sizes.empty() && list.plain_entries(corners)) need = ListNeed::entry;
    if (need == ListNeed::entry && list.take(')')) return list.done();
    list.peek();
    const char* const face = list.place();
    if (!list.take('(')) return list.stop(need, false);
    const std::size_t before = corners.size();
    do {
      std::uint32_t corner = 0;
      if (!list.index(corner)) return list.stop(ListNeed::number, true);
      list.make_room(corners, 1);
      corners.push_back(corner);
    } while (list.take(','));
    if (!list.take(')')) return list.stop(ListNeed::comma_or_close, true);
    const std::size_t count = corners.size() - before;
    if (count < 3) list.too_few_corners(face, count);
    if (count != 3 && sizes.empty()) sizes.assign(before / 3, 3);
    if (count != 3 || !sizes.empty()) sizes.push_back(static_cast<std::uint32_t>(count));
    if (list.take(',')) continue;
    if (list.take(')')) return list.done();
    return list.stop(ListNeed::comma_or_end, false);
  }
}

Span number_span(const Source& source, Span list, std::uint64_t k) {
  const char* const text = source.text().data();
  const char* const end = text + list.end;
  const char* at = text + list.begin;
  for (;;) {
    at = skip_blanks(at, end);
    if (at >= end) return list;
    if (!begins_number(*at)) {
      ++at;
      continue;
    }
    const char* const behind = read_number(at, end).end;
    if (k == 0) return {static_cast<std::uint32_t>(at - text), static_cast<std::uint32_t>(behind - text)};
    --k;
    at = behind;
  }
}

}  // namespace trace::parser
