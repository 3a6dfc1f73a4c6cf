#include "tests/support/picture_table.hpp"

#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

namespace trace::test {

std::vector<std::vector<std::string>> read_table(const std::filesystem::path& file) {
  std::istringstream text(read_text(file));
  std::vector<std::vector<std::string>> rows;
  std::string line;
  std::getline(text, line);
  while (std::getline(text, line)) {
    std::vector<std::string> row;
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, '\t');) row.push_back(cell);
    if (!row.empty()) rows.push_back(std::move(row));
  }
  return rows;
}

Difference compare(const Image& a, const Image& b) {
  if (a.width != b.width || a.height != b.height) throw std::runtime_error("the pictures' sizes differ");
  Difference result;
  result.total = a.rgb.size() / 3;
  for (std::size_t i = 0; i < a.rgb.size(); i += 3) {
    int most = 0;
    for (std::size_t channel = 0; channel < 3; ++channel) {
      most = std::max(most, std::abs(a.rgb[i + channel] - b.rgb[i + channel]));
    }
    result.pixels += most > 0;
    result.over_a_level += most > 1;
  }
  return result;
}

namespace {

std::string quoted(const std::string& word) {
  std::string result = "'";
  for (const char c : word) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

}  // namespace

Outcome run_trace(const std::filesystem::path& folder, const std::string& arguments,
                  const std::vector<std::string>& files, const std::string& standard_input) {
  const TemporaryFolder scratch;
  const auto in = scratch.path() / "in", out = scratch.path() / "out", err = scratch.path() / "err";
  write_text(in, standard_input);
  std::string command = "cd " + quoted(folder.string()) + " && " + quoted(TRACE_PROGRAM) + " " + arguments;
  for (const std::string& file : files) command += " " + quoted(file);
  command += " <" + quoted(in.string()) + " >" + quoted(out.string()) + " 2>" + quoted(err.string());
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_text(err), read_text(out)};
}

}  // namespace trace::test
