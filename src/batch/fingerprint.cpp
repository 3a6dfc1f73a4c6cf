#include "batch/fingerprint.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <cstdlib>

#include "scene/dialect_rules.hpp"

namespace trace {
namespace {

std::string text(const std::optional<double>& number) {
  return number ? fmt::format("{}", *number) : "-";
}

// Without what does not change the picture: threads, instruction set, ShadingOptions::model_everything.
std::string text(const RenderOptions& o) {
  return fmt::format("{} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {}", name_of(o.dialect),
                     o.permissive, o.width, o.depth, o.shading.shadows, o.shading.smooth_shading,
                     o.shading.backface_culling, o.shading.internal_reflection, o.shading.backface_specular,
                     o.shading.least_contribution, o.antialiasing.enabled, o.antialiasing.supersamples,
                     o.antialiasing.threshold, o.blocks.threshold, o.blocks.size, o.sampling.grid,
                     o.sampling.nine_points, o.sampling.threshold, o.sampling.most, o.shading.light_samples,
                     name_of(o.shading.transmissive_shadows));
}

bool inputs_are_current(const Record& record, FileHashes& files) {
  const auto inputs = record.find("inputs");
  if (inputs == record.end() || !inputs->is_array() || inputs->empty()) return false;
  for (const Record& input : *inputs) {
    const std::optional<std::string>& hash = files.of(input.at("path").get<std::string>());
    const Record& before = input.at("hash");
    if (hash ? before != *hash : !before.is_null()) return false;
  }
  return true;
}

std::string absolute_name(const std::filesystem::path& path) {
  return path.empty() ? "" : std::filesystem::absolute(path).lexically_normal().string();
}

}  // namespace

Record input(const std::filesystem::path& file, const std::optional<std::string>& hash) {
  return {{"path", absolute_name(file)}, {"hash", hash ? Record(*hash) : Record()}};
}

std::string picture_key(const Job& job, const std::string& program) {
  return content_hash(fmt::format("{}\n{}\n{}\n{}\n{}\n{}", absolute_name(job.scene),
                                  absolute_name(job.picture), absolute_name(job.cube_map), text(job.options),
                                  fmt::join(job.renderer.command, "\n"),
                                  job.renderer.command.empty() ? program : ""));
}

std::string comparison_key(const Job& job, const std::string& program, FileHashes& files) {
  if (job.solution.empty()) return "";
  const Tolerance& t = job.tolerance;
  return content_hash(fmt::format("{}\n{}\n{}\n{}\n{} {} {} {} {} {}", program, absolute_name(job.solution),
                                  files.of(job.solution).value_or(""), absolute_name(job.heat_map),
                                  text(t.rmse), text(t.max), text(t.pixels), t.over, text(t.ssim),
                                  text(t.flip)));
}

std::string own_program_hash() {
  return file_hash("/proc/self/exe").value_or("");
}

std::filesystem::path find_program(const std::string& name) {
  if (name.find('/') != std::string::npos) return name;
  const char* path = std::getenv("PATH");
  std::string_view places = path ? path : "/usr/bin:/bin";
  while (!places.empty()) {
    const std::size_t colon = places.find(':');
    const std::filesystem::path file = std::filesystem::path(places.substr(0, colon)) / name;
    if (access(file.c_str(), X_OK) == 0) return file;
    places = colon == places.npos ? "" : places.substr(colon + 1);
  }
  return {};
}

bool picture_is_current(const Record& record, const Job& job, const std::string& program, FileHashes& files) {
  try {
    return record.at("outcome") == "rendered" && record.at("key") == picture_key(job, program) &&
           inputs_are_current(record, files) &&
           record.at("picture_hash") == file_hash(job.picture).value_or("");
  } catch (const nlohmann::json::exception&) {
    return false;  // of another version of this program
  }
}

bool comparison_is_current(const Record& record, const Job& job, const std::string& program,
                           FileHashes& files) {
  const auto key = record.find("judge_key");
  if (key == record.end() || *key != comparison_key(job, program, files)) return false;
  const auto heat = record.find("heat");
  return heat == record.end() || heat->is_null() || std::filesystem::exists(job.heat_map);
}

}  // namespace trace
