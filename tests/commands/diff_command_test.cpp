// `trace diff` of two pictures: verdicts, exit statuses, what is printed.
#include <catch2/catch.hpp>
#include <limits>

#include "tests/commands/diff_desk.hpp"
#include "tests/commands/exr_file.hpp"

namespace trace::test {

TEST_CASE("identical pictures: status 0") {
  const DiffDesk desk;
  desk.put("a.png", 100);
  desk.put("b.bmp", 100);
  const Outcome outcome = desk.diff("a.png b.bmp");
  CHECK(outcome.status == 0);
  CHECK(outcome.output == "identical\n8 x 8 pixels, 3 channels\n");
  CHECK(outcome.errors.empty());
}

TEST_CASE("one level in one pixel is within the default tolerance, and told") {
  const DiffDesk desk;
  desk.put("a.png", 100);
  desk.put("b.png", 100, 101, 8, 8);
  const Outcome outcome = desk.diff("a.png b.png --metrics basic");
  CHECK(outcome.status == 0);
  CHECK(outcome.output ==
        "within tolerance\n"
        "8 x 8 pixels, 3 channels\n"
        "in levels              all       red     green      blue\n"
        "RMSE               0.07217     0.125         0         0\n"
        "mean absolute     0.005208   0.01562         0         0\n"
        "mean signed       0.005208   0.01562         0         0\n"
        "largest                  1         1         0         0\n"
        "PSNR in dB           70.96     66.19       inf       inf\n"
        "largest at        (2, 3), red: 101 instead of 100\n"
        "pixels            1.562 % differ, 0 % by more than 1 level\n"
        "percentiles       50: 0  90: 0  99: 1  99.9: 1\n"
        "foreground        1 pixel, RMSE 0.5774, 0 % by more than 1 level\n"
        "edge-tolerant     RMSE 0.125, largest 1, 0 % by more than 1 level\n");
}

TEST_CASE("a tolerance on the command line replaces the default ones") {
  const DiffDesk desk;
  desk.put("a.png", 100);
  desk.put("b.png", 100, 101, 8, 8);
  desk.put("c.png", 100, 180, 8, 8);
  CHECK(desk.diff("a.png b.png --max 1").status == 0);
  const Outcome exact = desk.diff("a.png b.png --max 0");
  CHECK(exact.status == 1);
  CHECK_THAT(exact.output, Catch::StartsWith("beyond tolerance: "));
  CHECK(desk.diff("a.png c.png").status == 1);
  CHECK(desk.diff("a.png c.png --max 80").status == 0);
  CHECK(desk.diff("a.png c.png --rmse 10").status == 0);
  CHECK(desk.diff("a.png c.png --rmse 10 --max 79").status == 1);
  CHECK(desk.diff("a.png c.png --pixels 1.6").status == 0);
  CHECK(desk.diff("a.png c.png --pixels 1.5").status == 1);
  CHECK(desk.diff("a.png c.png --pixels 1.5 --over 80").status == 0);
  CHECK(desk.diff("a.png c.png --ssim 0.999").status == 1);
  CHECK(desk.diff("a.png c.png --ssim 0.1").status == 0);
  CHECK(desk.diff("a.png c.png --flip 0.00001").status == 1);
  CHECK(desk.diff("a.png c.png --flip 0.5 --metrics basic").status == 0);
}

TEST_CASE("black against white is beyond tolerance by 255 levels: status 1") {
  const DiffDesk desk;
  desk.put("black.png", 0);
  desk.put("white.png", 255);
  const Outcome outcome = desk.diff("black.png white.png --metrics basic");
  CHECK(outcome.status == 1);
  CHECK_THAT(outcome.output,
             Catch::StartsWith("beyond tolerance: RMSE 255 is over 0.5") &&
                 Catch::Contains("\nRMSE                   255       255       255       255\n") &&
                 Catch::Contains("\nmean signed            255       255       255       255\n") &&
                 Catch::Contains("\nlargest at        (0, 0), red: 255 instead of 0\n") &&
                 Catch::Contains("\npixels            100 % differ, 100 % by more than 1 level\n"));
  CHECK(desk.diff("white.png black.png").status == 1);
}

TEST_CASE("a NaN pixel is a verdict of its own, whatever the tolerance: status 1") {
  const DiffDesk desk;
  std::vector<float> samples(4 * 4 * 3, 0.5f);
  write_exr(desk / "a.exr", 4, 4, samples);
  samples[(2 * 4 + 1) * 3] = std::numeric_limits<float>::quiet_NaN();
  write_exr(desk / "nan.exr", 4, 4, samples);
  const Outcome outcome = desk.diff("a.exr nan.exr --max 1000");
  CHECK(outcome.status == 1);
  CHECK(outcome.output ==
        "not finite: 1 sample of the test picture is NaN or infinite, first at pixel (1, 2)\n"
        "4 x 4 pixels, 3 channels\n");
  CHECK(desk.diff("nan.exr a.exr").status == 1);
  CHECK(desk.diff("nan.exr nan.exr").status == 1);
  CHECK(desk.diff("a.exr a.exr").status == 0);
}

TEST_CASE("different sizes and numbers of channels: status 2") {
  const DiffDesk desk;
  desk.put("a.png", 0, 8, 8);
  desk.put("b.png", 0, 8, 6);
  const Outcome outcome = desk.diff("a.png b.png");
  CHECK(outcome.status == 2);
  CHECK(outcome.output == "size differs: 8 x 8 against 8 x 6\n");
  std::string zeros;
  for (int i = 0; i < 64; ++i) zeros += "0 ";
  write_text(desk / "gray.pgm", "P2\n8 8\n255\n" + zeros + "\n");
  const Outcome channels = desk.diff("a.png gray.pgm");
  CHECK(channels.status == 2);
  CHECK(channels.output == "channels differ: 3 against 1\n");
}

TEST_CASE("a picture that is missing or cannot be read: status 3") {
  const DiffDesk desk;
  desk.put("a.png", 0);
  write_text(desk / "broken.png", read_text(desk / "a.png").substr(0, 50));
  write_text(desk / "text.png", "no picture");
  const Outcome missing = desk.diff("a.png nothing.png");
  CHECK(missing.status == 3);
  CHECK(missing.output == "missing: the test picture is missing: nothing.png\n");
  const Outcome extra = desk.diff("nothing.png a.png");
  CHECK(extra.status == 3);
  CHECK(extra.output == "extra: the reference is missing: nothing.png\n");
  for (const std::string file : {"broken.png", "text.png"}) {
    const Outcome unreadable = desk.diff("a.png " + file);
    CHECK(unreadable.status == 3);
    CHECK_THAT(unreadable.output,
               Catch::StartsWith("unreadable: cannot read the test picture " + file + ": "));
  }
}

TEST_CASE("quiet prints nothing; the status tells") {
  const DiffDesk desk;
  desk.put("a.png", 0);
  desk.put("b.png", 9);
  const Outcome outcome = desk.diff("-q a.png b.png");
  CHECK(outcome.status == 1);
  CHECK(outcome.output.empty());
  CHECK(outcome.errors.empty());
}

TEST_CASE("without a terminal there is no colour") {
  const DiffDesk desk;
  desk.put("a.png", 0);
  desk.put("b.png", 9);
  CHECK_THAT(desk.diff("a.png b.png").output, !Catch::Contains("\033"));
}

}  // namespace trace::test
