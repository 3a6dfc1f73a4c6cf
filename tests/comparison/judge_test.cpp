#include "comparison/judge.hpp"

#include <catch2/catch.hpp>
#include <limits>

#include "rasters.hpp"
#include "tests/image/float_files.hpp"

using namespace trace;
using namespace trace::test;

namespace {

// Two files of a test's own and the judgement on them.
class Pair {
 public:
  Pair() = default;
  Pair(const Bytes& first, const Bytes& second, const std::string& extension = ".png")
      : reference(folder / ("a" + extension)), test(folder / ("b" + extension)) {
    put(reference, first);
    put(test, second);
  }
  Judgement judged(const JudgeOptions& options = {}) const { return judge(reference, test, options); }

  TemporaryFolder folder;
  std::filesystem::path reference = folder / "a.png", test = folder / "b.png";
};

// 8-bit gray, one row.
Bytes gray(const Bytes& levels) {
  return png_file(static_cast<std::uint32_t>(levels.size()), 1, 8, PngColour::gray, {}, Bytes{0} + levels);
}

JudgeOptions with(const Tolerance& tolerance) {
  JudgeOptions options;
  options.tolerance = tolerance;
  return options;
}

constexpr float nan_sample = std::numeric_limits<float>::quiet_NaN();

}  // namespace

TEST_CASE("identical pictures are identical, from equal files and from different ones") {
  const Judgement equal = Pair(gray({1, 2}), gray({1, 2})).judged();
  CHECK(equal.verdict == Verdict::identical);
  CHECK(equal.reason.empty());
  REQUIRE(equal.measurements);
  CHECK(equal.measurements->ssim == 1.0);
  const Bytes with_text = png_file(2, 1, 8, PngColour::gray, chunk("tEXt", {'a', 0, 'b'}), {0, 1, 2});
  const Judgement other = Pair(gray({1, 2}), with_text).judged();
  CHECK(other.verdict == Verdict::identical);
  CHECK(other.measurements->foreground.pixels == equal.measurements->foreground.pixels);
}

TEST_CASE("one level in one pixel of many is within the default tolerance") {
  Bytes reference(2000, 10), test = reference;
  test[7] = 11;
  const Judgement judgement = Pair(gray(reference), gray(test)).judged();
  CHECK(judgement.verdict == Verdict::within);
  CHECK(judgement.reason.empty());
  CHECK(judgement.measurements->error.largest == 1);
}

TEST_CASE("black against white is beyond tolerance, with all that is exceeded") {
  const Judgement judgement = Pair(gray({0, 0}), gray({255, 255})).judged();
  CHECK(judgement.verdict == Verdict::beyond);
  CHECK(judgement.reason ==
        "RMSE 255 is over 0.5; 100 % of the pixels are off by more than 1 level, which is over 0.1 %");
}

TEST_CASE("each tolerance is looked at where it is given, and told in its own words") {
  Bytes reference(100, 10), test = reference;
  test[3] = 15;
  const Pair pair(gray(reference), gray(test));
  const Tolerance none{{}, {}, {}, 1, {}, {}};
  CHECK(pair.judged(with(none)).verdict == Verdict::within);
  Tolerance rmse = none, max = none, pixels = none, ssim = none, flip = none;
  rmse.rmse = 0.25;
  CHECK(pair.judged(with(rmse)).reason == "RMSE 0.50 is over 0.25");
  rmse.rmse = 0.5;  // exactly
  CHECK(pair.judged(with(rmse)).verdict == Verdict::within);
  max.max = 4;
  CHECK(pair.judged(with(max)).reason == "largest difference 5 is over 4");
  max.max = 5;
  CHECK(pair.judged(with(max)).verdict == Verdict::within);
  pixels.pixels = 0.5;
  pixels.over = 2;
  CHECK(pair.judged(with(pixels)).reason ==
        "1 % of the pixels are off by more than 2 levels, which is over 0.5 %");
  pixels.over = 5;
  CHECK(pair.judged(with(pixels)).verdict == Verdict::within);
  ssim.ssim = 1;
  CHECK_THAT(pair.judged(with(ssim)).reason, Catch::Matches("SSIM 0\\.[0-9]+ is under 1"));
  flip.flip = 0;
  CHECK_THAT(pair.judged(with(flip)).reason, Catch::Matches("FLIP 0\\.0*[0-9]{1,2} is over 0"));
}

TEST_CASE("a figure just beyond its limit is told with as many decimals as show it") {
  Bytes reference(1000, 10), test = reference;
  for (std::size_t i = 0; i < 4; ++i) test[i] = 11;  // RMSE 0.0632456
  Tolerance tolerance;
  tolerance.rmse = 0.0632;
  CHECK(Pair(gray(reference), gray(test)).judged(with(tolerance)).reason == "RMSE 0.06325 is over 0.0632");
}

TEST_CASE("a tolerance of 0 passes only what is identical, also in floating point") {
  const Pair pair(exr_file(2, 1, {"Y"}, {0.5F, 0.5F}), exr_file(2, 1, {"Y"}, {0.5F, 0.5000001F}), ".exr");
  const Tolerance none{{}, {}, {}, 1, {}, {}};
  Tolerance max = none, pixels = none;
  max.max = 0;
  CHECK_THAT(pair.judged(with(max)).reason, Catch::Matches("largest difference 0\\.0000[0-9]+ is over 0"));
  pixels.pixels = 0;
  pixels.over = 0;
  CHECK_THAT(pair.judged(with(pixels)).reason,
             Catch::StartsWith("50 % of the pixels are off by more than 0"));
  CHECK(judge(pair.reference, pair.reference, with(max)).verdict == Verdict::identical);
  max.max = 0.001;
  CHECK(pair.judged(with(max)).verdict == Verdict::within);
}

TEST_CASE("a link that leads nowhere is unreadable, not missing") {
  const Pair pair(gray({1}), gray({1}));
  std::filesystem::create_symlink("nowhere.png", pair.folder / "broken.png");
  std::filesystem::create_symlink("loop.png", pair.folder / "loop.png");
  for (const char* name : {"broken.png", "loop.png"}) {
    const auto link = pair.folder / name;
    const Judgement judgement = judge(pair.reference, link);
    CHECK(judgement.verdict == Verdict::unreadable);
    CHECK_THAT(judgement.reason, Catch::StartsWith("cannot read the test picture " + link.string() + ": "));
    CHECK(judge(link, pair.test).verdict == Verdict::unreadable);
  }
}

TEST_CASE("different sizes are never compared") {
  const Judgement judgement = Pair(gray({1, 2}), gray({1, 2, 3})).judged();
  CHECK(judgement.verdict == Verdict::size_differs);
  CHECK(judgement.reason == "size differs: 2 x 1 against 3 x 1");
  CHECK_FALSE(judgement.measurements);
}

TEST_CASE("different channels are never compared") {
  const Judgement judgement = Pair(gray({7}), png_file(1, 1, 8, PngColour::rgb, {}, {0, 7, 7, 7})).judged();
  CHECK(judgement.verdict == Verdict::channels_differ);
  CHECK(judgement.reason == "channels differ: 1 against 3");
}

TEST_CASE("a missing picture is told from an extra one") {
  const Pair both(gray({1}), gray({1}));
  const auto nowhere = both.folder / "none.png", neither = both.folder / "nor.png";
  const Judgement missing = judge(both.reference, nowhere), extra = judge(nowhere, both.test);
  CHECK(missing.verdict == Verdict::missing);
  CHECK(missing.reason == "the test picture is missing: " + nowhere.string());
  CHECK(extra.verdict == Verdict::extra);
  CHECK(extra.reason == "the reference is missing: " + nowhere.string());
  const Judgement none = judge(nowhere, neither);
  CHECK(none.verdict == Verdict::missing);
  CHECK(none.reason == "both pictures are missing: " + nowhere.string() + " and " + neither.string());
}

TEST_CASE("a file that cannot be read is told with its name and why") {
  Bytes half = gray(Bytes(500, 3));
  half.resize(half.size() - 20);
  const Pair pair(gray({1}), half);
  CHECK(pair.judged().verdict == Verdict::unreadable);
  CHECK(pair.judged().reason ==
        "cannot read the test picture " + pair.test.string() + ": the PNG ends too early");
  const Pair nothing({}, {'x'});
  CHECK(nothing.judged().reason ==
        "cannot read the reference " + nothing.reference.string() +
            ": not a picture this program can read; cannot read the test picture " + nothing.test.string() +
            ": not a picture this program can read");
  const Pair same(half, half);
  CHECK(same.judged().verdict == Verdict::unreadable);
  CHECK(judge(pair.folder.path(), pair.reference).verdict == Verdict::unreadable);
}

TEST_CASE("a NaN pixel fails whatever the tolerance") {
  const Tolerance none{{}, {}, {}, 1, {}, {}};
  const Bytes good = exr_file(2, 1, {"Y"}, {0, 0.5F}), bad = exr_file(2, 1, {"Y"}, {0, nan_sample});
  const Judgement judgement = Pair(good, bad, ".exr").judged(with(none));
  CHECK(judgement.verdict == Verdict::not_finite);
  CHECK(judgement.reason == "1 sample of the test picture is NaN or infinite, first at pixel (1, 0)");
  CHECK(exit_status(judgement.verdict) == 1);
  CHECK(Pair(bad, good, ".exr").judged(with(none)).reason ==
        "1 sample of the reference is NaN or infinite, first at pixel (1, 0)");
}

TEST_CASE("NaN fails even between two equal files") {
  const Bytes bad = exr_file(1, 2, {"Y"}, {0, nan_sample});
  const Judgement judgement = Pair(bad, bad, ".exr").judged();
  CHECK(judgement.verdict == Verdict::not_finite);
  CHECK(judgement.reason ==
        "1 sample of the reference and 1 of the test picture are NaN or infinite, first at pixel (0, 1)");
}

TEST_CASE("infinity against infinity fails too") {
  const float infinite = std::numeric_limits<float>::infinity();
  const Bytes a = exr_file(1, 1, {"B", "G", "R"}, {infinite, 0, 0});
  const Bytes b = exr_file(1, 1, {"B", "G", "R"}, {infinite, -infinite, 0});
  CHECK(Pair(a, b, ".exr").judged().reason ==
        "1 sample of the reference and 2 of the test picture are NaN or infinite, first at pixel (0, 0)");
}

TEST_CASE("16 bits are compared in full") {
  const auto deep = [](std::uint8_t low) { return png_file(1, 1, 16, PngColour::gray, {}, {0, 0x40, low}); };
  CHECK(Pair(deep(1), deep(2)).judged().verdict == Verdict::within);
  Tolerance tolerance;
  tolerance.rmse = 0.001;
  CHECK(Pair(deep(1), deep(2)).judged(with(tolerance)).reason == "RMSE 0.0039 is over 0.001");
}

TEST_CASE("the heat map is written where the pictures differ and only there") {
  const Pair pair(gray(Bytes(20, 0)), gray(Bytes(20, 255)));
  JudgeOptions options;
  options.heat_map = pair.folder / "heat.png";
  judge(pair.reference, pair.reference, options);
  CHECK_FALSE(std::filesystem::exists(options.heat_map));
  pair.judged(options);
  CHECK(read_image(options.heat_map).width == 20);
  options.heat_map = pair.folder / "none/heat.png";
  CHECK(reason([&] { pair.judged(options); }) == "no such directory");
}

TEST_CASE("SSIM and FLIP are measured where they are wanted or a tolerance asks for them") {
  const Pair pair(gray(Bytes(20, 0)), gray(Bytes(20, 255)));
  JudgeOptions options;
  CHECK(pair.judged(options).measurements->flip);
  options.perceptual = false;
  CHECK_FALSE(pair.judged(options).measurements->flip);
  CHECK_FALSE(pair.judged(options).measurements->ssim);
  options.tolerance.flip = 0.5;
  CHECK(pair.judged(options).measurements->flip);
  CHECK_FALSE(pair.judged(options).measurements->ssim);
}

TEST_CASE("verdicts have names and exit statuses") {
  const std::vector<std::tuple<Verdict, std::string, int>> all{
      {Verdict::identical, "identical", 0},
      {Verdict::within, "within", 0},
      {Verdict::beyond, "beyond", 1},
      {Verdict::not_finite, "not-finite", 1},
      {Verdict::size_differs, "size-differs", 2},
      {Verdict::channels_differ, "channels-differ", 2},
      {Verdict::unreadable, "unreadable", 3},
      {Verdict::missing, "missing", 3},
      {Verdict::extra, "extra", 3}};
  for (const auto& [verdict, text, status] : all) {
    CHECK(name(verdict) == text);
    CHECK(exit_status(verdict) == status);
  }
}
