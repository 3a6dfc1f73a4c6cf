// A folder with scenes for `trace batch`, and its results.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/picture_table.hpp"

namespace trace::test {

inline const std::string box = "box { material = { diffuse = (0.8, 0.5, 0.2); } }";
inline const std::string sphere = "sphere { material = { diffuse = (0.8, 0.5, 0.2); } }";

class BatchFolder {
 public:
  const std::filesystem::path& path() const { return folder_.path(); }
  std::filesystem::path operator/(std::string_view name) const { return folder_ / name; }

  // scenes/NAME, with a camera, a light and these objects behind them, from line 3.
  void add_scene(const std::string& name, const std::string& objects = box) const;

  // Runs `trace batch` in the folder; the arguments are as for a shell.
  Outcome run(const std::string& arguments) const;
  // Runs a command of the shell in the folder, where $TRACE is the program; its exit status.
  int shell(const std::string& command) const;

  nlohmann::json results(const std::string& output) const;  // OUTPUT/results.json
  // The same without what may differ between two runs.
  nlohmann::json results_without_times(const std::string& output) const;
  // Of the first result of a scene in out/.
  std::string outcome(const std::string& scene) const;
  std::string message(const std::string& scene) const;
  std::string verdict(const std::string& scene) const;

  std::size_t lines(const std::string& file) const;  // 0 where there is no such file
  std::vector<std::string> names(const std::string& folder) const;

 private:
  nlohmann::json result(const std::string& scene) const;

  TemporaryFolder folder_;
};

// Objects that take longer than anyone waits, at a great depth: mirrors of glass within each other.
std::string endless_objects();

}  // namespace trace::test
