// `-c ONE_FACE`: which six files make the cube map.
#include <algorithm>

#include "scene/cube_map.hpp"
#include "tests/image/picture_files.hpp"
#include "tests/support/numbers_near.hpp"

using namespace trace;
using namespace trace::test;

namespace {

std::optional<CubeMap> read_faces(const std::string& one_face, std::string& problem) {
  FileImages images;
  return read_cube_map(one_face, images, problem);
}

// A picture of one grey.
void put_grey(const std::filesystem::path& file, int byte) {
  write_image(file, Image{2, 2, std::vector<std::uint8_t>(12, static_cast<std::uint8_t>(byte))});
}

// Six faces named by `prefix`, the faces +x -x +y -y posz negz of grey 10, 20, ... 60.
void put_faces(const TemporaryFolder& directory, const std::string& prefix, const std::string& suffix) {
  int grey = 0;
  for (const char* name : {"posx", "negx", "posy", "negy", "posz", "negz"}) {
    put_grey(directory / (prefix + name + suffix), grey += 10);
  }
}

std::string problem_of(const std::string& one_face) {
  std::string problem;
  return read_faces(one_face, problem) ? "no problem" : problem;
}

// Whether the six faces are where they belong.
bool complete(const std::optional<CubeMap>& map) {
  if (!map) return false;
  const Vec3 directions[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, -1}, {0, 0, 1}};
  for (int face = 0; face < 6; ++face) {
    if (!(map->lookup(directions[face]) == near(Vec3(10 * (face + 1) / 255.0)))) return false;
  }
  return true;
}

class WorkingFolder {
 public:
  explicit WorkingFolder(const std::filesystem::path& folder) : before_(std::filesystem::current_path()) {
    std::filesystem::current_path(folder);
  }
  WorkingFolder(const WorkingFolder&) = delete;
  WorkingFolder& operator=(const WorkingFolder&) = delete;
  ~WorkingFolder() { std::filesystem::current_path(before_); }

 private:
  std::filesystem::path before_;
};

}  // namespace

TEST_CASE("the six faces of a cube map are found by their names in the folder of any file") {
  const TemporaryFolder directory;
  const auto [prefix, suffix] = GENERATE(std::pair<std::string, std::string>("", ".png"),
                                         std::pair<std::string, std::string>("sky_", ".bmp"),
                                         std::pair<std::string, std::string>("", "_old.png"));
  put_faces(directory, prefix, suffix);
  std::string problem;
  CHECK(complete(read_faces((directory / (prefix + "posx" + suffix)).string(), problem)));
  CHECK(complete(read_faces((directory / "not_there.png").string(), problem)));
  CHECK(problem.empty());
}

TEST_CASE("between the sign of a face and its axis other letters may stand") {
  const TemporaryFolder directory;
  int grey = 0;
  for (const char* name :
       {"pos-of-x.png", "neg-of-x.png", "pos-of-y.png", "neg-of-y.png", "pos-of-z.png", "neg-of-z.png"}) {
    put_grey(directory / name, grey += 10);
  }
  std::string problem;
  CHECK(complete(read_faces((directory / "any").string(), problem)));
}

TEST_CASE("other files in the folder of a cube map do not matter") {
  const TemporaryFolder directory;
  put_faces(directory, "", ".png");
  put(directory / "posx.txt", {'n', 'o'});
  put_grey(directory / "x_pos.png", 99);  // the axis is not behind the sign
  put_grey(directory / "picture.png", 99);
  std::string problem;
  CHECK(complete(read_faces((directory / "posx.png").string(), problem)));
}

TEST_CASE("a name without a slash is the folder of the cube map itself") {
  const TemporaryFolder directory;
  std::filesystem::create_directory(directory / "sky");
  for (const char* name : {"posx", "negx", "posy", "negy", "posz", "negz"}) {
    put_grey(directory / (std::string("sky/") + name + ".png"), 70);
  }
  const WorkingFolder here(directory.path());
  std::string problem;
  CHECK(read_faces("sky", problem));
  CHECK(problem_of("posx.png") == "cannot read the folder 'posx.png': No such file or directory");
}

TEST_CASE("a cube map without all its faces names the first that is missing") {
  const TemporaryFolder directory;
  put_faces(directory, "", ".png");
  std::filesystem::remove(directory / "negz.png");
  std::filesystem::remove(directory / "posy.png");
  CHECK(problem_of((directory / "posx.png").string()) ==
        "the folder '" + directory.path().string() + "' has no posy face");
}

TEST_CASE("a cube map with two files for one face names both") {
  const TemporaryFolder directory;
  put_faces(directory, "", ".png");
  put_grey(directory / "negy.bmp", 1);
  const std::string folder = directory.path().string();
  CHECK(problem_of(folder + "/posx.png") ==
        "'" + folder + "/negy.bmp' and '" + folder + "/negy.png' are both the negy face");
}

TEST_CASE("a cube map whose folder is missing or no folder says why") {
  const TemporaryFolder directory;
  const std::string folder = directory.path().string();
  CHECK(problem_of(folder + "/sky/posx.png") ==
        "cannot read the folder '" + folder + "/sky': No such file or directory");
  put_grey(directory / "file.png", 1);
  CHECK(problem_of(folder + "/file.png/posx.png") ==
        "cannot read the folder '" + folder + "/file.png': Not a directory");
}

TEST_CASE("a cube map with a face that is no picture says which") {
  const TemporaryFolder directory;
  put_faces(directory, "", ".png");
  put(directory / "negx.png", {'n', 'o', 't', ' ', 'a', ' ', 'p', 'i', 'c', 't', 'u', 'r', 'e'});
  CHECK(problem_of((directory / "posx.png").string()) ==
        "cannot read '" + (directory / "negx.png").string() + "': not a picture this program can read");
}
