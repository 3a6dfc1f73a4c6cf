// Tables of scenes with arguments and expected pictures, and the comparison of pictures.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "image/image.hpp"
#include "tests/support/temporary_folder.hpp"

namespace trace::test {

// The rows of a tab-separated file below its header. Throws where it cannot be read.
std::vector<std::vector<std::string>> read_table(const std::filesystem::path& file);

struct Difference {
  std::size_t pixels = 0;        // that differ at all
  std::size_t over_a_level = 0;  // that differ by more than one level in some channel
  std::size_t total = 0;
};

// Throws where the sizes differ.
Difference compare(const Image& a, const Image& b);

struct Outcome {
  int status = 0;
  std::string errors;  // what was printed to standard error
  std::string output;  // what was printed to standard output
};

// Runs build/trace in `folder`; `arguments` are split at blanks, `files` are added as they are.
Outcome run_trace(const std::filesystem::path& folder, const std::string& arguments,
                  const std::vector<std::string>& files = {}, const std::string& standard_input = "");

}  // namespace trace::test
