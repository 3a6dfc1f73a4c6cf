#include "tools/trace/batch/batch_command.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>

#include "batch/summary.hpp"
#include "batch/tables.hpp"
#include "report/html.hpp"
#include "tools/trace/batch/batch_jobs.hpp"
#include "tools/trace/batch/batch_progress.hpp"
#include "tools/trace/exit_status.hpp"
#include "tools/trace/text_output.hpp"

namespace trace {
namespace {

namespace fs = std::filesystem;

// Each worker may use as much of three quarters of the machine as the others.
std::uint64_t fair_memory(int workers) {
  const auto machine =
      static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
  return machine / 4 * 3 / static_cast<std::uint64_t>(workers);
}

void make_folders(const std::vector<Job>& jobs, const BatchArguments& arguments) {
  fs::create_directories(arguments.output);
  for (const Job& job : jobs) fs::create_directories(job.picture.parent_path());
  if (!arguments.report.empty() && fs::path(arguments.report).has_parent_path())
    fs::create_directories(fs::path(arguments.report).parent_path());
}

void print_summary(const Record& summary, const BatchRun& run, bool compared) {
  const Record& counts = summary.at("counts");
  const auto count = [&](const char* name) { return counts.at(name).get<std::size_t>(); };
  fmt::print("{} scene{} in {:.1f} s: {} rendered, {} failed", count("scenes"),
             count("scenes") == 1 ? "" : "s", summary.at("seconds").get<double>(), count("rendered"),
             count("failed"));
  if (run.resumed > 0) fmt::print(" ({} done before)", run.resumed);
  fmt::print("\n");
  if (run.signal != 0) fmt::print("interrupted; the same command goes on from here\n");
  if (!compared) return;
  std::string line;
  for (const auto& [verdict, number] : counts.items()) {
    if (verdict == "scenes" || verdict == "rendered" || verdict == "failed" || number == 0) continue;
    std::string words = verdict == "not_compared" ? "without a solution" : verdict;
    line += fmt::format("{}{} {}", line.empty() ? "" : ", ", number.get<std::size_t>(), words);
  }
  if (!line.empty()) fmt::print("{}\n", line);
}

int run(const BatchArguments& arguments) {
  const auto begin = std::chrono::steady_clock::now();
  BatchInfo info;
  info.started = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
  info.title =
      fs::absolute(arguments.folder / fs::path(".")).lexically_normal().parent_path().filename().string();
  info.command = arguments.command;

  BatchPlan plan = plan_batch(arguments);
  if (!arguments.quiet) fmt::print(stderr, "{}", plan.warnings);
  for (Job& job : plan.jobs) {
    if (job.limits.memory_bytes == 0) job.limits.memory_bytes = fair_memory(arguments.workers);
  }
  for (const Renderer& renderer : plan.renderers) info.renderers.push_back(renderer.name);
  if (plan.jobs.empty()) {
    fmt::print(stderr, "trace: error: no scenes in '{}'\n", arguments.folder);
    return batch_usage;
  }
  make_folders(plan.jobs, arguments);
  const std::string results = (fs::path(arguments.output) / "results.json").string();
  if (arguments.fresh) fs::remove(fs::path(arguments.output) / "results.jsonl");

  BatchRun done;
  {
    Journal journal(fs::path(arguments.output) / "results.jsonl");
    BatchProgress progress(BatchProgress::Style::of_standard_error(arguments.quiet),
                           plan.renderers.size() > 1);
    done = run_batch(plan.jobs, arguments.workers, journal, progress);
  }
  info.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const Record report = summary(info, done);
  TextOutput(results).write(report.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
  if (!arguments.csv.empty()) TextOutput(arguments.csv).write(batch_csv(report));
  if (!arguments.junit.empty()) TextOutput(arguments.junit).write(batch_junit(report));
  if (!arguments.report.empty()) write_html_report(report, arguments.report, {!arguments.link_pictures});
  if (!arguments.quiet) {
    print_summary(report, done, !arguments.solutions.empty());
    if (!arguments.report.empty()) fmt::print("{}\n", arguments.report);
  }
  if (done.signal != 0) return 128 + done.signal;
  return batch_exit_status(report);
}

}  // namespace

int batch_command(int argc, const char* const* argv) {
  BatchArguments arguments;
  if (const auto status = parse_batch_arguments(argc, argv, arguments)) return *status;
  try {
    return run(arguments);
  } catch (const BatchError& e) {
    fmt::print(stderr, "{}", e.what());
    return batch_usage;
  } catch (const JournalError& e) {
    fmt::print(stderr, "trace: error: {}\n", e.what());
  } catch (const fs::filesystem_error& e) {
    fmt::print(stderr, "trace: error: cannot make '{}': {}\n", e.path1().string(), e.code().message());
  } catch (const ImageError& e) {
    fmt::print(stderr, "trace: error: {}\n", e.what());
  }
  return batch_failed;
}

}  // namespace trace
