// From the command line of `trace batch` to jobs: which scenes, drawn how by whom, compared with what.
#pragma once

#include <stdexcept>
#include <vector>

#include "batch/job.hpp"
#include "tools/trace/batch/batch_arguments.hpp"

namespace trace {

// What makes a batch impossible before it begins; the text is complete, with its line end.
struct BatchError : std::runtime_error {
  using runtime_error::runtime_error;
};

struct BatchPlan {
  std::vector<Renderer> renderers;
  std::vector<Job> jobs;    // scene by scene, in order of their names
  std::string warnings;     // and errors of what is passed over
  bool incomplete = false;  // something was
};

// Reads settings, batch.json files and tolerances. Throws BatchError.
BatchPlan plan_batch(const BatchArguments& arguments);

}  // namespace trace
