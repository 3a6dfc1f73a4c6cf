// The verdict on a pair of picture files.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "comparison/diagnosis/diagnosis.hpp"
#include "comparison/measure.hpp"

namespace trace {

// What may differ. What is absent is not looked at.
struct Tolerance {
  std::optional<double> rmse = 0.5;    // levels
  std::optional<double> max;           // levels
  std::optional<double> pixels = 0.1;  // per cent of pixels that may be off by more than `over`
  double over = 1;                     // levels
  std::optional<double> ssim;          // at least
  std::optional<double> flip;          // at most
};

enum class Verdict {
  identical,
  within,
  beyond,
  not_finite,  // NaN or infinity in either
  size_differs,
  channels_differ,
  unreadable,  // either
  missing,     // the test picture
  extra        // the reference
};

std::string_view name(Verdict verdict);  // "size-differs"

// 0 identical and within, 1 beyond and not_finite, 2 size_differs and channels_differ, 3 the rest.
int exit_status(Verdict verdict);

struct Judgement {
  Verdict verdict = Verdict::identical;
  std::string reason;  // why it is not within tolerance: "RMSE 3.20 is over 0.5"; empty where it is
  Tolerance tolerance;
  std::optional<Measurements> measurements;  // where both could be read and are of one size
  std::optional<Diagnosis> diagnosis;        // where it is beyond tolerance and clear
};

struct JudgeOptions {
  Tolerance tolerance;
  bool perceptual = true;          // SSIM and FLIP even where no tolerance asks for them
  std::filesystem::path heat_map;  // written where the pictures differ and this is not empty
  double amplify = 1;              // of the heat map
  unsigned threads = 2;            // at most; the judgement is the same for any number
};

// Files with the same bytes are decoded once. Never throws for what is wrong with the two files. Throws
// ImageError where the heat map cannot be written.
Judgement judge(const std::filesystem::path& reference, const std::filesystem::path& test,
                const JudgeOptions& options = {});

}  // namespace trace
