// A report as one HTML file: the frame that all pages share, filled with one report's data.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "report/html_pictures.hpp"

namespace trace::html {

struct Page {
  std::string title;
  std::string without_script;      // a sentence for where scripts are not run: where the results are besides
  std::string_view style, script;  // of html_assets.hpp
};

// `data` is what the page's script finds as JSON; `pictures` come last, so that the page can be used while
// they load. The file is replaced whole or left as it was (AtomicFile). Throws ImageError where it cannot be
// written.
void write_page(const Page& page, const nlohmann::ordered_json& data, const Pictures& pictures,
                const std::filesystem::path& file);

// The string member of that name; "" where there is none.
std::string text_of(const nlohmann::ordered_json& object, const char* key);

// Where a page lies, for links that are relative to it.
std::filesystem::path folder_of(const std::filesystem::path& file);

}  // namespace trace::html
