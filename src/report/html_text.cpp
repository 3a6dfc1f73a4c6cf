#include "report/html_text.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace trace::html {
namespace {

constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

bool plain_in_url(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '.' ||
         c == '_' || c == '~' || c == '/';
}

}  // namespace

std::string escape(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

std::string script_json(const nlohmann::ordered_json& value) {
  // Outside its strings JSON has no "<", so replacing every one keeps the meaning.
  const std::string plain = value.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  std::string safe;
  safe.reserve(plain.size());
  for (const char c : plain) {
    if (c == '<')
      safe += "\\u003c";
    else
      safe += c;
  }
  return safe;
}

std::string url_path(std::string_view path) {
  std::string url;
  for (const char c : path) {
    if (plain_in_url(c))
      url += c;
    else
      url += fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return url;
}

std::string base64(std::span<const std::uint8_t> bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t have = bytes.size() - i;
    const unsigned group =
        bytes[i] * 65536u + (have > 1 ? bytes[i + 1] * 256u : 0u) + (have > 2 ? bytes[i + 2] : 0u);
    text += alphabet[group >> 18];
    text += alphabet[(group >> 12) & 63];
    text += have > 1 ? alphabet[(group >> 6) & 63] : '=';
    text += have > 2 ? alphabet[group & 63] : '=';
  }
  return text;
}

}  // namespace trace::html
