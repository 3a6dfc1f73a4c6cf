#include "batch/run_job.hpp"

#include <fmt/format.h>

#include "batch/fingerprint.hpp"
#include "batch/foreign_renderer.hpp"
#include "batch/own_renderer.hpp"
#include "report/comparison_json.hpp"

namespace trace {
namespace {

void compare(const Job& job, Record& record) {
  record["heat"] = nullptr;
  record["comparison"] = nullptr;
  std::error_code ignored;
  if (!job.heat_map.empty()) std::filesystem::remove(job.heat_map, ignored);
  FileHashes files;
  record["judge_key"] = comparison_key(job, files);
  if (record["outcome"] != outcome::rendered || job.solution.empty()) return;
  JudgeOptions options;
  options.tolerance = job.tolerance;
  options.heat_map = job.heat_map;
  options.threads = 1;  // the others have jobs of their own
  try {
    record["comparison"] = comparison_json(judge(job.solution, job.picture, options));
  } catch (const ImageError& e) {
    record["message"] = fmt::format("{}trace: error: cannot write '{}': {}\n",
                                    record["message"].get<std::string>(), job.heat_map.string(), e.what());
  }
  if (!job.heat_map.empty() && std::filesystem::exists(job.heat_map, ignored))
    record["heat"] = job.heat_map.string();
}

}  // namespace

Record new_record(const Job& job) {
  return {{"scene", job.name},
          {"renderer", job.renderer.name},
          {"outcome", outcome::failed},
          {"message", ""},
          {"depth", job.options.depth},
          {"width", job.options.width},
          {"seconds", 0.0},
          {"cpu_seconds", 0.0},
          {"memory_mib", nullptr},
          {"rays", nullptr},
          {"picture", nullptr},
          {"solution", nullptr},
          {"heat", nullptr},
          {"comparison", nullptr}};
}

void place(const Job& job, Record& record) {
  const auto name = [](const std::filesystem::path& path) { return Record(path.string()); };
  record["picture"] = record["outcome"] == outcome::rendered ? name(job.picture) : Record();
  record["solution"] = job.solution.empty() ? Record() : name(job.solution);
  if (!record["heat"].is_null()) record["heat"] = name(job.heat_map);
}

Record run_job(const Job& job, const std::string& program, BlobExchange& exchange) {
  Record record = job.finished.is_null() ? new_record(job) : job.finished;
  if (job.finished.is_null()) {
    if (job.renderer.command.empty()) {
      draw(job, exchange, record);
    } else {
      draw_with_program(job, record);
    }
    record["key"] = picture_key(job, program);
    std::error_code ignored;
    if (record["outcome"] == outcome::rendered) {
      record["picture_hash"] = file_hash(job.picture).value_or("");
    } else {
      std::filesystem::remove(job.picture, ignored);
    }
  }
  place(job, record);
  compare(job, record);
  return record;
}

}  // namespace trace
