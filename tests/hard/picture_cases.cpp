#include "tests/hard/picture_cases.hpp"

#include <cmath>

#include "tests/metamorphic/retold.hpp"
#include "tests/metamorphic/scenes.hpp"

namespace trace::hard {
namespace {

using test::Retelling;
using test::SceneText;

// A retelling, and the share of pixels that may be off by more than one level.
struct Told {
  Retelling retelling;
  double allowed;
};

Told told(const std::string& name, Retelling retelling, double allowed) {
  retelling.name = name;
  return {retelling, allowed};
}

std::string in_words(double value) {
  char text[24];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

// Pixels off beyond what is allowed are wrong answers; how many are off at all is in the workload's name.
std::vector<Row> compared(const std::vector<SceneText>& scenes, const std::vector<Told>& tellings,
                          std::uint64_t pixels) {
  const auto pictures = static_cast<double>(scenes.size() * tellings.size());
  const int width = std::max(16, static_cast<int>(std::sqrt(static_cast<double>(pixels) / pictures)));
  std::vector<Image> plain;
  for (const SceneText& scene : scenes) plain.push_back(test::picture(scene, {}, width));
  std::vector<Row> rows;
  for (const Told& telling : tellings) {
    Row row(ours);
    Digest digest;
    std::uint64_t off = 0;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      const Image retold = test::picture(scenes[i], telling.retelling, width);
      const test::Off difference = test::compare(plain[i], retold, telling.retelling.mirrored);
      row.rays += difference.pixels;
      off += difference.off;
      for (const std::uint8_t byte : retold.rgb) digest.add(std::uint64_t{byte});
    }
    const auto allowed = static_cast<std::uint64_t>(telling.allowed * static_cast<double>(row.rays));
    row.wrong = off > allowed ? off - allowed : 0;
    row.digest = digest.value();
    row.workload = telling.retelling.name + ": " + std::to_string(off) + " pixels off";
    rows.push_back(row);
  }
  return rows;
}

// Coordinates of size m are rounded by m 2^-53. Up to 1e7 that is below 1e-9 of the scenes' size, and a
// pixel is 1e-2 of it: silhouettes move by 1e-7 pixels, and one pixel in a thousand is ample.
constexpr double few = 0.001;

std::vector<Row> moved_box(std::uint64_t pixels) {
  std::vector<Told> tellings;
  for (int power = 0; power <= 9; ++power) {
    const double m = std::pow(10.0, power);
    // At 1e9 a coordinate is rounded by 6e-8 to 1.2e-7, and points of contact with it.
    const double allowed = power <= 7 ? few : 0.005;
    tellings.push_back(told("moved by " + in_words(m), test::moved_by({m, -m, m}, false), allowed));
    tellings.push_back(told("points moved by " + in_words(m), test::moved_by({m, -m, m}, true), allowed));
  }
  return compared({test::box_scene()}, tellings, pixels);
}

std::vector<Row> retold(std::uint64_t pixels) {
  std::vector<Told> tellings;
  for (int power = 0; power <= 7; ++power) {
    const double m = std::pow(10.0, power);
    tellings.push_back(
        told("moved by " + in_words(m), test::moved_by({-m, 0.5 * m, m}, power % 2 == 1), few));
  }
  for (int power = -9; power <= 9; ++power) {
    const double factor = std::pow(10.0, power);
    // The language takes o + d into a space, which rounds the unit d by a part in 2^52 / |o|: beyond 1e6 that
    // is more than 1e-9, and grows to a ten thousandth of a pixel.
    const double allowed = power <= 6 ? few : 0.005;
    tellings.push_back(
        told("scaled by " + in_words(factor), test::scaled_by(factor, power % 2 != 0), allowed));
  }
  tellings.push_back(told("a quarter turn", test::turned_by(std::acos(0.0), {0, 1, 0}), few));
  tellings.push_back(told("turned by 1 about (1, 2, 3)", test::turned_by(1, {1, 2, 3}), few));
  for (int axis = 0; axis < 3; ++axis)
    tellings.push_back(told(std::string("mirrored along ") + "xyz"[axis], test::mirrored_along(axis), few));
  Retelling grouped, reversed, refaced;
  grouped.grouped = reversed.reversed = refaced.refaced = true;
  tellings.push_back(told("in groups", grouped, 0));
  tellings.push_back(told("in the opposite order", reversed, few));
  tellings.push_back(told("meshes refaced", refaced, few));
  return compared(test::scenes_to_retell(), tellings, pixels);
}

}  // namespace

HardCase moved_box_case() {
  return {
      10,
      "a room moved far away with its camera and light gives the same picture",
      "At 1e9 a coordinate has seven decimals left, and every hit is off by as much. Rays carry the error "
      "of their origin, so that surfaces neither shade themselves nor lose their contact shadows.",
      20 * 32 * 32,
      20 * 256 * 256,
      moved_box};
}

HardCase retold_case() {
  return {15,
          "a scene moved, scaled, turned, mirrored, regrouped, reordered or refaced gives the same picture",
          "The picture is a property of the scene and not of the words it is told in. Silhouettes may flip "
          "by rounding, so one pixel in a thousand may be off by more than one level.",
          35 * 5 * 24 * 24,
          35 * 5 * 128 * 128,
          retold};
}

void add_picture_cases(std::vector<HardCase>& cases) {
  cases.push_back(moved_box_case());
  cases.push_back(retold_case());
}

}  // namespace trace::hard
