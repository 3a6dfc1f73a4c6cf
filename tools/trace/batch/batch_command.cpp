#include "tools/trace/batch/batch_command.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <csignal>

#include "batch/summary.hpp"
#include "batch/tables.hpp"
#include "report/html.hpp"
#include "tools/trace/batch/batch_jobs.hpp"
#include "tools/trace/batch/batch_progress.hpp"
#include "tools/trace/exit_status.hpp"
#include "tools/trace/report_info.hpp"
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

std::string summary_text(const Record& summary, const BatchRun& run, std::size_t jobs, bool compared) {
  const Record& counts = summary.at("counts");
  const auto count = [&](const char* name) { return counts.at(name).get<std::size_t>(); };
  std::string text = fmt::format("{} scene{} in {:.1f} s: {} rendered, {} failed", count("scenes"),
                                 count("scenes") == 1 ? "" : "s", summary.at("seconds").get<double>(),
                                 count("rendered"), count("failed"));
  if (run.resumed > 0) text += fmt::format(" ({} done before)", run.resumed);
  text += '\n';
  if (run.signal != 0)
    text +=
        fmt::format("interrupted, {} left; the same command goes on from here\n", jobs - run.records.size());
  std::string line;
  for (const auto& [verdict, number] : counts.items()) {
    if (verdict == "scenes" || verdict == "rendered" || verdict == "failed" || number == 0) continue;
    const std::string words = verdict == "not_compared" ? "without a solution" : verdict;
    line += fmt::format("{}{} {}", line.empty() ? "" : ", ", number.get<std::size_t>(), words);
  }
  if (compared && !line.empty()) text += line + "\n";
  return text;
}

// Everything that the results go to, opened before there are any.
struct Outputs {
  TextOutput results, csv, junit;

  explicit Outputs(const BatchArguments& arguments)
      : results((fs::path(arguments.output) / "results.json").string()),
        csv(arguments.csv),
        junit(arguments.junit) {
    const TextOutput report_can_be_written(arguments.report);
  }

  void write(const Record& report, const BatchArguments& arguments) {
    results.write(to_text(report, 1) + "\n");
    if (csv.wanted()) csv.write(batch_csv(report));
    if (junit.wanted()) junit.write(batch_junit(report));
    if (!arguments.report.empty()) write_html_report(report, arguments.report, {!arguments.link_pictures});
  }
};

int run(const BatchArguments& arguments) {
  const auto begin = std::chrono::steady_clock::now();
  BatchInfo info;
  info.started = time_text();
  info.title = title_text(arguments.folder);
  info.command = arguments.command;

  const SignalWatch signals;
  std::signal(SIGPIPE, SIG_IGN);  // whoever watched has gone: the results are still wanted
  BatchPlan plan = plan_batch(arguments);
  if (!arguments.quiet || plan.incomplete) print_errors(plan.warnings);
  for (Job& job : plan.jobs) {
    if (job.limits.memory_bytes == 0) job.limits.memory_bytes = fair_memory(arguments.workers);
  }
  for (const Renderer& renderer : plan.renderers) info.renderers.push_back(renderer.name);
  if (plan.jobs.empty()) {
    print_errors(fmt::format("trace: error: no scenes in '{}'\n", arguments.folder));
    return plan.incomplete ? batch_failed : batch_usage;
  }
  make_folders(plan.jobs, arguments);
  BatchRun done;
  Journal journal(fs::path(arguments.output) / "results.jsonl", arguments.fresh);
  Outputs outputs(arguments);
  {
    BatchProgress progress(BatchProgress::Style::of_standard_error(arguments.quiet),
                           plan.renderers.size() > 1);
    done = run_batch(plan.jobs, arguments.workers, journal, signals, progress);
  }
  info.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const Record report = summary(info, done);
  outputs.write(report, arguments);
  if (!arguments.quiet && arguments.csv != "-" && arguments.junit != "-") {
    write_standard_output(summary_text(report, done, plan.jobs.size(), !arguments.solutions.empty()));
    if (!arguments.report.empty()) write_standard_output(arguments.report + "\n");
  }
  if (done.signal != 0) return 128 + done.signal;
  return plan.incomplete ? batch_failed : batch_exit_status(report);
}

}  // namespace

int batch_command(int argc, const char* const* argv) {
  BatchArguments arguments;
  if (const auto status = parse_batch_arguments(argc, argv, arguments)) return *status;
  try {
    return run(arguments);
  } catch (const BatchError& e) {
    print_errors(e.what());
    return batch_usage;
  } catch (const fs::filesystem_error& e) {
    print_errors(fmt::format("trace: error: cannot make '{}': {}\n", e.path1().string(), e.code().message()));
  } catch (const std::exception& e) {
    print_errors(fmt::format("trace: error: {}\n", e.what()));
  }
  return batch_failed;
}

}  // namespace trace
