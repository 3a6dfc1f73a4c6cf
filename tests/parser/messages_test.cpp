// Every message of the parser, word for word: their text is an interface.
#include <catch2/catch.hpp>

#include "helpers.hpp"

using namespace trace::parser::test;

namespace {

// What may stand in a scene, as the first error about an unknown word there tells.
const std::string scene_words =
    "note: the scene takes sphere, box, square, cylinder, cone, trimesh, translate, rotate, scale, "
    "transform, "
    "material, camera, point_light, directional_light, ambient_light, plane, torus, quadric, paraboloid, "
    "hyperboloid, hyperbolic_paraboloid, torus_knot, height_field, spot_light, area_light, area_light_rect, "
    "area_light_circ, shape_light, warn_light, warn_model_light, fog, cubemap and skybox\n";

const std::string object_words =
    "note: the objects are sphere, box, square, cylinder, cone, trimesh, translate, rotate, scale, "
    "transform, "
    "plane, torus, quadric, paraboloid, hyperboloid, hyperbolic_paraboloid, torus_knot and height_field\n";

}  // namespace

TEST_CASE("the header must stand first, with a version that can be read") {
  CHECK(messages_of_file("") == "1:1: error: the file does not begin with 'SBT-raytracer'\n");
  CHECK(messages_of_file("sbt-raytracer 1.0") ==
        "1:1: error: the file does not begin with 'SBT-raytracer'\n"
        "1:1: note: did you mean 'SBT-raytracer'?\n");
  CHECK(messages_of_file("camera {}") == "1:1: error: the file does not begin with 'SBT-raytracer'\n");
  CHECK(messages_of_file("SBT-raytracer sphere {}") ==
        "1:15: error: expected the version number after 'SBT-raytracer', found 'sphere'\n");
  CHECK(messages_of_file("SBT-raytracer") ==
        "1:14: error: expected the version number after 'SBT-raytracer', found the end of the file\n");
  CHECK(messages_of_file("SBT-raytracer 1.2\nfoo") ==
        "1:15: error: version 1.2 is newer than 1.1, the newest this program reads\n");
  CHECK(messages_of_file("SBT-raytracer1.0\n") ==
        "1:1: error: the file does not begin with 'SBT-raytracer'\n"
        "1:1: note: did you mean 'SBT-raytracer'?\n");
}

TEST_CASE("a malformed number is an error at its own place") {
  CHECK(messages("translate(1-2,1.2.3,-,sphere{}) scale(.,sphere{})") ==
        "2:11: error: malformed number '1-2'\n"
        "2:15: error: malformed number '1.2.3'\n"
        "2:21: error: malformed number '-'\n"
        "2:39: error: malformed number '.'\n");
  CHECK(messages("camera { fov=1e; }") == "2:14: error: malformed number '1e'\n");
  CHECK(messages("camera { fov=0x10; position=(1f,--1,1-e) }") ==
        "2:14: error: malformed number '0x10'\n"
        "2:30: error: malformed number '1f'\n"
        "2:33: error: malformed number '--1'\n"
        "2:37: error: malformed number '1-e'\n");
  CHECK(messages("camera { fov=1e999; position=(1e-999,0,-1e400); }") ==
        "2:14: error: number '1e999' is out of range\n"
        "2:40: error: number '-1e400' is out of range\n");
  CHECK(messages("camera { position=(1sphere,0,0); }") == "2:20: error: malformed number '1sphere'\n");
  CHECK(messages("sphere { name=1a; }") == "2:15: error: malformed number '1a'\n");
}

TEST_CASE("what the scanner cannot read is an error at its own place") {
  CHECK(messages("# comment\nsphere {}") == "2:1: error: unexpected character '#'\n");
  CHECK(messages("sphere {} @ box {}") == "2:11: error: unexpected character '@'\n");
  CHECK(messages("/* /* */ */") == "2:10: error: '*/' without '/*': comments do not nest\n");
  CHECK(messages("/* never closed\nsphere {}") ==
        "2:1: error: this comment is not closed: its '*/' is missing\n");
  CHECK(messages("sphere { name=\"a\nb\"; }\nsphere { x=1; }") ==
        "2:15: error: this string is not closed on its line\n"
        "4:10: error: unknown attribute 'x' in a sphere\n"
        "4:10: note: a sphere takes material and name\n");
  CHECK(messages("sphere { name=\"abc; }\nsphere { x=1; }") ==
        "2:15: error: this string is not closed on its line\n"
        "3:10: error: unknown attribute 'x' in a sphere\n"
        "3:10: note: a sphere takes material and name\n");
  CHECK(messages("sphere { name=\"a\\\"b\"; }") ==
        "2:17: error: strings have no escapes: this '\"' ends the string\n");
  CHECK(messages("sphere\xC2\xA0"
                 "{}") == "2:7: error: unexpected character U+00A0\n");
}

TEST_CASE("an unknown word at the top level is told what may stand there") {
  CHECK(messages("Sphere {}") ==
        "2:1: error: unknown word 'Sphere': expected an object, a light, a camera or a material\n"
        "2:1: note: did you mean 'sphere'?\n"
        "2:1: " +
            scene_words);
  CHECK(messages("spher {} spotlight {} mist { density=1; }") ==
        "2:1: error: unknown word 'spher': expected an object, a light, a camera or a material\n"
        "2:1: note: did you mean 'sphere'?\n"
        "2:1: " +
            scene_words +
            "2:10: error: unknown word 'spotlight': expected an object, a light, a camera or a material\n"
            "2:10: note: did you mean 'spot_light'?\n"
            "2:23: error: unknown word 'mist': expected an object, a light, a camera or a material\n");
  CHECK(messages("include \"x.ray\"") ==
        "2:1: error: unknown word 'include': expected an object, a light, a camera or a material\n"
        "2:1: " +
            scene_words);
  CHECK(messages("\"sphere\" {}") ==
        "2:1: error: expected an object, a light, a camera or a material, found the string \"sphere\"\n");
  CHECK(messages("diffuse=(1,1,1);") ==
        "2:1: error: 'diffuse' cannot stand at the top level of the scene: expected an object, a light, a "
        "camera or a material\n");
  CHECK(messages("5") == "2:1: error: expected an object, a light, a camera or a material, found '5'\n");
  CHECK(messages("= sphere {}") ==
        "2:1: error: expected an object, a light, a camera or a material, found '='\n");
}

TEST_CASE("an unknown attribute is told what the block takes, once") {
  CHECK(messages("sphere { radius=1 material={} }") ==
        "2:10: error: unknown attribute 'radius' in a sphere\n"
        "2:10: note: a sphere takes material and name\n");
  CHECK(
      messages("camera { look_to=(0,0,0); focal=2; }") ==
      "2:10: error: unknown attribute 'look_to' in the camera\n"
      "2:10: note: did you mean 'look_at'?\n"
      "2:10: note: the camera takes position, viewdir, updir, fov, aspectratio, quaternian, height, look_at "
      "and projection\n"
      "2:27: error: unknown attribute 'focal' in the camera\n");
  CHECK(messages("sphere { material={ difuse=(1,0,0); gloss=1; } }") ==
        "2:21: error: unknown attribute 'difuse' in a material\n"
        "2:21: note: did you mean 'diffuse'?\n"
        "2:21: note: a material takes emissive, ambient, diffuse, specular, reflective, transmissive, "
        "shininess, index, name, absorb, glossiness, specular_model, bump and normal\n"
        "2:37: error: unknown attribute 'gloss' in a material\n");
  CHECK(messages("cylinder { height=2; }") ==
        "2:12: error: unknown attribute 'height' in a cylinder\n"
        "2:12: note: a cylinder takes material, name and capped\n");
  CHECK(messages("ambient_light { color=(1,1,1) position=(0,0,0) }") ==
        "2:31: error: unknown attribute 'position' in an ambient_light\n"
        "2:31: note: an ambient_light takes color\n");
  CHECK(messages("directional_light { Direction=(0,0,1); direction=(0,0,1); color=(1,1,1); }") ==
        "2:21: error: unknown attribute 'Direction' in a directional_light\n"
        "2:21: note: did you mean 'direction'?\n"
        "2:21: note: a directional_light takes direction and color\n");
  CHECK(messages("point_light { position=(0,0,0); color=(1,1,1); cognstant_attenuation_coeff=1; }") ==
        "2:48: error: unknown attribute 'cognstant_attenuation_coeff' in a point_light\n"
        "2:48: note: did you mean 'constant_attenuation_coeff'?\n"
        "2:48: note: a point_light takes position, color, constant_attenuation_coeff, "
        "linear_attenuation_coeff and quadratic_attenuation_coeff\n");
  CHECK(messages("cone { radius=1; }") ==
        "2:8: error: unknown attribute 'radius' in a cone\n"
        "2:8: note: a cone takes material, name, capped, bottom_radius, top_radius and height\n");
  CHECK(messages("polymesh { vertices=((0,0)); }") ==
        "2:12: error: unknown attribute 'vertices' in a polymesh\n"
        "2:12: note: a polymesh takes material, name, points, faces, normals, materials, gennormals, "
        "texture_uv and objfile\n");
  CHECK(messages("box { 5; ) \"x\"; }") ==
        "2:7: error: expected an attribute of a box or '}', found '5'\n"
        "2:10: error: expected an attribute of a box or '}', found ')'\n");
}

TEST_CASE("a missing '=' is named") {
  CHECK(messages("material \"a\"; sphere { material (1,2,3); }") ==
        "2:10: error: expected '=' after 'material', found the string \"a\"\n"
        "2:33: error: expected '=' after 'material', found '('\n");
  CHECK(messages("camera { position (1,2,3); fov 3; fov; }") ==
        "2:19: error: expected '=' after 'position', found '('\n"
        "2:32: error: expected '=' after 'fov', found '3'\n"
        "2:38: error: expected '=' after 'fov', found ';'\n");
  CHECK(messages("trimesh { points ((0,0,0)); }") == "2:18: error: expected '=' after 'points', found '('\n");
}

TEST_CASE("a ';' is missed only where it is mandatory") {
  CHECK(messages("trimesh { points=((0,0,0)) normals=((0,0,1)) materials=({}) faces=() }") ==
        "2:28: error: expected ';' after the list of points, found 'normals'\n"
        "2:46: error: expected ';' after the list of normals, found 'materials'\n"
        "2:61: error: expected ';' after the list of materials, found 'faces'\n"
        "2:70: error: expected ';' after the list of faces, found '}'\n");
  CHECK(messages("trimesh { gennormals points=((0,0,0)); }") ==
        "2:22: error: expected ';' after 'gennormals', which takes no value, found 'points'\n");
  CHECK(messages("trimesh { gennormals=1; texture_uv=() }") ==
        "2:22: error: 'gennormals' takes true or false, found '1'\n"
        "2:39: error: expected ';' after the list of texture_uv, found '}'\n");
  CHECK(messages("material={ name \"a\" diffuse=(1,0,0); }") ==
        "2:21: error: expected ';' after the name of a material, found 'diffuse'\n");
}

TEST_CASE("names are words that are not reserved, or strings") {
  CHECK(messages("sphere { name=sphere; }") ==
        "2:15: error: 'sphere' is a reserved word: put it in quotes to use it as a name\n");
  CHECK(messages("sphere { name=name; material={} }") ==
        "2:15: error: 'name' is a reserved word: put it in quotes to use it as a name\n");
  CHECK(messages("material={ name sphere; }") ==
        "2:17: error: 'sphere' is a reserved word: put it in quotes to use it as a name\n");
  CHECK(messages("sphere { name=5; }") == "2:15: error: expected a name, found '5'\n");
  CHECK(messages("sphere { name=; }") == "2:15: error: expected a name, found ';'\n");
}

TEST_CASE("a material must be named before it is used, and only once") {
  CHECK(messages("sphere { material=nope; }") ==
        "2:19: error: there is no material named 'nope' before this\n");
  CHECK(messages("material={name \"red\";} sphere { material=rad; }") ==
        "2:42: error: there is no material named 'rad' before this\n"
        "2:42: note: did you mean 'red'?\n");
  CHECK(messages("material={name a;} material={name \"a\";}") ==
        "2:35: error: the material 'a' is already defined\n"
        "2:16: note: first defined here\n");
  CHECK(messages("sphere { material=later; } material={name later;}") ==
        "2:19: error: there is no material named 'later' before this\n");
  CHECK(messages("material = sphere {}") ==
        "2:12: error: 'material' takes a block '{ ... }' or the name of a material, found 'sphere'\n");
  CHECK(messages("material = 5;") ==
        "2:12: error: 'material' takes a block '{ ... }' or the name of a material, found '5'\n");
}

TEST_CASE("a value of the wrong kind is told what the attribute takes") {
  CHECK(messages("material={ shininess=(1,2,3); index=x; }") ==
        "2:22: error: 'shininess' takes one number, not a list\n"
        "2:37: error: 'index' takes a number or a map, found 'x'\n");
  CHECK(messages("material={ diffuse=0.5; specular=wood; bump=(1,0,0); }") ==
        "2:20: error: 'diffuse' takes three numbers in parentheses or a map, found '0.5'\n"
        "2:34: error: 'specular' takes three numbers in parentheses or a map, found 'wood'\n"
        "2:45: error: 'bump' takes a map, found '('\n");
  CHECK(
      messages("material={ diffuse=map(\"a\",\"b\"); ambient=map(\"a\",3); specular=map(\"a\",\"b\",1; }") ==
      "2:31: error: a map of two files: expected ',' and the threshold from which the second shows, found "
      "')'\n"
      "2:50: error: a map of two files: expected the second in quotes, found '3'\n"
      "2:76: error: expected ')' after the threshold, found ';'\n");
  CHECK(messages("skybox { left=(1,2,3); } cubemap { file=x; }") ==
        "2:15: error: 'left' takes a file name in quotes, found '('\n"
        "2:41: error: 'file' takes a file name in quotes, found 'x'\n");
  CHECK(messages("spot_light { angle=wide; direction=1,2,3; target=(1,2); }") ==
        "2:20: error: 'angle' takes a number or three in parentheses, found 'wide'\n"
        "2:37: error: 'direction' takes one number\n"
        "2:54: error: 'target' takes three numbers: expected ',', found ')'\n");
  CHECK(messages("material={ diffuse=map(t.bmp); specular=map(\"a\"; index=map; }") ==
        "2:24: error: expected a file name in quotes, found 't'\n"
        "2:48: error: expected ')' after the file name, found ';'\n"
        "2:59: error: expected '(' after 'map', found ';'\n");
  CHECK(messages("cone { capped=1; height=\"a\"; top_radius=(1,2,3); }") ==
        "2:15: error: 'capped' takes true or false, found '1'\n"
        "2:25: error: 'height' takes a number, found the string \"a\"\n"
        "2:41: error: 'top_radius' takes one number, not a list\n");
  CHECK(messages("camera { fov=; position=1; quaternian=5; }") ==
        "2:14: error: 'fov' takes a number, found ';'\n"
        "2:25: error: 'position' takes three numbers in parentheses, found '1'\n"
        "2:39: error: 'quaternian' takes four numbers in parentheses, found '5'\n");
  CHECK(messages("trimesh { points=5; faces=\"x\"; materials=red; }") ==
        "2:18: error: 'points' takes a list in parentheses, found '5'\n"
        "2:27: error: 'faces' takes a list in parentheses, found the string \"x\"\n"
        "2:42: error: 'materials' takes a list in parentheses, found 'red'\n");
  CHECK(messages("camera { fov=1,2; }") == "2:15: error: 'fov' takes one number\n");
}

TEST_CASE("the count of numbers is told") {
  CHECK(messages("material={ diffuse=(1,1); specular=(1,1,1,1); ambient=(); }") ==
        "2:24: error: 'diffuse' takes three numbers: expected ',', found ')'\n"
        "2:42: error: 'specular' takes three numbers: expected ')', found ','\n"
        "2:56: error: expected a number, found ')'\n");
  CHECK(messages("camera { quaternian=(1,2,3); position=(1 2 3) }") ==
        "2:27: error: 'quaternian' takes four numbers: expected ',', found ')'\n"
        "2:42: error: 'position' takes three numbers: expected ',', found '2'\n");
  CHECK(messages("camera { position=(1,2; fov=3; }") ==
        "2:23: error: 'position' takes three numbers: expected ',', found ';'\n");
}

TEST_CASE("a camera gives both directions or none, and an aspect ratio above 0") {
  CHECK(messages("camera { viewdir=(0,0,1); }") ==
        "2:10: error: the camera gives 'viewdir' without 'updir'\n");
  CHECK(messages("camera { updir=(0,1,0); }") == "2:10: error: the camera gives 'updir' without 'viewdir'\n");
  CHECK(messages("camera { aspectratio=0; aspectratio=-1; }") ==
        "2:22: error: 'aspectratio' must be greater than 0\n"
        "2:37: error: 'aspectratio' must be greater than 0\n");
}

TEST_CASE("a light's attributes are given once, the required ones at least once") {
  CHECK(messages("point_light { color=(1,1,1); }") == "2:1: error: point_light has no 'position'\n");
  CHECK(messages("point_light { position=(0,0,0); }") == "2:1: error: point_light has no 'color'\n");
  CHECK(messages("directional_light { color=(1,1,1); }") ==
        "2:1: error: directional_light has no 'direction'\n");
  CHECK(messages("directional_light { direction=(0,0,1); }") ==
        "2:1: error: directional_light has no 'color'\n");
  CHECK(messages("ambient_light {}") == "2:1: error: ambient_light has no 'color'\n");
  CHECK(messages("ambient_light { color=(1,1,1); colour=(0,0,0); }") ==
        "2:32: error: 'color' is given twice in this ambient_light\n"
        "2:17: note: first given here\n");
  CHECK(messages("point_light { position=(0,0,0); position=(1,1,1); color=(1,1,1); "
                 "linear_attenuation_coeff=1; linear_attenuation_coeff=2; }") ==
        "2:33: error: 'position' is given twice in this point_light\n"
        "2:15: note: first given here\n"
        "2:94: error: 'linear_attenuation_coeff' is given twice in this point_light\n"
        "2:66: note: first given here\n");
}

TEST_CASE("a transform is told what it takes") {
  CHECK(messages("translate(1,2,sphere{})") ==
        "2:15: error: translate takes three numbers and one object: expected a number, found 'sphere'\n");
  CHECK(messages("translate(1,2,3)") ==
        "2:16: error: translate takes three numbers and one object: expected ',' and more, found ')'\n");
  CHECK(messages("translate sphere{}") == "2:11: error: expected '(' after 'translate', found 'sphere'\n");
  CHECK(messages("translate((1,2,3),sphere{})") ==
        "2:11: error: translate takes three numbers and one object: expected a number, found '('\n");
  CHECK(messages("rotate(1,2,3,sphere{})") ==
        "2:14: error: rotate takes three numbers for the axis, an angle and one object: expected a number, "
        "found 'sphere'\n");
  CHECK(messages("scale(1,2,sphere{}) scale(sphere{})") ==
        "2:11: error: scale takes one or three numbers and one object: expected a number, found 'sphere'\n"
        "2:27: error: scale takes one or three numbers and one object: expected a number, found 'sphere'\n");
  CHECK(messages("transform((1,0,0,0),(0,1,0,0),(0,0,1,0),sphere{})") ==
        "2:41: error: transform takes four rows of four numbers and one object: expected '(', found "
        "'sphere'\n");
  CHECK(messages("transform((1,0,0),(0,1,0,0),(0,0,1,0),(0,0,0,1),sphere{})") ==
        "2:17: error: a row of 'transform' takes four numbers: expected ',', found ')'\n");
  CHECK(messages("translate(1,2,3,sphere{} sphere{}) translate(1,2,3,sphere{},box{})") ==
        "2:26: error: translate takes one object: put several between '{' and '}'\n"
        "2:1: note: 'translate' is opened here\n"
        "2:60: error: translate takes one object: put several between '{' and '}'\n"
        "2:36: note: 'translate' is opened here\n");
  CHECK(messages("translate(1,2,3,tube{}) translate(1,2,3,spher{})") ==
        "2:17: error: unknown object 'tube'\n"
        "2:17: " +
            object_words +
            "2:41: error: unknown object 'spher'\n"
            "2:41: note: did you mean 'sphere'?\n");
  CHECK(messages("translate(1,2,3,material={})") ==
        "2:17: error: translate takes three numbers and one object: expected the object, found 'material'\n");
  CHECK(messages("translate(1,2,3,sphere{} 5)") ==
        "2:26: error: expected ')' of this translate, found '5'\n"
        "2:1: note: 'translate' is opened here\n");
}

TEST_CASE("lights and cameras stand at the top level only") {
  CHECK(messages("{ point_light { position=(0,0,0); color=(1,1,1); } camera {} }") ==
        "2:3: error: 'point_light' cannot stand in a group: lights stand at the top level of the scene\n"
        "2:52: error: 'camera' cannot stand in a group: cameras stand at the top level of the scene\n");
  CHECK(messages("translate(1,2,3,ambient_light { color=(1,1,1); })") ==
        "2:17: error: 'ambient_light' cannot stand in a translate: lights stand at the top level of the "
        "scene\n");
  CHECK(messages("{ spot_light {} } scale(2,fog {}) { skybox {} }") ==
        "2:3: error: 'spot_light' cannot stand in a group: lights stand at the top level of the scene\n"
        "2:27: error: 'fog' cannot stand in a scale: it stands at the top level of the scene\n"
        "2:37: error: 'skybox' cannot stand in a group: it stands at the top level of the scene\n");
  CHECK(messages("{ diffuse=(1,0,0); tube {} }") ==
        "2:3: error: 'diffuse' cannot stand in a group: expected an object or a material\n"
        "2:20: error: unknown word 'tube': expected an object or a material\n"
        "2:20: note: a group takes sphere, box, square, cylinder, cone, trimesh, translate, rotate, scale, "
        "transform, material, plane, torus, quadric, paraboloid, hyperboloid, hyperbolic_paraboloid, "
        "torus_knot "
        "and height_field\n");
  CHECK(messages("{ 5 }") == "2:3: error: expected an object or a material, found '5'\n");
}

TEST_CASE("a missing bracket is one error") {
  CHECK(messages("sphere { material={ diffuse=(1,0,0);") ==
        "2:37: error: unexpected end of file: '}' of this material is missing\n"
        "2:10: note: the material is opened here\n");
  CHECK(messages("translate(1,2,3,sphere {}") ==
        "2:26: error: unexpected end of file: ')' of this translate is missing\n"
        "2:1: note: 'translate' is opened here\n");
  CHECK(messages("{ sphere {}") ==
        "2:12: error: unexpected end of file: '}' of this group is missing\n"
        "2:1: note: the group is opened here\n");
  CHECK(messages("camera { position=(1,2") ==
        "2:23: error: unexpected end of file: ')' of 'position' is missing\n"
        "2:10: note: 'position' is opened here\n");
  CHECK(messages("material={ diffuse=map(\"x\"") ==
        "2:27: error: unexpected end of file: ')' of 'map' is missing\n"
        "2:20: note: 'map' is opened here\n");
  CHECK(messages("sphere { material={}\ncamera { fov=45; }\nbox {}") ==
        "3:1: error: 'camera' cannot stand in a sphere: is a '}' missing before it?\n"
        "2:1: note: 'sphere' is opened here\n");
  CHECK(messages("translate(0,0,0,sphere { material={} )\nbox {}") ==
        "2:38: error: '}' of this sphere is missing before ')'\n"
        "2:17: note: 'sphere' is opened here\n");
  CHECK(messages("translate(0,0,0,{ sphere {} )\nbox {}") ==
        "2:29: error: '}' of this group is missing before ')'\n"
        "2:17: note: the group is opened here\n");
  CHECK(messages("sphere { material={ diffuse=(1,0,0) specular=(1,0,0 } }\nbox {}") ==
        "2:53: error: 'specular' takes three numbers: expected ')', found '}'\n");
  CHECK(messages("material =") == "2:11: error: unexpected end of file: expected a name or '{'\n");
}

TEST_CASE("a bracket too many is one error") {
  CHECK(messages("sphere {} }\nbox {}") ==
        "2:11: error: unexpected '}': there is no '{' that it could close\n");
  CHECK(messages("sphere {} )\nbox {}") ==
        "2:11: error: unexpected ')': there is no '(' that it could close\n");
  CHECK(messages("sphere { ) }") == "2:10: error: expected an attribute of a sphere or '}', found ')'\n");
}

TEST_CASE("a block is told its bracket") {
  CHECK(messages("sphere sphere {}") == "2:8: error: expected '{' after 'sphere', found 'sphere'\n");
  CHECK(messages("camera fov=1;") == "2:8: error: expected '{' after 'camera', found 'fov'\n");
  CHECK(messages("box ( )") == "2:5: error: expected '{' after 'box', found '('\n");
}

TEST_CASE("lists of a mesh are told what they lack") {
  CHECK(messages("trimesh { points=(0,0,0); }") ==
        "2:19: error: expected '(' of a point or ')', found '0'\n");
  CHECK(messages("trimesh { points=((0,0,0),,(1,0,0)); }") ==
        "2:27: error: expected '(' of another point after ',', found ','\n");
  CHECK(messages("trimesh { texture_uv=((0,0),(1,2,3)); }") ==
        "2:33: error: a pair takes two numbers: expected ')', found ','\n");
  CHECK(messages("trimesh { points=((0,0),(0,0,0)); }") ==
        "2:23: error: a point takes three numbers: expected ',', found ')'\n");
  CHECK(messages("trimesh { points=((0,0,0,0)); }") ==
        "2:25: error: a point takes three numbers: expected ')', found ','\n");
  CHECK(messages("trimesh { points=((0,0,0) (1,0,0)); faces=((0 1 2)); }") ==
        "2:27: error: expected ',' or ')' after a point, found '('\n"
        "2:47: error: expected ',' or ')' in a face, found '1'\n");
  CHECK(messages("trimesh { points=((0,0,x)); }") == "2:24: error: expected a number, found 'x'\n");
  CHECK(messages("trimesh { normals=((0,0,0),5); }") ==
        "2:28: error: expected '(' of another normal after ',', found '5'\n");
  CHECK(messages("trimesh { points=((0,0,@),(1,2,3)); }") == "2:24: error: unexpected character '@'\n");
  CHECK(messages("trimesh { points=((0,0,0),(1,0,0); faces=((0,0,1)); }") ==
        "2:34: error: expected ',' or ')' after a point, found ';'\n");
  CHECK(messages("trimesh { points=((0,0,0)\n faces=((0,1,2)); }") ==
        "3:2: error: expected ',' or ')' after a point, found 'faces'\n");
  CHECK(messages("trimesh { faces=((0,1,2)") ==
        "2:25: error: unexpected end of file: the ')' of this list of faces is missing\n"
        "2:17: note: the list is opened here\n");
  CHECK(messages("trimesh { points=((0,0,1-2),(1e999,0x10,1sphere)); }") ==
        "2:24: error: malformed number '1-2'\n"
        "2:30: error: number '1e999' is out of range\n"
        "2:36: error: malformed number '0x10'\n"
        "2:41: error: malformed number '1sphere'\n");
  CHECK(messages("trimesh { materials=({},foo,{diffuse=1}); }") ==
        "2:25: error: there is no material named 'foo' before this\n"
        "2:38: error: 'diffuse' takes three numbers in parentheses or a map, found '1'\n");
  CHECK(messages("trimesh { materials=({} {}); }") ==
        "2:25: error: expected ',' or ')' after a material, found '{'\n");
  CHECK(messages("trimesh { materials=(5); }") == "2:22: error: expected a material, found '5'\n");
  CHECK(messages("trimesh { points=((0,0,\"x\")); }") ==
        "2:24: error: expected a number, found the string \"x\"\n");
}

TEST_CASE("the faces of a mesh are checked at the very index") {
  CHECK(messages("trimesh { points=((0,0,0),(1,0,0),(0,1,0)); faces=((0,1,2),(0,1,3)); }") ==
        "2:65: error: face index 3 is out of range: the mesh has 3 points (0 to 2)\n");
  CHECK(messages("trimesh { faces=((0,1,2),(7,8,9)); }") ==
        "2:19: error: face index 0 is out of range: the mesh has no points\n"
        "2:19: note: 5 more indices are out of range in this mesh\n");
  CHECK(messages("trimesh { faces=((0,0,1)); points=((0,0,0)); }") ==
        "2:23: error: face index 1 is out of range: the mesh has 1 point (0)\n");
  CHECK(
      messages("trimesh { points=((0,0,0)); faces=((0,0,0)); faces=( // 1\n(0,0,0), (0,5000000000,0)); }") ==
      "3:13: error: face index 5000000000 is out of range: the mesh has 1 point (0)\n");
  CHECK(messages("trimesh { points=((0,0,0)); faces=((0,-1,0),(0,0.9,0),(-0.5,0,0)); }") ==
        "2:39: error: face index -1 is negative\n"
        "2:48: error: face index 0.9 is not a whole number\n"
        "2:56: error: face index -0.5 is not a whole number\n");
  CHECK(messages("trimesh { points=((0,0,0)); faces=((0,0),(0)); }") ==
        "2:36: error: a face has at least three corners, this one has two\n"
        "2:42: error: a face has at least three corners, this one has one\n");
  CHECK(messages("trimesh { points=((0,0,0)); faces=(()); }") ==
        "2:37: error: expected a number, found ')'\n");
}

TEST_CASE("normals and materials are as many as the points") {
  CHECK(messages("trimesh { normals=((0,0,1)); points=((0,0,0),(1,0,0)); }") ==
        "2:19: error: the mesh has 1 normal but 2 points: give one for each point or none\n");
  CHECK(messages("trimesh { points=((0,0,0)); materials=({},{}); }") ==
        "2:39: error: the mesh has 2 materials but 1 point: give one for each point or none\n");
  CHECK(messages("trimesh { materials=({}); }") ==
        "2:21: error: the mesh has 1 material but 0 points: give one for each point or none\n");
}

TEST_CASE("several errors are found in one run") {
  CHECK(messages("camera { fov=x; position=(1,2); viewdir=(0,0,1); }\nsphere { material={ diffus=(1,0,0); "
                 "index=(1,2,3); } foo; }\nbox { }\ntranslate(1,2,box{})\npoint_light { colour=(1,1); }") ==
        "2:14: error: 'fov' takes a number, found 'x'\n"
        "2:30: error: 'position' takes three numbers: expected ',', found ')'\n"
        "3:21: error: unknown attribute 'diffus' in a material\n"
        "3:21: note: did you mean 'diffuse'?\n"
        "3:21: note: a material takes emissive, ambient, diffuse, specular, reflective, transmissive, "
        "shininess, index, name, absorb, glossiness, specular_model, bump and normal\n"
        "3:43: error: 'index' takes one number, not a list\n"
        "3:54: error: unknown attribute 'foo' in a sphere\n"
        "3:54: note: a sphere takes material and name\n"
        "5:15: error: translate takes three numbers and one object: expected a number, found 'box'\n"
        "6:26: error: 'colour' takes three numbers: expected ',', found ')'\n");
}
