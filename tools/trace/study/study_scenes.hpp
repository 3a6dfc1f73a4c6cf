// From the command line of `trace study` to scenes: which, with what options, beside which solutions.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "study/study.hpp"
#include "tools/trace/study/study_arguments.hpp"

namespace trace {

// What makes a study impossible before it begins; the text is complete, with its line end.
struct StudyPlanError : std::runtime_error {
  using runtime_error::runtime_error;
};

struct StudyPlan {
  std::vector<StudyScene> scenes;  // in the order given, of a folder in that of their names
  std::string warnings;            // and errors of what is passed over
  bool incomplete = false;         // something was
};

// Reads settings and batch.json files, and the sizes of solutions. A scene of a folder is called by its path
// below it, where that is the only thing given; else as on the command line. Throws StudyPlanError.
StudyPlan plan_study(const StudyArguments& arguments);

}  // namespace trace
