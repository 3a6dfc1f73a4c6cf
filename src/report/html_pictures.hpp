// The pictures of a report: which are embedded under which number, which are linked.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace trace::html {

class Pictures {
 public:
  // `folder` is the page's.
  Pictures(bool embed, std::filesystem::path folder);

  // Where the page finds this picture: {"id": 3} if it is embedded, {"href": "a/b.png"} if linked.
  nlohmann::ordered_json place(const std::filesystem::path& file);

  // The same for the bytes of a PNG file, which are embedded in any case and must stay where they are until
  // write().
  nlohmann::ordered_json place(std::span<const std::uint8_t> png);

  // The embedded pictures as elements of the page, one at a time: <script type="image/png"> holding base64.
  // A picture that cannot be read is an element with the reason in data-error.
  void write(const std::function<void(std::string_view)>& out) const;

 private:
  std::size_t number(const std::filesystem::path& file);

  bool embed_;
  std::filesystem::path folder_;
  std::vector<std::variant<std::filesystem::path, std::span<const std::uint8_t>>> embedded_;
  std::map<std::string, std::size_t> by_name_, by_content_;
};

}  // namespace trace::html
