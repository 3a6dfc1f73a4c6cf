#include "tests/support/batch_folder.hpp"

#include <algorithm>

namespace trace::test {

void BatchFolder::add_scene(const std::string& name, const std::string& objects) const {
  const std::filesystem::path file = folder_ / ("scenes/" + name);
  std::filesystem::create_directories(file.parent_path());
  write_text(file,
             "SBT-raytracer 1.0 camera { position = (0,0,-4); viewdir = (0,0,1); updir = (0,1,0); }\n"
             "point_light { position = (3,4,-5); color = (1,1,1); }\n" +
                 objects + "\n");
}

Outcome BatchFolder::run(const std::string& arguments) const {
  return run_trace(path(), "batch " + arguments);
}

int BatchFolder::shell(const std::string& command) const {
  const std::string text = "cd '" + path().string() + "' && TRACE='" + TRACE_PROGRAM +
                           "' && export TRACE && { " + command + "; } >/dev/null 2>&1";
  const int status = std::system(text.c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

nlohmann::json BatchFolder::results(const std::string& output) const {
  return nlohmann::json::parse(read_text(folder_ / (output + "/results.json")));
}

nlohmann::json BatchFolder::results_without_times(const std::string& output) const {
  nlohmann::json all = results(output);
  for (const char* key : {"command", "started", "seconds"}) all.erase(key);
  for (nlohmann::json& result : all.at("results")) {
    for (const char* key : {"seconds", "cpu_seconds", "memory_mib", "picture"}) result.erase(key);
  }
  return all;
}

nlohmann::json BatchFolder::result(const std::string& scene) const {
  const nlohmann::json all = results("out");
  for (const nlohmann::json& result : all.at("results")) {
    if (result.at("scene") == scene) return result;
  }
  throw std::runtime_error("no result of " + scene);
}

std::string BatchFolder::outcome(const std::string& scene) const {
  return result(scene).at("outcome");
}

std::string BatchFolder::message(const std::string& scene) const {
  return result(scene).at("message");
}

std::string BatchFolder::verdict(const std::string& scene) const {
  return result(scene).at("comparison").at("verdict");
}

std::size_t BatchFolder::lines(const std::string& file) const {
  if (!std::filesystem::exists(folder_ / file)) return 0;
  const std::string text = read_text(folder_ / file);
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

std::vector<std::string> BatchFolder::names(const std::string& folder) const {
  std::vector<std::string> result;
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / folder))
    result.push_back(entry.path().filename().string());
  std::sort(result.begin(), result.end());
  return result;
}

std::string endless_objects() {
  std::string text;
  for (int i = 0; i < 40; ++i) {
    const std::string at = std::to_string(0.05 * i);
    text += "translate(" + at + ",0," + at +
            ",sphere{material={reflective=(.9,.9,.9);transmissive=(.9,.9,.9);index=1.2;}})\n";
  }
  return text;
}

}  // namespace trace::test
