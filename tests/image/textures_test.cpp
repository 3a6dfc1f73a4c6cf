// The pictures in textures/.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <map>

#include "picture_files.hpp"

using namespace trace;
using namespace trace::test;

namespace {

const std::filesystem::path textures = std::filesystem::path(TRACE_SOURCE_DIR) / "textures";

using Direction = std::array<int, 3>;

// The direction in which one sees the texel (a, b) of a face (docs/language.md, section 10), where a and b go
// from -last to last and b goes up.
Direction direction(const std::string& face, int a, int b, int last) {
  if (face == "posx") return {last, b, a};
  if (face == "negx") return {-last, b, -a};
  if (face == "posy") return {a, last, b};
  if (face == "negy") return {a, -last, -b};
  if (face == "posz") return {a, b, -last};
  return {-a, b, last};
}

}  // namespace

TEST_CASE("the sky has no seams: faces agree wherever they meet") {
  std::map<Direction, Bytes> seen;
  std::size_t met = 0;
  int size = 0;
  for (const std::string face : {"posx", "negx", "posy", "negy", "posz", "negz"}) {
    const Image image = read_image(textures / "sky" / (face + ".png"));
    size = image.width;
    REQUIRE(image.height == size);
    for (int row = 0; row < size; ++row)
      for (int column = 0; column < size; ++column) {
        if (row % (size - 1) != 0 && column % (size - 1) != 0) continue;  // not at the face's edge
        const auto texel = image.rgb.begin() + 3 * (row * size + column);
        const Direction where = direction(face, 2 * column - (size - 1), (size - 1) - 2 * row, size - 1);
        const auto [place, is_new] = seen.try_emplace(where, texel, texel + 3);
        met += !is_new;
        REQUIRE(std::equal(texel, texel + 3, place->second.begin()));
      }
  }
  CHECK(met == std::size_t(12 * (size - 2) + 8 * 2));  // 12 edges shared by two, 8 corners shared by three
}

TEST_CASE("every texture can be read") {
  const std::string name = GENERATE("checker.png", "uv-grid.png", "brick.png", "wood.png", "marble.png",
                                    "earth-like.png", "tiles.bmp", "stars.png");
  const Image image = read_image(textures / name);
  CHECK(image.width >= 256);
  CHECK(image.height >= 256);
}
