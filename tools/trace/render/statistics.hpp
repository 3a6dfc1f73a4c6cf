// What `--stats` reports: what the scene holds, rays by kind, the time of each stage, and what was
// left out because the scene does not need it.
#pragma once

#include <array>
#include <chrono>
#include <string>

#include "loading/scene_loader.hpp"
#include "rendering/render.hpp"

namespace trace {

enum class Stage { start, load, build, render, write };

class Statistics {
 public:
  // Ends a stage: the time since the last call, or since construction, is that stage's.
  void lap(Stage stage);

  // Since construction.
  double seconds() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }

  // `load` are the parts of Stage::load.
  std::string report(const Scene& scene, const SceneTree& tree, InstructionSet set, const LoadTimes& load,
                     const Rendered& rendered) const;

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point begin_ = Clock::now(), last_ = begin_;
  std::array<double, 5> milliseconds_{};
};

}  // namespace trace
