#include "tools/trace/batch/batch_jobs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "batch/batch_file.hpp"
#include "batch/foreign_renderer.hpp"
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

std::vector<std::string> list_scenes(const BatchArguments& arguments) {
  if (!fs::is_directory(arguments.folder))
    throw BatchError(fmt::format("trace: error: '{}' is not a folder\n", arguments.folder));
  try {
    return find_scenes(arguments.folder, arguments.filter);
  } catch (const fs::filesystem_error& e) {
    throw BatchError(fmt::format("trace: error: cannot read the folder '{}': {}\n", e.path1().string(),
                                 e.code().message()));
  }
}

// The batch.json files of the batch's folder and those below it, read when a scene there is met.
class BatchFiles {
 public:
  BatchFiles(fs::path root, std::string& messages) : root_(std::move(root)), messages_(messages) {}

  bool valid() const { return valid_; }

  // What they say of a scene; nothing where one of them excludes it.
  std::optional<SceneOptions> of(const std::string& scene) {
    SceneOptions result;
    fs::path folder, rest = scene;
    for (;;) {
      if (const auto& file = in(folder)) {
        const std::string path = rest.generic_string();
        for (const std::string& pattern : file->exclude()) {
          if (matches(pattern, path)) return std::nullopt;
        }
        result.add(file->of(path));
      }
      if (!rest.has_parent_path()) return result;
      folder /= *rest.begin();
      rest = rest.lexically_relative(*rest.begin());
    }
  }

 private:
  const std::optional<BatchFile>& in(const fs::path& folder) {
    const auto [entry, is_new] = files_.try_emplace(folder);
    if (is_new) entry->second = BatchFile::read(root_ / folder / "batch.json", messages_, valid_);
    return entry->second;
  }

  fs::path root_;
  std::string& messages_;
  bool valid_ = true;
  std::map<fs::path, std::optional<BatchFile>> files_;
};

// The solution of a scene by its name without extension; empty where there is none.
fs::path find_solution(const fs::path& folder, const std::string& scene) {
  std::error_code ignored;
  for (const char* extension :
       {".png", ".bmp", ".exr", ".tif", ".tiff", ".jpg", ".jpeg", ".tga", ".ppm", ".gif", ".hdr"}) {
    const fs::path file = (folder / scene).replace_extension(extension);
    if (fs::exists(file, ignored)) return file;
  }
  return {};
}

class Planner {
 public:
  explicit Planner(const BatchArguments& arguments) : arguments_(arguments) {}

  BatchPlan plan() {
    plan_.renderers = parse_renderers(arguments_.programs);
    if (!arguments_.solutions.empty() && !fs::is_directory(arguments_.solutions))
      throw BatchError(fmt::format("trace: error: '{}' is not a folder\n", arguments_.solutions));
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
    BatchFiles files(arguments_.folder, plan_.warnings);
    for (const std::string& scene : list_scenes(arguments_)) {
      if (const auto options = files.of(scene)) add(scene, *options);
    }
    if (!files.valid()) throw BatchError(plan_.warnings);
    set_tolerances();
    return std::move(plan_);
  }

 private:
  void add(const std::string& scene, const SceneOptions& own) {
    SceneOptions options = common_;
    options.add(own);
    Job job;
    job.name = scene;
    job.scene = (fs::path(arguments_.folder) / scene).string();
    job.options.depth = *options.depth;
    job.options.width = *options.width;
    for (const Settings& settings : options.settings) settings.apply(job.options);
    job.cube_map = options.cube_map.value_or("");
    job.limits = {std::chrono::duration<double>(*options.timeout),
                  static_cast<std::uint64_t>(options.memory.value_or(0) * (1 << 20))};
    if (!arguments_.solutions.empty()) job.solution = find_solution(arguments_.solutions, scene);
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
    const auto [other, is_new] = pictures_.emplace(job.picture, job.name);
    if (!is_new)
      throw BatchError(fmt::format("trace: error: '{}' and '{}' would both be drawn to '{}'\n", other->second,
                                   job.name, job.picture.string()));
  }

  const BatchArguments& arguments_;
  SceneOptions common_;
  BatchPlan plan_;
  std::map<fs::path, std::string> pictures_;
};

}  // namespace

BatchPlan plan_batch(const BatchArguments& arguments) {
  return Planner(arguments).plan();
}

}  // namespace trace
