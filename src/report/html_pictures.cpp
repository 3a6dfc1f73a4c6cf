#include "report/html_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>
#include <system_error>
#include <utility>

#include "image/image.hpp"
#include "report/html_picture_data.hpp"
#include "report/html_text.hpp"

namespace trace::html {

Pictures::Pictures(bool embed, std::filesystem::path folder) : embed_(embed), folder_(std::move(folder)) {}

std::size_t Pictures::number(const std::filesystem::path& file) {
  const auto [known, is_new] = by_name_.try_emplace(file.string(), embedded_.size());
  if (!is_new) return known->second;
  try {
    const auto [same, first] = by_content_.try_emplace(fingerprint(file), embedded_.size());
    if (!first) return known->second = same->second;
  } catch (const ImageError&) {  // write() will say why
  }
  embedded_.emplace_back(file);
  return known->second;
}

nlohmann::ordered_json Pictures::place(const std::filesystem::path& file) {
  std::error_code error;
  if (!embed_ && (shown_by_browsers(file) || !std::filesystem::exists(file, error))) {
    const auto relative = std::filesystem::relative(file, folder_, error);
    return {{"href", url_path((error ? file : relative).generic_string())}};
  }
  return {{"id", number(file)}};
}

nlohmann::ordered_json Pictures::place(std::span<const std::uint8_t> png) {
  const auto [known, is_new] = by_content_.try_emplace(fingerprint(png), embedded_.size());
  if (is_new) embedded_.emplace_back(png);
  return {{"id", known->second}};
}

void Pictures::write(const std::function<void(std::string_view)>& out) const {
  for (std::size_t i = 0; i < embedded_.size(); ++i) {
    out(fmt::format("<script type=\"image/png\" id=\"picture-{}\"", i));
    try {
      std::vector<std::uint8_t> read;
      auto bytes = std::span<const std::uint8_t>();
      if (const auto* file = std::get_if<std::filesystem::path>(&embedded_[i]))
        bytes = read = png_bytes(*file);
      else
        bytes = std::get<1>(embedded_[i]);
      out(">");
      constexpr std::size_t piece = std::size_t{3} << 16;  // whole groups of base64
      for (std::size_t begin = 0; begin < bytes.size(); begin += piece)
        out(base64(bytes.subspan(begin, std::min(piece, bytes.size() - begin))));
    } catch (const ImageError& error) {
      out(fmt::format(" data-error=\"{}\">", escape(error.what())));
    }
    out("</script>\n");
  }
}

}  // namespace trace::html
