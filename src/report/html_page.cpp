#include "report/html_page.hpp"

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>

#include "image/atomic_file.hpp"
#include "report/html_assets.hpp"
#include "report/html_text.hpp"

namespace trace::html {

void write_page(const Page& page, const nlohmann::ordered_json& data, const Pictures& pictures,
                const std::filesystem::path& file) {
  AtomicFile target(file);
  const auto out = [&](std::string_view text) {
    target.write(std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
  };
  const auto put = [&](std::string_view name) {
    if (name == "title") out(escape(page.title));
    if (name == "without-script") out(escape(page.without_script));
    if (name == "style") {
      out(library_style());
      out(page.style);
    }
    if (name == "libraries") out(libraries());
    if (name == "script") out(page.script);
    if (name == "report") out(script_json(data));
    if (name == "pictures") pictures.write(out);
  };

  std::string_view rest = html::page();
  for (std::size_t mark; (mark = rest.find("{{")) != rest.npos;) {
    const std::size_t end = rest.find("}}", mark);
    out(rest.substr(0, mark));
    put(rest.substr(mark + 2, end - mark - 2));
    rest.remove_prefix(end + 2);
  }
  out(rest);
  target.commit();
}

std::string text_of(const nlohmann::ordered_json& object, const char* key) {
  const auto member = object.find(key);
  return member != object.end() && member->is_string() ? member->get<std::string>() : "";
}

std::filesystem::path folder_of(const std::filesystem::path& file) {
  return std::filesystem::absolute(file).parent_path();
}

}  // namespace trace::html
