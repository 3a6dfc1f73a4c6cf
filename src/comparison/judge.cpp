#include "comparison/judge.hpp"

#include <fmt/format.h>

#include <array>
#include <new>
#include <utility>

#include "comparison/heat_map.hpp"
#include "comparison/reasons.hpp"
#include "comparison/same_bytes.hpp"
#include "parallel/parallel.hpp"

namespace trace {
namespace {

using Path = std::filesystem::path;

struct Loaded {
  std::optional<Raster> raster;
  std::string error;  // why there is none
};

Loaded load(const Path& file) {
  try {
    return {read_raster(file), {}};
  } catch (const ImageError& error) {
    return {{}, error.what()};
  } catch (const std::bad_alloc&) {
    return {{}, "out of memory"};
  }
}

// A link that leads nowhere, or a file in a folder that may not be searched, is there but cannot be read.
bool present(const Path& file) {
  std::error_code ignored;
  return std::filesystem::symlink_status(file, ignored).type() != std::filesystem::file_type::not_found;
}

class Judge {
 public:
  Judge(const Path& reference, const Path& test, const JudgeOptions& options)
      : reference_(reference), test_(test), options_(options) {
    judgement_.tolerance = options.tolerance;
  }

  Judgement judge() {
    if (!both_exist()) return std::move(judgement_);
    // One of two files with the same bytes is as good as the other.
    const bool same = same_bytes(reference_, test_);
    std::array<Loaded, 2> loaded;
    parallel_for(static_cast<int>(options_.threads), same ? 1 : 2,
                 [&](std::size_t i, int) { loaded[i] = load(i == 0 ? reference_ : test_); });
    const Loaded& second = same ? loaded[0] : loaded[1];
    if (both_readable(loaded[0], second)) compare(*loaded[0].raster, *second.raster);
    return std::move(judgement_);
  }

 private:
  void decide(Verdict verdict, std::string reason) {
    judgement_.verdict = verdict;
    judgement_.reason = std::move(reason);
  }

  bool both_exist() {
    const bool reference = present(reference_), test = present(test_);
    if (!reference && !test)
      decide(Verdict::missing,
             fmt::format("both pictures are missing: {} and {}", reference_.string(), test_.string()));
    else if (!test)
      decide(Verdict::missing, fmt::format("the test picture is missing: {}", test_.string()));
    else if (!reference)
      decide(Verdict::extra, fmt::format("the reference is missing: {}", reference_.string()));
    return reference && test;
  }

  bool both_readable(const Loaded& reference, const Loaded& test) {
    if (reference.raster && test.raster) return true;
    std::string reason;
    if (!reference.raster)
      reason = fmt::format("cannot read the reference {}: {}", reference_.string(), reference.error);
    if (!test.raster) {
      if (!reason.empty()) reason += "; ";
      reason += fmt::format("cannot read the test picture {}: {}", test_.string(), test.error);
    }
    decide(Verdict::unreadable, std::move(reason));
    return false;
  }

  void compare(const Raster& reference, const Raster& test) {
    if (reference.width != test.width || reference.height != test.height)
      return decide(Verdict::size_differs, size_reason(reference, test));
    if (reference.channels != test.channels)
      return decide(Verdict::channels_differ, channels_reason(reference, test));

    const Tolerance& tolerance = options_.tolerance;
    MeasureOptions measuring;
    measuring.threshold = tolerance.over;
    measuring.ssim = options_.perceptual || tolerance.ssim;
    measuring.flip = options_.perceptual || tolerance.flip;
    measuring.threads = options_.threads;
    judgement_.measurements = measure(reference, test, measuring);
    weigh(reference, test, *judgement_.measurements);
    if (!judgement_.measurements->identical() && !options_.heat_map.empty())
      write_image(options_.heat_map, heat_map(reference, test, options_.amplify));
  }

  void weigh(const Raster& reference, const Raster& test, const Measurements& measured) {
    if (measured.not_finite.reference + measured.not_finite.test > 0)
      return decide(Verdict::not_finite, not_finite_reason(measured.not_finite));
    if (measured.identical()) return decide(Verdict::identical, {});
    std::string reason = tolerance_reason(options_.tolerance, measured);
    if (reason.empty()) return decide(Verdict::within, {});
    decide(Verdict::beyond, std::move(reason));
    judgement_.diagnosis = diagnose(reference, test, measured);
  }

  const Path& reference_;
  const Path& test_;
  const JudgeOptions& options_;
  Judgement judgement_;
};

}  // namespace

Judgement judge(const Path& reference, const Path& test, const JudgeOptions& options) {
  return Judge(reference, test, options).judge();
}

}  // namespace trace
