// Meshes from OBJ files.
#include "scene/obj_file.hpp"
#include "scene/obj_meshes.hpp"
#include "tests/image/picture_files.hpp"
#include "tests/support/numbers_near.hpp"
#include "tests/support/scene_describe.hpp"
#include "tests/support/scene_trace.hpp"

using namespace trace;
using namespace trace::test;

namespace {

ObjFile obj_of(const std::string& text, const std::string& materials = "") {
  const TemporaryFolder folder;
  write_text(folder / "m.obj", text);
  if (!materials.empty()) write_text(folder / "m.mtl", materials);
  FileImages images;
  return read_obj(folder / "m.obj", images);
}

std::string obj_error(const std::string& text) {
  try {
    obj_of(text);
  } catch (const ObjError& e) {
    return e.what();
  }
  return "no error";
}

Built scene_of(const TemporaryFolder& folder, std::vector<parser::MaterialAssignment> material,
               bool generate_normals = false, const std::string& file = "m.obj") {
  parser::Mesh mesh;
  mesh.file = parser::Name{file, {12, 17}};
  mesh.generate_normals = generate_normals;
  Describe d;
  d.top(d.mesh(std::move(mesh), {block(std::move(material))}));
  return build(d, folder.path().string());
}

const std::string triangle = "v -1 -1 0\nv 1 -1 0\nv 0 1 0\n";

}  // namespace

TEST_CASE("an OBJ file's polygons become fans, and its indices may count from the end") {
  const ObjFile file = obj_of(
      "v 0 0 0\nv 1 0 0\r\nv 1 1 0\nv 0 1 0\n# comment\ng group\no name\ns off\nf 1 2 3 4\nf -4 -3 -2\n");
  REQUIRE(file.faces.size() == 2);
  const auto parts = parts_of(file, false);
  REQUIRE(parts.size() == 1);
  CHECK(parts[0].mesh.points.size() == 4);
  CHECK(parts[0].mesh.faces == std::vector<FaceCorners>{{0, 1, 2}, {0, 2, 3}, {0, 1, 2}});
  CHECK_FALSE(parts[0].mesh.smooth());
  CHECK_FALSE(parts[0].mesh.has_coordinates());
}

TEST_CASE("points of an OBJ file that have several normals or texture coordinates are split") {
  const ObjFile file = obj_of(
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 0.5 1\nvn 0 0 1\nvn 1 0 0\n"
      "f 1/1/1 2/1/1 3/1/1\nf 1/1/1 3/2/1 4/1/2\n");
  const auto parts = parts_of(file, false);
  REQUIRE(parts.size() == 1);
  const Mesh& mesh = parts[0].mesh;
  CHECK(mesh.points.size() == 5);  // the third twice
  REQUIRE(mesh.coordinates.size() == 5);
  CHECK(mesh.coordinates[3] == Vec2(0.5, 1));
  REQUIRE(mesh.normals.size() == 5);
  CHECK(mesh.normals[4] == Vec3(1, 0, 0));
}

TEST_CASE("an OBJ part has normals only where all of its corners do, and generates them across splits") {
  const ObjFile file = obj_of(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvt 1 1\nvn 0 0 1\n"
      "f 1/1/1 2/1/1 3/1\nf 1/2 4/2 2/2\n");
  CHECK_FALSE(parts_of(file, false)[0].mesh.smooth());
  const Mesh mesh = parts_of(file, true)[0].mesh;
  REQUIRE(mesh.normals.size() == 6);
  CHECK(mesh.normals[0] == near(0, 0.5, 0.5));  // the first point, of both faces
  CHECK(mesh.normals[3] == near(0, 0.5, 0.5));
  CHECK(mesh.normals[2] == near(0, 0, 1));
}

TEST_CASE(
    "faces of different OBJ materials become objects at the same place, on top of the scene's material") {
  const TemporaryFolder folder;
  write_text(folder / "m.mtl",
             "newmtl red\nKd 1 0 0\nNs 20\nd 0.25\nTf 1 0.5 0\nNi 1.5\n"
             "newmtl plain\nKa 0.1 0.2 0.3\nKe 1 2 3\n");
  write_text(folder / "m.obj", "mtllib m.mtl\n" + triangle +
                                   "usemtl red\nf 1 2 3\nusemtl plain \nf 1 3 2\nusemtl red\nf 1 2 3\n");
  const Built built =
      scene_of(folder, {is(Parameter::diffuse, 0, 1, 0), is(Parameter::specular, 0.5, 0.5, 0.5)});
  CHECK(built.diagnostics.all().empty());
  REQUIRE(built.scene.objects.size() == 2);
  CHECK(built.scene.objects[0].frame == built.scene.objects[1].frame);
  CHECK(built.scene.triangle_count() == 3);
  const Material &red = built.material(0), &plain = built.material(1);
  CHECK(red.diffuse == Rgb(1, 0, 0));
  CHECK(red.specular == Rgb(0.5));
  CHECK(luminance(red.shininess) == about(20));
  CHECK(red.transmissive == near(0.75, 0.375, 0));
  CHECK(luminance(red.index) == about(1.5));
  CHECK(built.scene.has_transmissive_objects);
  CHECK(plain.diffuse == Rgb(0, 1, 0));
  CHECK(plain.ambient == near(0.1, 0.2, 0.3));  // the library rounds a few times
  CHECK(plain.emissive == Rgb(1, 2, 3));
  CHECK_FALSE(plain.transmits());
}

TEST_CASE("an OBJ material's picture is found beside the file, and spread by its texture coordinates") {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "models");
  write_image(folder / "models/p.png", Image{2, 1, {0, 0, 0, 255, 255, 255}});
  write_text(folder / "models/m.mtl", "newmtl a\nmap_Ke p.png\nmap_Kd none.png\n");
  write_text(folder / "models/m.obj",
             "mtllib m.mtl\n" + triangle + "vt 0 0\nvt 1 0\nvt 0.5 0\nusemtl a\nf 1/1 2/2 3/3\n");
  const Built built = scene_of(folder, {is(Parameter::diffuse, 0, 1, 0)}, false, "models\\m.obj");
  REQUIRE(built.diagnostics.all().size() == 1);
  CHECK(built.diagnostics.all()[0].text ==
        "'models\\m.obj': the picture 'none.png' of its material 'a' cannot be read: no such file");
  CHECK(built.material(0).diffuse == Rgb(0, 1, 0));
  CHECK(seen(built.scene) == near(0.5, 0.5, 0.5));
}

TEST_CASE("an OBJ file without its material file is drawn in the scene's material, with a warning") {
  const TemporaryFolder folder;
  write_text(folder / "m.obj", "mtllib gone.mtl\nmtllib gone.mtl\n" + triangle + "usemtl a\nf 1 2 3\n");
  const Built built = scene_of(folder, {is(Parameter::emissive, 0, 0.5, 1)});
  REQUIRE(built.diagnostics.all().size() == 1);
  CHECK(built.diagnostics.all()[0].severity == parser::Severity::warning);
  CHECK(built.diagnostics.all()[0].text ==
        "'m.obj': its material file 'gone.mtl' cannot be read: no such file");
  CHECK(built.diagnostics.all()[0].span.begin == 12);
  CHECK(seen(built.scene) == Rgb(0, 0.5, 1));
}

TEST_CASE("an OBJ file that is not there is an error at its name, one without faces a warning") {
  const TemporaryFolder folder;
  const Built none = scene_of(folder, {});
  REQUIRE(none.diagnostics.error_count() == 1);
  CHECK(none.diagnostics.all()[0].text == "cannot read 'm.obj': no such file");
  write_text(folder / "m.obj", "");
  const Built empty = scene_of(folder, {});
  REQUIRE(empty.diagnostics.all().size() == 1);
  CHECK(empty.diagnostics.all()[0].text == "'m.obj': it has no faces");
  CHECK(empty.scene.objects.empty());
  std::filesystem::create_directories(folder / "d.obj");
  CHECK(scene_of(folder, {}, false, "d.obj").diagnostics.all()[0].text ==
        "cannot read 'd.obj': is a directory");
}

TEST_CASE("what an OBJ file must not hold is said with its place") {
  CHECK(obj_error(triangle + "f 1 2 4\n") == "face 1 has a corner with point 4, but before it there are 3");
  CHECK(obj_error(triangle + "f 1 2 3\nf 1 2 -4\n") ==
        "face 2 has a corner with point -4, but before it there are 3");
  CHECK(obj_error(triangle + "f 0 1 2\n") == "face 1 has a corner with point 0, but before it there are 3");
  CHECK(obj_error(triangle + "f x y z\n") == "face 1 has a corner with point 0, but before it there are 3");
  CHECK(obj_error(triangle + "f 99999999999999999999 1 2\n")
            .find("a face has an index of more than nine digits") == 0);
  CHECK(obj_error(triangle + "f 1/1 2/1 3/1\n") ==
        "face 1 has a corner with texture place 1, but before it there are 0");
  CHECK(obj_error(triangle + "f 1//2 2//2 3//2\n") ==
        "face 1 has a corner with normal 2, but before it there are 0");
  CHECK(obj_error("v 0 0 1e400\n") == "point 1 is not of finite numbers");
  CHECK(obj_error("vn 0 0 -1e99999\n") == "normal 1 is not of finite numbers");
  CHECK(obj_error("v " + std::string(2'000'000, '1') + "\n") == "a line is longer than 1048576 bytes");
}

TEST_CASE("hostile OBJ files are read or refused, never more") {
  const std::string endless = [] {
    std::string polygon = "f";
    for (int i = 0; i < 100'000; ++i) polygon += " 1 2 3";
    return polygon + "\n";
  }();
  CHECK(obj_of(triangle + endless).faces[0].size == 300'000);
  CHECK(obj_of(triangle + "f 1 2\nf 1\nf\nf /\nf //\nf 1 2 3\n").faces.size() == 1);
  const char* harmless[] = {"v",
                            "v \n",
                            "v nan nan nan\n",
                            "f \t \n",
                            "usemtl\n",
                            "usemtl \n",
                            "mtllib\n",
                            "mtllib \n",
                            "g\n",
                            "g \n",
                            "o \n",
                            "v 1e-400 1E+3 .5\n",
                            "v 0x10 1,5 --2\n",
                            "vt\n",
                            "vn 1\n",
                            "\\\n",
                            "v 1 2 3 \\\n4\n",
                            "mtllib ../../../../etc/passwd\n",
                            "mtllib /dev/zero\n",
                            "curv 0 1\nsurf 0 1\nend\n",
                            "l 1 2\np 1\n",
                            "f 1 2 3",
                            "\r\r\n\r"};
  for (const char* text : harmless) {
    INFO(text);
    CHECK_NOTHROW(obj_of(triangle + text));
  }
  CHECK_NOTHROW(obj_of(triangle + std::string("v 1\0 2 3\nf 1 2 3\n", 18)));
}

TEST_CASE("hostile material files are read or passed over") {
  const std::string use = "mtllib m.mtl\n" + triangle + "usemtl a\nf 1 2 3\n";
  const char* files[] = {"\n",
                         "newmtl\n",
                         "newmtl \nKd 1 1 1\n",
                         "Kd 1 1 1\n",
                         "newmtl a\nKd\nKs x\nNs 1e400\nd nan\n",
                         "newmtl a\nnewmtl a\nnewmtl a\n",
                         "newmtl a\nmap_Kd\nmap_Kd \nmap_Kd -o\nmap_Kd -s 1 1\nbump -bm\n",
                         "newmtl a\nmap_Kd -type sphere -mm 1 2 -clamp on -texres x -imfchan q y.png\n",
                         "newmtl a\nTf xyz 1 1\nillum 99999999999\n"};
  for (const char* text : files) {
    INFO(text);
    CHECK(obj_of(use, text).faces.size() == 1);
  }
  const ObjFile bad = obj_of(use, "newmtl a\nNs 1e400\nKd 0.5 0.5 0.5\n");
  REQUIRE(bad.materials.size() == 1);
  CHECK_FALSE(bad.materials[0].shininess);
  CHECK(bad.materials[0].diffuse == Rgb(0.5));
}
