// Which tolerance `trace diff` holds each pair to: that of the command line, or of a tolerance file.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/trace/diff_arguments.hpp"
#include "tools/trace/tolerance_file.hpp"

namespace trace {

class DiffTolerances {
 public:
  // Reads the file that counts, if there is one: --tolerances, else tolerances.json in `folder` (empty where
  // two pictures are compared). `scenes` are the names of all pairs: entries for none of them are warned of
  // where folders are compared.
  DiffTolerances(const DiffArguments& arguments, const std::string& folder,
                 const std::vector<std::string_view>& scenes);

  bool valid() const { return valid_; }
  const std::string& messages() const { return messages_; }  // for standard error; may be empty

  Tolerance of(std::string_view scene) const;

  // The file to write to; empty where there is none.
  const std::string& path() const { return path_; }
  const std::string& text() const { return text_; }  // empty where the file does not exist

 private:
  std::optional<Tolerance> fixed_;
  ToleranceFile file_;
  std::string path_, text_, messages_;
  bool valid_ = true;
};

}  // namespace trace
