// Debian's Python as a second opinion on the formats we write.
#pragma once

#include <string>
#include <vector>

namespace trace::test {

struct PythonResult {
  int status = 0;
  std::string output;  // standard output and standard error
};

// Runs a program with these arguments; `input` is its standard input.
PythonResult run_python(const std::string& program, const std::vector<std::string>& arguments,
                        const std::string& input);

// What is wrong with a JSON text by one of docs/schemas ("diff-1.schema.json"), one fault a line; "" where
// nothing is.
std::string schema_faults(const std::string& schema, const std::string& json);

}  // namespace trace::test
