// Which diagnosis is given for which defect: the tables of docs/results/diagnosis.md. Hidden, as it takes
// minutes:
//   build/trace_tests "[diagnosis-table]"
// prints them for our own scenes and, where it is beside the project, for the corpus.
#include <catch2/catch.hpp>

#include <cmath>
#include <cstdlib>
#include <iostream>

#include "comparison/diagnosis/diagnosis_pair.hpp"
#include "rendering/pixel.hpp"
#include "tests/diagnosis/confusion.hpp"
#include "tests/diagnosis/defects.hpp"
#include "tests/support/picture_table.hpp"

namespace trace::test {
namespace {

// The object whose absence changes between 0.3 % and 20 % of the picture, the most of them; of the first ten.
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

// One scene with every defect.
class Defects {
 public:
  Defects(const Scene& scene, Confusion& confusion)
      : scene_(scene), confusion_(confusion), reference_(picture(scene, right_)) {}

  const Raster& reference() const { return reference_; }

  void sampling() const {
    record("shifted by (1, 0)", "shifted", seen([](Way& w) { w.shift_x = -1; }));
    record("shifted by (-2, 1)", "shifted", seen([](Way& w) { w.shift_x = 2, w.shift_y = -1; }));
    record("flipped left-right", "flipped", flipped(reference_, true, false));
    record("flipped upside down", "flipped", flipped(reference_, false, true));
    record("rotated by 180 degrees", "flipped", flipped(reference_, true, true));
    record("sampled half a pixel away", "edges", seen([](Way& w) { w.shift_x = w.shift_y = 0.5; }));
    record("antialiased", "edges", seen([](Way& w) {
             w.options.antialiasing.enabled = true;
             w.options.antialiasing.threshold = 50;
           }));
  }

  void tones() const {
    record("channels in the order BGR", "channels-swapped", channels_swapped(reference_));
    record("gamma 2.2 applied", "gamma",
           seen([](Way& w) { w.tone = [](double v) { return std::pow(clamped(v), 1 / 2.2); }; }));
    record("gamma 2.2 removed", "gamma", toned(reference_, [](double v) { return std::pow(v, 2.2); }));
    record("lights times 0.5", "brightness", with(lights_scaled(scene_, 0.5)));
    record("lights times 1.5", "brightness", with(lights_scaled(scene_, 1.5)));
    record("bytes times 0.7", "brightness", toned(reference_, [](double v) { return v * 0.7; }));
    record("bytes that wrap around", "wrapped", seen([](Way& w) { w.wrap = true; }));
    record("black", "blank", toned(reference_, [](double) { return 0; }));
  }

  void missing() const {
    record("shadows off", "shadows-missing", seen([](Way& w) { w.options.shading.shadows = false; }));
    record("depth 0", "reflection-missing", seen([](Way& w) { w.options.depth = 0; }));
    record("no reflection", "reflection-missing", material([](Material& m) { m.reflective = Rgb(0); }));
    record("no refraction", "reflection-missing", material([](Material& m) { m.transmissive = Rgb(0); }));
    record("no highlights", "specular-missing", material([](Material& m) { m.specular = Rgb(0); }));
    if (!object_) return;
    record("an object removed", "object-missing", with(without_object(scene_, *object_)));
    record("an object moved by a third of its size", "object-displaced",
           with(moved_object(scene_, *object_, Vec3(0.33, 0, 0))));
    record("an object moved by a twelfth of its size", "object-displaced",
           with(moved_object(scene_, *object_, Vec3(0.08, 0, 0))));
  }

  // What no diagnosis is meant for.
  void other() const {
    record("no diffuse light", "-", material([](Material& m) { m.diffuse = Rgb(0); }));
    record("ambient light times 0", "-", with(ambient_scaled(scene_, 0)));
    record("ambient light times 2", "-", with(ambient_scaled(scene_, 2)));
    record("shininess divided by 4", "-", material([](Material& m) { m.shininess *= 0.25; }));
    record("flat shading", "-", seen([](Way& w) { w.options.shading.smooth_shading = false; }));
    if (scene_.lights.size() > 1) record("one of the lights missing", "-", with(without_light(scene_, 0)));
    if (object_) record("an object of another colour", "-", with(recolored_object(scene_, *object_)));
    Scene zoomed = scene_;
    zoomed.camera.window_height *= 1.1;
    record("window 1.1 times as high", "-", with(zoomed));
    record("noise of 2 levels", "-", noisy(reference_, 2, 1));
    record("noise of 8 levels", "-", noisy(reference_, 8, 1));
  }

  // Two defects, where each of them shows.
  void two() const {
    const auto root = [](double v) { return std::sqrt(v); };
    const Raster moved = seen([](Way& w) { w.shift_x = 1; });
    Way no_shadows = right_;
    no_shadows.options.shading.shadows = false;
    const Raster shadowless = picture(scene_, no_shadows);
    Way moved_no_shadows = no_shadows;
    moved_no_shadows.shift_x = 1;
    both("shifted, and gamma 2 applied", moved, toned(reference_, root), toned(moved, root));
    both("shifted, and shadows off", moved, shadowless, picture(scene_, moved_no_shadows));
    both("shadows off, and lights times 0.8", shadowless, with(lights_scaled(scene_, 0.8)),
         picture(lights_scaled(scene_, 0.8), no_shadows));
    const Raster mirrored = flipped(reference_, true, false);
    both("flipped left-right, and BGR", mirrored, channels_swapped(reference_), channels_swapped(mirrored));
    both("no highlights, and no reflection", material([](Material& m) { m.specular = Rgb(0); }),
         material([](Material& m) { m.reflective = Rgb(0); }),
         material([](Material& m) { m.specular = m.reflective = Rgb(0); }));
    if (object_)
      both("an object removed, and shadows off", with(without_object(scene_, *object_)), shadowless,
           picture(without_object(scene_, *object_), no_shadows));
  }

  void record(const std::string& defect, const std::string& right, const Raster& test) const {
    confusion_.record(defect, right, reference_, test);
  }

 private:
  Raster seen(const std::function<void(Way&)>& change) const {
    Way way = right_;
    change(way);
    return picture(scene_, way);
  }
  Raster with(const Scene& scene) const { return picture(scene, right_); }
  Raster material(const std::function<void(Material&)>& change) const {
    return with(changed_materials(scene_, change));
  }
  void both(const std::string& defects, const Raster& one, const Raster& another, const Raster& test) const {
    if (differ(reference_, one) && differ(reference_, another)) record(defects, "-", test);
  }

  static Way way() {
    Way way;
    way.options.width = 256;
    return way;
  }

  const Scene& scene_;
  Confusion& confusion_;
  Way right_ = way();
  Raster reference_;
  std::optional<std::size_t> object_ = suitable_object(scene_, right_, reference_);
};

// The course's and HKUST's scenes of the corpus, drawn without settings or cube maps, without the largest
// meshes. Of our own manifest, which has fewer columns, everything.
bool chosen(const std::vector<std::string>& row) {
  if (row.size() <= 5) return true;
  return row[2] != "-" && row[1] == "-r 5 -w 512" && std::atoi(row[5].c_str()) <= 20000 &&
         (row[0].find("utexas") != std::string::npos || row[0].find("hkust") != std::string::npos);
}

void print_table(const std::string& title, const std::filesystem::path& folder) {
  Confusion confusion;
  std::optional<Raster> previous;
  int scenes = 0;
  for (const auto& row : read_table(folder / "manifest.tsv")) {
    if (!chosen(row)) continue;
    const Scene scene = scene_of((folder / row[0]).string());
    if (scene.objects.empty()) continue;
    const Defects defects(scene, confusion);
    ++scenes;
    defects.sampling();
    defects.tones();
    defects.missing();
    defects.other();
    defects.two();
    if (previous && previous->height == defects.reference().height)
      defects.record("another scene", "-", *previous);
    previous = defects.reference();
  }
  std::cout << "## " << title << "\n\n"
            << scenes << " scenes, " << confusion.summary() << "\n\n"
            << confusion.table() << "\n";
}

}  // namespace

TEST_CASE("confusion of defects and diagnoses", "[.][diagnosis-table]") {
  const std::filesystem::path source = TRACE_SOURCE_DIR;
  print_table("Our own scenes", source / "scenes");
  const char* place = std::getenv("TRACE_CORPUS");
  const std::filesystem::path corpus = place ? place : source / "../shared/corpus";
  if (std::filesystem::exists(corpus / "manifest.tsv")) {
    print_table("Scenes of the courses", corpus);
  } else {
    WARN("skipped: the corpus is not at ../shared/corpus");
  }
}

}  // namespace trace::test
