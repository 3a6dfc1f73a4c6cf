#include "batch/run_job.hpp"

#include <fmt/format.h>

#include "batch/fingerprint.hpp"
#include "batch/foreign_renderer.hpp"
#include "batch/own_renderer.hpp"
#include "report/comparison_json.hpp"

namespace trace {
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

Record draw_job(const Job& job, const std::string& program, BlobExchange& exchange) {
  Record record = new_record(job);
  if (job.renderer.command.empty()) {
    draw(job, exchange, record);
  } else {
    try {
      draw_with_program(job, record);
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const std::exception& e) {  // ours: the program is not to blame
      record["outcome"] = outcome::failed;
      record["message"] = fmt::format("trace: error: {}\n", e.what());
    }
  }
  record["key"] = picture_key(job, program);
  record["drawing_message"] = record["message"];
  std::error_code ignored;
  if (record["outcome"] == outcome::rendered) {
    record["picture_hash"] = file_hash(job.picture).value_or("");
  } else if (job.has_old_picture) {
    std::filesystem::remove(job.picture, ignored);
  }
  if (!job.heat_map.empty()) std::filesystem::remove(job.heat_map, ignored);
  if (job.solution.empty()) record["judge_key"] = "";
  place(job, record);
  return record;
}

void compare_job(const Job& job, const std::string& program, Record& record) {
  record["heat"] = nullptr;
  record["comparison"] = nullptr;
  record["message"] = record.value("drawing_message", "");
  std::error_code ignored;
  if (!job.heat_map.empty()) std::filesystem::remove(job.heat_map, ignored);
  FileHashes files;
  record["judge_key"] = comparison_key(job, program, files);
  place(job, record);
  if (record["outcome"] != outcome::rendered || job.solution.empty()) return;
  JudgeOptions options;
  options.tolerance = job.tolerance;
  options.heat_map = job.heat_map;
  options.threads = 1;  // the others have jobs of their own
  try {
    record["comparison"] = comparison_json(judge(job.solution, job.picture, options));
    if (std::filesystem::exists(job.heat_map, ignored)) record["heat"] = job.heat_map.string();
  } catch (const ImageError& e) {
    options.heat_map.clear();
    record["comparison"] = comparison_json(judge(job.solution, job.picture, options));
    record["message"] = fmt::format("{}trace: error: cannot write '{}': {}\n",
                                    record["message"].get<std::string>(), job.heat_map.string(), e.what());
    record["judge_key"] = nullptr;  // the next run tries again
  }
  // It may have been for want of memory.
  if (record["comparison"].at("verdict") == name(Verdict::unreadable)) record["judge_key"] = nullptr;
}

}  // namespace trace
