// Text made safe for the places of an HTML file it is put in.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>

namespace trace::html {

// For text and for attributes in double quotes.
std::string escape(std::string_view text);

// JSON for inside <script type="application/json">: "<" is \u003c, so that nothing in it ends the element or
// begins a comment. Text that is not UTF-8 gets replacement characters.
std::string script_json(const nlohmann::ordered_json& value);

// A relative URL for a path: separators and unreserved characters (RFC 3986, 2.3) as they are, the rest in
// per cent.
std::string url_path(std::string_view path);

// RFC 4648, section 4, padded.
std::string base64(std::span<const std::uint8_t> bytes);

}  // namespace trace::html
