#include "tools/trace/batch/batch_jobs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "batch/folder_scenes.hpp"
#include "batch/foreign_renderer.hpp"
#include "batch/solutions.hpp"
#include "report/plain_text.hpp"
#include "tools/trace/tolerances.hpp"

namespace trace {
namespace {

namespace fs = std::filesystem;

// "NAME=COMMAND", or a command whose program gives the name.
Renderer parse_renderer(const std::string& text, std::set<std::string>& taken) {
  const auto is_name = [](unsigned char c) { return std::isalnum(c) || c == '.' || c == '_' || c == '-'; };
  const auto end = std::find_if_not(text.begin(), text.end(), is_name);
  Renderer renderer;
  std::string command = text;
  if (end != text.begin() && end != text.end() && *end == '=' && *text.begin() != '.') {
    renderer.name.assign(text.begin(), end);
    command.assign(end + 1, text.end());
  }
  renderer.command = parse_renderer_command(command);
  if (renderer.name.empty()) renderer.name = fs::path(renderer.command.front()).filename().string();
  const std::string name = renderer.name;
  for (int i = 2; !taken.insert(renderer.name).second; ++i) renderer.name = fmt::format("{}-{}", name, i);
  return renderer;
}

std::vector<Renderer> parse_renderers(const std::vector<std::string>& programs) {
  if (programs.empty()) return {{"trace", {}}};
  std::vector<Renderer> renderers;
  std::set<std::string> taken;
  for (const std::string& program : programs) {
    try {
      renderers.push_back(parse_renderer(program, taken));
    } catch (const std::invalid_argument& e) {
      throw BatchError(fmt::format("trace: error: --exec '{}': {}\n", program, e.what()));
    }
  }
  return renderers;
}

// As names stand in results: what is not UTF-8 is written \\xff, so that no two names become one.
std::string valid_utf8_or_escaped(const std::string& name) {
  if (valid_utf8(name) == name) return name;
  std::string result;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    result += byte < 0x80 ? std::string(1, c) : fmt::format("\\x{:02x}", byte);
  }
  return result;
}

class Planner {
 public:
  explicit Planner(const BatchArguments& arguments) : arguments_(arguments) {}

  BatchPlan plan() {
    plan_.renderers = parse_renderers(arguments_.programs);
    std::error_code ignored;
    for (const std::string& folder : {arguments_.folder, arguments_.solutions}) {
      if (!folder.empty() && !fs::is_directory(folder, ignored))
        throw BatchError(fmt::format("trace: error: '{}' is not a folder\n", folder));
    }
    common_.depth = arguments_.options.depth;
    common_.width = arguments_.options.width;
    if (!arguments_.cube_map.empty()) common_.cube_map = arguments_.cube_map;
    common_.timeout = arguments_.timeout;
    common_.memory = arguments_.memory;
    if (!arguments_.settings.empty()) {
      const SettingsFile file = read_settings(arguments_.settings);
      if (!file.valid) throw BatchError(file.messages);
      plan_.warnings += file.messages;
      common_.settings.push_back(file);
    }
    const FolderScenes found = scenes_of_folder(arguments_.folder, arguments_.filter, common_);
    plan_.warnings += found.messages;
    plan_.incomplete = !found.complete;
    for (const auto& [scene, options] : found.scenes) add(scene, options);
    check_solutions();
    if (!found.valid) throw BatchError(plan_.warnings);
    set_tolerances();
    return std::move(plan_);
  }

 private:
  void add(const std::string& scene, const SceneOptions& options) {
    Job job;
    job.name = valid_utf8_or_escaped(scene);
    job.scene = (fs::path(arguments_.folder) / scene).string();
    job.options.depth = *options.depth;
    job.options.width = *options.width;
    job.options.dialect = arguments_.options.dialect;
    job.options.permissive = arguments_.options.permissive;
    for (const Settings& settings : options.settings) settings.apply(job.options);
    job.cube_map = options.cube_map.value_or("");
    job.limits = {std::chrono::duration<double>(*options.timeout),
                  static_cast<std::uint64_t>(options.memory.value_or(0) * (1 << 20))};
    if (!arguments_.solutions.empty()) job.solution = solutions_.find(scene);
    for (const Renderer& renderer : plan_.renderers) {
      job.renderer = renderer;
      fs::path place = arguments_.output;
      if (!arguments_.programs.empty()) place /= renderer.name;
      job.picture = (place / scene).replace_extension(".png");
      if (!job.solution.empty()) job.heat_map = (place / scene).replace_extension(".heat.png");
      check_unique(job);
      plan_.jobs.push_back(job);
    }
  }

  void check_solutions() const {
    const auto has_one = [](const Job& job) { return !job.solution.empty(); };
    if (!arguments_.solutions.empty() && !plan_.jobs.empty() &&
        std::none_of(plan_.jobs.begin(), plan_.jobs.end(), has_one))
      throw BatchError(
          fmt::format("trace: error: no picture in '{}' has the name of a scene\n", arguments_.solutions));
  }

  void set_tolerances() {
    std::vector<std::string> names;
    for (const Job& job : plan_.jobs)
      names.push_back(fs::path(job.name).replace_extension("").generic_string());
    const Tolerances tolerances({arguments_.tolerance, arguments_.tolerances, arguments_.solutions, false},
                                {names.begin(), names.end()});
    if (!tolerances.valid()) throw BatchError(tolerances.messages());
    plan_.warnings += tolerances.messages();
    for (std::size_t i = 0; i < names.size(); ++i) plan_.jobs[i].tolerance = tolerances.of(names[i]);
  }

  void check_unique(const Job& job) {
    for (const fs::path& file : {job.picture, job.heat_map}) {
      if (file.empty()) continue;
      const auto [other, is_new] = pictures_.emplace(file, job.name);
      if (!is_new)
        throw BatchError(fmt::format("trace: error: '{}' and '{}' would both be drawn to '{}'\n",
                                     other->second, job.name, file.string()));
    }
    std::error_code ignored;
    if (!job.solution.empty() && fs::equivalent(job.solution, job.picture, ignored))
      throw BatchError(fmt::format("trace: error: the picture of '{}' would replace its solution '{}'\n",
                                   job.name, job.solution.string()));
  }

  const BatchArguments& arguments_;
  SceneOptions common_;
  Solutions solutions_{arguments_.solutions};
  BatchPlan plan_;
  std::map<fs::path, std::string> pictures_;
};

}  // namespace

BatchPlan plan_batch(const BatchArguments& arguments) {
  return Planner(arguments).plan();
}

}  // namespace trace
