#include "tools/trace/study/study_command.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>

#include "batch/record.hpp"
#include "parallel/parallel.hpp"
#include "report/study_csv.hpp"
#include "report/study_html.hpp"
#include "report/study_svg.hpp"
#include "study/study_json.hpp"
#include "tools/trace/exit_status.hpp"
#include "tools/trace/report_info.hpp"
#include "tools/trace/study/study_scenes.hpp"
#include "tools/trace/study/study_text.hpp"
#include "tools/trace/text_output.hpp"
#include "tools/trace/version.hpp"

namespace trace {
namespace {

namespace fs = std::filesystem;

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != line.npos) return line.substr(colon + 2);
  }
  return "unknown";
}

// Everything that the results go to, opened before there are any.
struct StudyOutputs {
  TextOutput json, csv, svg;

  explicit StudyOutputs(const StudyArguments& arguments)
      : json(arguments.json), csv(arguments.csv), svg(arguments.svg) {
    const TextOutput report_can_be_written(arguments.report);
  }
  bool standard_output_taken() const {
    return json.is_standard_output() || csv.is_standard_output() || svg.is_standard_output();
  }
};

class StudyRun {
 public:
  explicit StudyRun(const StudyArguments& arguments) : arguments_(arguments), outputs_(arguments) {}

  int run() {
    const auto begin = std::chrono::steady_clock::now();
    StudyInfo info;
    info.started = time_text();
    const std::vector<std::string>& scenes = arguments_.scenes;
    info.title = scenes.size() > 1 ? fmt::format("{} scenes", scenes.size()) : title_text(scenes.front());
    info.command = arguments_.command;
    info.program = version_text;
    info.processor = processor_name();
    info.instruction_set = name_of(arguments_.options.instruction_set);
    info.threads = threads_or_all(arguments_.options.threads);

    const StudyPlan plan = plan_study(arguments_);
    if (!arguments_.quiet || plan.incomplete) print_errors(plan.warnings);
    incomplete_ = plan.incomplete;
    if (plan.scenes.empty()) {
      print_errors("trace: error: no scenes to study\n");
      return exit_bad_input;
    }
    for (std::size_t k = 0; k < plan.scenes.size(); ++k) study_one(plan.scenes[k], k, plan.scenes.size());
    if (results_.empty()) return exit_bad_input;

    info.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    write(info);
    return incomplete_ ? exit_bad_input : exit_done;
  }

 private:
  void study_one(const StudyScene& scene, std::size_t index, std::size_t count) {
    StudyOptions options;
    options.axes = arguments_.axes;
    options.threads = arguments_.options.threads;
    options.seconds = arguments_.seconds;
    options.pictures = !arguments_.report.empty();
    if (!arguments_.quiet) print_errors(fmt::format("[{}/{}] {}\n", index + 1, count, scene.name));
    std::string warnings;
    try {
      results_.push_back(study_scene(scene, options, pictures_, warnings));
      if (!outputs_.standard_output_taken()) write_standard_output(scene_text(results_.back()) + "\n");
    } catch (const StudyError& e) {
      warnings += e.what();
      incomplete_ = true;
      print_errors(warnings);
      return;
    }
    if (!arguments_.quiet) print_errors(warnings);
  }

  void write(const StudyInfo& info) {
    const Overall all = overall(results_);
    const nlohmann::ordered_json report = study_json(info, results_, all);
    if (outputs_.json.wanted()) outputs_.json.write(to_text(report, 1) + "\n");
    if (outputs_.csv.wanted()) outputs_.csv.write(study_csv(report));
    if (outputs_.svg.wanted()) outputs_.svg.write(study_svg(report));
    if (!arguments_.report.empty()) write_study_report(report, pictures_, arguments_.report);
    if (outputs_.standard_output_taken()) return;
    if (results_.size() > 1) write_standard_output(overall_text(all));
    if (!arguments_.report.empty()) write_standard_output(arguments_.report + "\n");
  }

  const StudyArguments& arguments_;
  StudyOutputs outputs_;
  std::vector<SceneResult> results_;
  NamedPictures pictures_;
  bool incomplete_ = false;
};

}  // namespace

int study_command(int argc, const char* const* argv) {
  StudyArguments arguments;
  if (const auto status = parse_study_arguments(argc, argv, arguments)) return *status;
  try {
    return StudyRun(arguments).run();
  } catch (const StudyPlanError& e) {
    print_errors(e.what());
    return exit_bad_input;
  } catch (const ImageError& e) {
    print_errors(fmt::format("trace: error: {}\n", e.what()));
    return exit_cannot_write;
  }
}

}  // namespace trace
