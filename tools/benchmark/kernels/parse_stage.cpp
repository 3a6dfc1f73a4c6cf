#include <fmt/format.h>

#include <charconv>

#include "parser/parse.hpp"
#include "tools/benchmark/kernels/repeated.hpp"
#include "tools/benchmark/kernels/stages.hpp"

namespace trace::bench {
namespace {

struct Numbers {
  std::size_t count = 0;
  double sum = 0;
};

bool begins_number(char c) {
  return (c >= '0' && c <= '9') || c == '-' || c == '.';
}

// All numbers of the text, whatever stands between them.
Numbers read_numbers(std::string_view text) {
  Numbers numbers;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (at != end) {
    if (!begins_number(*at)) {
      ++at;
      continue;
    }
    double value = 0;
    const auto [rest, problem] = std::from_chars(at, end, value);
    if (problem == std::errc()) {
      ++numbers.count;
      numbers.sum += value;
    }
    at = rest == at ? at + 1 : rest;
  }
  return numbers;
}

}  // namespace

void measure_parse(const ParseArguments& arguments) {
  const auto source = parser::Source::from_file(arguments.scene);
  const auto report = [&](const char* what, const Times& times) {
    fmt::print("{} bytes={} {} MB/s={:.3f}\n", what, source.text().size(), times.text(),
               static_cast<double>(source.text().size()) / times.median() / 1000);
  };
  if (arguments.numbers_alone) {
    const Numbers numbers = read_numbers(source.text());
    const Times times = repeated(arguments.repetitions, [&] { return read_numbers(source.text()); });
    report(fmt::format("numbers count={} sum={:.9g}", numbers.count, numbers.sum).c_str(), times);
    return;
  }
  const Times times = repeated(arguments.repetitions, [&] {
    parser::Diagnostics diagnostics;
    parser::Scene description = parser::parse(source, diagnostics);
    if (diagnostics.has_errors()) throw std::runtime_error(parser::render(source, diagnostics));
    return description;
  });
  report("parse", times);
}

}  // namespace trace::bench
