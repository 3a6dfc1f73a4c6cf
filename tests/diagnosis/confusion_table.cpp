// Which diagnosis is given for which defect, over the course's scenes: the table of
// docs/results/diagnosis.md. Hidden: run trace_tests "[diagnosis-table]".
#include <catch2/catch.hpp>

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <map>

#include "comparison/diagnosis.hpp"
#include "comparison/diagnosis_edges.hpp"
#include "comparison/diagnosis_regions.hpp"
#include "comparison/diagnosis_signs.hpp"
#include "rendering/pixel.hpp"
#include "tests/diagnosis/defects.hpp"
#include "tests/support/picture_table.hpp"

namespace trace::test {
namespace {

std::string features(const Raster& reference, const Raster& test) {
  const auto pair = make_pair(reference, test);
  if (!pair || pair->differing.empty()) return "equal";
  const DifferenceSigns s = difference_signs(*pair);
  const auto regions = differing_regions(*pair);
  EdgeCounts o, in;
  double energy = 0;
  for (const auto& r : regions) {
    o += r.outline;
    in += r.inside;
    energy += r.energy;
  }
  std::string text = fmt::format(
      "n {} up {:.3f} down {:.3f} same {:.3f} ({}) dsame {:.3f} conc {:.3f}/0 lim 0 | out v {:.2f} a {:.2f} "
      "k {:.2f} s {:.2f} "
      "in {} v {:.2f} a {:.2f} k {:.2f} | {} regions",
      pair->differing.size(), s.brighter, s.darker, s.same_color, s.colored, s.difference_of_same_color,
      s.difference_of_one_color, o.share(o.vanished), o.share(o.appeared), o.share(o.kept), o.share(o.soft),
      in.total(), in.share(in.vanished), in.share(in.appeared), in.share(in.kept), regions.size());
  if (!regions.empty()) {
    const EdgeCounts& w = regions[0].outline;
    text += fmt::format(" worst {:.2f}: v {:.2f} a {:.2f} k {:.2f} s {:.2f}", regions[0].energy / energy,
                        w.share(w.vanished), w.share(w.appeared), w.share(w.kept), w.share(w.soft));
  }
  const EdgeSigns e = edge_signs(*pair);
  text +=
      fmt::format(" eo={:.3f} et={:.3f} ep={:.3f} en={} darkT={:.3f} darkR={:.3f} U={:.3f}", e.outside,
                  e.thick, e.parts, e.pixels, s.black_in_test, s.black_in_reference, lit_and_equal(*pair));
  const auto merged = differing_regions(*pair);
  double e2 = 0;
  for (const auto& r : merged) e2 += r.energy;
  if (!merged.empty())
    text += fmt::format(" mr={} mw={:.3f} ma={:.3f}", merged.size(), merged[0].energy / e2,
                        static_cast<double>(merged[0].box.pixels) / (pair->width * pair->height));
  return text;
}

bool differs(const Raster& reference, const Raster& test) {
  return make_pair(reference, test)->differing.size() >= least_pixels_to_judge;
}

// The object whose absence changes between 0.3 % and 20 % of the picture, the most of them.
std::optional<std::size_t> suitable_object(const Scene& scene, const Way& way, const Raster& right) {
  std::optional<std::size_t> best;
  std::size_t most = 0;
  for (std::size_t i = 0; i < std::min<std::size_t>(scene.objects.size(), 10); ++i) {
    const auto pair = make_pair(right, picture(without_object(scene, i), way));
    const std::size_t n = pair->differing.size();
    if (n * 5 < pair->differs.size() && n * 300 > pair->differs.size() && n > most) {
      most = n;
      best = i;
    }
  }
  return best;
}

}  // namespace

TEST_CASE("confusion of defects and diagnoses over the course's scenes", "[.][diagnosis-table]") {
  const char* place = std::getenv("TRACE_CORPUS");
  const std::filesystem::path corpus =
      place ? place : std::filesystem::path(TRACE_SOURCE_DIR) / "../shared/corpus";
  const bool verbose = std::getenv("TRACE_VERBOSE") != nullptr;
  std::map<std::string, std::map<std::string, int>> table;
  std::vector<std::string> order;
  double seconds = 0, worst = 0;
  int runs = 0, scenes = 0;
  std::optional<Raster> previous;
  for (const auto& row : read_table(corpus / "manifest.tsv")) {
    // The course's and HKUST's; those without a mesh that takes minutes. Of our own scenes, all.
    if (row.size() > 5) {
      if (row[2] == "-" || row[1] != "-r 5 -w 512" || std::atoi(row[5].c_str()) > 20000) continue;
      if (row[0].find("utexas") == std::string::npos && row[0].find("hkust") == std::string::npos) continue;
    }
    if (const char* only = std::getenv("TRACE_ONLY"); only && row[0].find(only) == std::string::npos)
      continue;
    const Scene scene = scene_of((corpus / row[0]).string());
    if (scene.objects.empty()) continue;
    ++scenes;
    Way right;
    right.options.width = 256;
    const Raster reference = picture(scene, right);
    const auto run = [&](const std::string& defect, const Raster& test) {
      if (table.find(defect) == table.end()) order.push_back(defect);
      const auto begin = std::chrono::steady_clock::now();
      const auto diagnosis = diagnose(reference, test, {});
      const double took = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
      seconds += took;
      worst = std::max(worst, took);
      ++runs;
      std::string said = diagnosis ? std::string(name(diagnosis->kind)) : "-";
      const auto pair = make_pair(reference, test);
      if (pair->differing.size() < least_pixels_to_judge) said = "(equal)";
      ++table[defect][said];
      if (verbose && said != "(equal)")
        std::cout << "@ " << defect << " | " << row[0] << " | " << said << " | "
                  << (diagnosis ? diagnosis->text : "") << " | " << features(reference, test) << "\n";
    };
    const auto way = [&](const std::function<void(Way&)>& change) {
      Way changed = right;
      change(changed);
      return picture(scene, changed);
    };
    run("shift by (1, 0)", way([](Way& w) { w.shift_x = -1; }));
    run("shift by (-2, 1)", way([](Way& w) { w.shift_x = 2, w.shift_y = -1; }));
    run("flip left-right", flipped(reference, true, false));
    run("flip upside down", flipped(reference, false, true));
    run("rotate 180", flipped(reference, true, true));
    run("channels BGR", channels_swapped(reference));
    run("gamma 2.2 applied",
        way([](Way& w) { w.tone = [](double v) { return std::pow(clamped(v), 1 / 2.2); }; }));
    run("gamma 2.2 removed", toned(reference, [](double v) { return std::pow(v, 2.2); }));
    run("lights x 0.5", picture(lights_scaled(scene, 0.5), right));
    run("lights x 1.5", picture(lights_scaled(scene, 1.5), right));
    run("bytes x 0.7", toned(reference, [](double v) { return v * 0.7; }));
    run("wrap around", way([](Way& w) { w.wrap = true; }));
    run("black", toned(reference, [](double) { return 0; }));
    run("half a pixel", way([](Way& w) { w.shift_x = w.shift_y = 0.5; }));
    run("antialiased", way([](Way& w) {
          w.options.antialiasing.enabled = true;
          w.options.antialiasing.threshold = 50;
        }));
    run("shadows off", way([](Way& w) { w.options.shading.shadows = false; }));
    run("depth 0", way([](Way& w) { w.options.depth = 0; }));
    run("no reflection",
        picture(changed_materials(scene, [](Material& m) { m.reflective = Rgb(0); }), right));
    run("no refraction",
        picture(changed_materials(scene, [](Material& m) { m.transmissive = Rgb(0); }), right));
    run("no specular", picture(changed_materials(scene, [](Material& m) { m.specular = Rgb(0); }), right));
    run("no diffuse", picture(changed_materials(scene, [](Material& m) { m.diffuse = Rgb(0); }), right));
    run("ambient x 0", picture(ambient_scaled(scene, 0), right));
    run("ambient x 2", picture(ambient_scaled(scene, 2), right));
    if (scene.lights.size() > 1) run("a light missing", picture(without_light(scene, 0), right));
    run("shininess / 4", picture(changed_materials(scene, [](Material& m) { m.shininess *= 0.25; }), right));
    run("flat shading", way([](Way& w) { w.options.shading.smooth_shading = false; }));
    Scene zoomed = scene;
    zoomed.camera.window_height *= 1.1;
    run("field of view x 1.1", picture(zoomed, right));
    run("noise of 8 levels", noisy(reference, 8, 1));
    run("noise of 2 levels", noisy(reference, 2, 1));
    // Two defects at once, where each of them shows.
    const auto both = [&](const std::string& defects, const Raster& first, const Raster& second,
                          const Raster& both_of_them) {
      if (differs(reference, first) && differs(reference, second)) run(defects, both_of_them);
    };
    Way no_shadows = right;
    no_shadows.options.shading.shadows = false;
    const Raster shadowless = picture(scene, no_shadows);
    const Raster moved = way([](Way& w) { w.shift_x = 1; });
    const auto root = [](double v) { return std::sqrt(v); };
    both("shift by (-1, 0) and gamma 2", moved, toned(reference, root), toned(moved, root));
    both("shift by (-1, 0) and shadows off", moved, shadowless, [&] {
      Way w = no_shadows;
      w.shift_x = 1;
      return picture(scene, w);
    }());
    both("shadows off and lights x 0.8", shadowless, picture(lights_scaled(scene, 0.8), right),
         picture(lights_scaled(scene, 0.8), no_shadows));
    both("flip left-right and BGR", flipped(reference, true, false), channels_swapped(reference),
         channels_swapped(flipped(reference, true, false)));
    const auto no_specular = [](Material& m) { m.specular = Rgb(0); };
    const auto no_mirror = [](Material& m) { m.reflective = Rgb(0); };
    both("no specular and no reflection", picture(changed_materials(scene, no_specular), right),
         picture(changed_materials(scene, no_mirror), right),
         picture(changed_materials(changed_materials(scene, no_specular), no_mirror), right));
    if (previous && previous->height == reference.height) run("another scene", *previous);
    previous = reference;
    if (const auto object = suitable_object(scene, right, reference)) {
      run("object removed", picture(without_object(scene, *object), right));
      run("object moved", picture(moved_object(scene, *object, Vec3(0.4, 0.3, 0)), right));
      run("object moved a little", picture(moved_object(scene, *object, Vec3(0.08, 0, 0)), right));
      run("object recoloured", picture(recolored_object(scene, *object), right));
      both("object removed and shadows off", picture(without_object(scene, *object), right), shadowless,
           picture(without_object(scene, *object), no_shadows));
    }
  }
  std::cout << fmt::format("{} scenes, {} pairs; {:.1f} ms a pair in the mean, {:.1f} at most\n\n", scenes,
                           runs, 1000 * seconds / runs, 1000 * worst);
  for (const std::string& defect : order) {
    std::cout << "| " << defect << " |";
    for (const auto& [said, count] : table[defect]) std::cout << " " << said << " " << count;
    std::cout << " |\n";
  }
}

}  // namespace trace::test
