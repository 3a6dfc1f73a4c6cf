// Which tolerance each scene is held to: that of the command line, or of a tolerance file.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "loading/tolerance_file.hpp"

namespace trace {

struct ToleranceChoice {
  std::optional<Tolerance> fixed;  // of the command line; then there is no file
  std::string file;                // that the user names; empty: tolerances.json in `folder`
  std::string folder;              // of the references; empty where there is none
  bool may_be_missing = false;     // the named file
};

class Tolerances {
 public:
  // Reads the file that counts, if there is one. `scenes` are the names of all that is compared: where there
  // is a folder, entries for none of them are warned of.
  Tolerances(const ToleranceChoice& choice, const std::vector<std::string_view>& scenes);

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
