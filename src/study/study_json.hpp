// The results of a study for programs: docs/schemas/study-1.schema.json.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "study/overall.hpp"
#include "study/results.hpp"

namespace trace {

// How the study came about.
struct StudyInfo {
  std::string title, command, started, program, processor, instruction_set;
  int threads = 1;
  double seconds = 0;
};

nlohmann::ordered_json study_json(const StudyInfo& info, std::span<const SceneResult> scenes,
                                  const Overall& all);

}  // namespace trace
