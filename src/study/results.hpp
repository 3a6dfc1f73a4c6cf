// What a study found. Times in milliseconds, errors in levels.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "report/study_html.hpp"
#include "shading/ray_counts.hpp"
#include "study/picture_error.hpp"
#include "study/setting.hpp"
#include "study/timing.hpp"

namespace trace {

struct SolutionError {
  double root_mean_square = 0;
  double percent_over_one = 0;  // of pixels off by more than a level
};

struct SettingResult {
  Setting setting;
  MedianTime time;
  PictureError error;  // against the converged picture; on the axis of arithmetic against extended precision
  double uncertainty = 0;  // of its RMSE: at most so much more or less, by the triangle inequality
  std::optional<SolutionError> solution;
  RayCounts rays;
  std::uint64_t memory = 0;          // bytes resident at most, the scene's among them
  bool front = false;                // no setting is better in both time and error
  std::optional<bool> same_picture;  // on the axis of needs: as the base setting's, byte for byte
  std::string picture, heat_map;     // names; empty where there is none
};

struct ConvergedText {
  int samples = 0, depth = 0;
  double error = 0, seconds = 0, unsettled = 0;  // as in converged.hpp
  std::string picture;
};

struct SceneResult {
  std::string scene;
  int width = 0, height = 0, depth = 0;
  ConvergedText converged;
  std::string solution;  // file; empty where there is none
  std::vector<SettingResult> settings;
  std::size_t chosen = 0;  // whose heat map is drawn
};

}  // namespace trace
