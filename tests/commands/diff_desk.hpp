// A folder to compare pictures in.
#pragma once

#include "image/image.hpp"
#include "tests/support/picture_table.hpp"

namespace trace::test {

struct DiffDesk {
  TemporaryFolder folder;

  std::filesystem::path operator/(std::string_view name) const { return folder / name; }
  bool has(std::string_view name) const { return std::filesystem::exists(folder / name); }

  // `trace diff` with these arguments, which are split at blanks.
  Outcome diff(const std::string& arguments) const { return run_trace(folder.path(), "diff " + arguments); }

  // A picture of one gray; the one pixel (2, 3) may have a red of its own. Folders are made.
  void put(const std::string& name, int gray, int width = 8, int height = 8) const {
    put(name, gray, gray, width, height);
  }
  void put(const std::string& name, int gray, int red, int width, int height) const {
    Image image{width, height, {}};
    image.rgb.assign(static_cast<std::size_t>(width * height * 3), static_cast<std::uint8_t>(gray));
    image.rgb[static_cast<std::size_t>((3 * width + 2) * 3)] = static_cast<std::uint8_t>(red);
    const std::filesystem::path file = folder / name;
    std::filesystem::create_directories(file.parent_path());
    write_image(file, image);
  }
};

}  // namespace trace::test
