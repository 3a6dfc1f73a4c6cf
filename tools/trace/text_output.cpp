#include "tools/trace/text_output.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "image/image.hpp"
#include "report/plain_text.hpp"

namespace trace {
namespace {

[[noreturn]] void fail(const std::string& name, const ImageError& e) {
  throw ImageError(fmt::format("cannot write '{}': {}", name, e.what()));
}

}  // namespace

TextOutput::TextOutput(const std::string& name) : name_(name) {
  if (!wanted() || is_standard_output()) return;
  try {
    file_.emplace(name_);
  } catch (const ImageError& e) {
    fail(name_, e);
  }
}

void TextOutput::write(std::string_view text) {
  if (is_standard_output()) return write_standard_output(text);
  if (!file_) return;
  try {
    file_->write({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    file_->commit();
  } catch (const ImageError& e) {
    fail(name_, e);
  }
  file_.reset();
}

void write_standard_output(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    throw ImageError(fmt::format("cannot write standard output: {}", std::strerror(errno)));
}

void print_errors(std::string_view text) {
  const std::string shown = terminal_text(text);
  std::fwrite(shown.data(), 1, shown.size(), stderr);
  std::fflush(stderr);
}

std::string terminal_text(std::string_view text) {
  std::string result;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte < 0x20 && c != '\n' && c != '\t') || byte == 0x7f) {
      result += fmt::format("\\x{:02x}", byte);
    } else {
      result += c;
    }
  }
  return valid_utf8(result);
}

}  // namespace trace
