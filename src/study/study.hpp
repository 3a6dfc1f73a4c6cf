// One scene over all settings: time, error, rays and memory of each.
#pragma once

#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "study/results.hpp"

namespace trace {

struct StudyScene {
  std::string name;  // as results call it
  std::string file;
  RenderOptions options;           // width, depth and switches
  bool fixed_depth = false;        // options.depth was asked for: nothing deeper counts as truth
  std::string cube_map;            // one of its faces; may be empty
  std::filesystem::path solution;  // empty: none
};

struct StudyOptions {
  std::vector<Axis> axes;
  int threads = 0;
  double seconds = 2;  // for measuring the times of one scene, beside one warming run of each setting
  int least_runs = 3, most_runs = 25;
  bool pictures =
      false;  // `pictures` is filled: of the converged picture, the front, and the chosen one's heat map
};

// What a scene cannot be studied for: the messages, complete with line ends.
struct StudyError : std::runtime_error {
  using runtime_error::runtime_error;
};

// Every setting is run once to warm up, which gives its picture and its counts; then all take turns, each
// round begun with another, until each time is known better than it differs from the next one's, or the
// seconds are over. A scene with anything that the course's language does not have has no axis of arithmetic.
// `warnings` gets what the scene is warned of. Throws StudyError.
SceneResult study_scene(const StudyScene& scene, const StudyOptions& options, NamedPictures& pictures,
                        std::string& warnings);

}  // namespace trace
