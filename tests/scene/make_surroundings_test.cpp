#include "scene/make_surroundings.hpp"

#include <catch2/catch.hpp>

#include "tests/image/picture_files.hpp"
#include "tests/support/numbers_near.hpp"

using namespace trace;
using namespace trace::test;

namespace {

constexpr std::array<const char*, 6> sky_faces{"right", "left", "top", "bottom", "front", "back"};

// Faces of grey 10, 20, ... 60 in the folder, named with a separator behind "sky".
parser::Surroundings sky_in(const TemporaryFolder& folder, char separator) {
  std::filesystem::create_directories(folder / "sky");
  parser::Surroundings said;
  said.skybox = true;
  said.keyword = {0, 6};
  int grey = 0;
  for (std::size_t face = 0; face < 6; ++face) {
    grey += 10;
    write_image(folder / "sky" / (std::string(sky_faces[face]) + ".bmp"),
                Image{2, 2, std::vector<std::uint8_t>(12, static_cast<std::uint8_t>(grey))});
    const auto at = static_cast<std::uint32_t>(10 * face + 10);
    said.faces[face] = parser::Name{std::string("sky") + separator + sky_faces[face] + ".bmp", {at, at + 5}};
  }
  return said;
}

}  // namespace

TEST_CASE("the faces of a skybox are those that are seen, '\\' counting as '/' where that finds them") {
  const TemporaryFolder folder;
  const parser::Surroundings said = sky_in(folder, GENERATE('/', '\\'));
  FileImages images;
  parser::Diagnostics diagnostics;
  const auto map = make_surroundings(said, folder.path(), images, diagnostics);
  CHECK(diagnostics.all().empty());
  REQUIRE(map);
  const Vec3 seen_along[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, -1}, {0, 0, 1}};
  for (int face = 0; face < 6; ++face)
    CHECK(map->lookup(seen_along[face]) == near(Vec3(10 * (face + 1) / 255.0)));
}

TEST_CASE("surroundings without all six faces are a warning at their place, and there are none") {
  const TemporaryFolder folder;
  parser::Surroundings said = sky_in(folder, '/');
  FileImages images;
  const auto warning = [&] {
    parser::Diagnostics diagnostics;
    CHECK_FALSE(make_surroundings(said, folder.path(), images, diagnostics));
    REQUIRE(diagnostics.all().size() == 1);
    CHECK(diagnostics.all()[0].severity == parser::Severity::warning);
    return diagnostics.all()[0];
  };
  said.faces[3]->value = "sky/none.bmp";
  CHECK(warning().span.begin == 40);
  CHECK(warning().text.starts_with("no surroundings: cannot read 'sky/none.bmp'"));
  said.faces[1].reset();
  CHECK(warning().text == "no surroundings: the skybox has no 'left'");
  CHECK(warning().span.begin == 0);
  said = {};
  said.file = parser::Name{"sky/right.bmp", {70, 80}};
  CHECK(warning().span.begin == 70);  // the names of the faces are not those of -c
}
