// The text of one scene file, and the places in it.
//
// A place is a pair of byte offsets; lines and columns are worked out only when a message needs them, so the
// scanner never counts. Lines end at LF, CR LF or a lone CR. Lines and columns count from 1; columns count
// bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace trace::parser {

// Half-open range of byte offsets [begin, end). Files are limited to 4 GiB - 1 so that 32 bits hold them.
struct Span {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;

  friend bool operator==(const Span&, const Span&) = default;
};

// So many NUL bytes follow the text of every Source, so that a reader may look ahead without asking for the
// end.
inline constexpr std::size_t text_padding = 16;

struct Position {
  std::uint64_t line = 1;
  std::uint64_t column = 1;
};

class Source {
 public:
  // Reads the whole file (mapped where the system can). "-" reads standard input.
  // Throws std::runtime_error whose text names the file and the reason (missing, a directory, over 4 GiB,
  // ...).
  static Source from_file(const std::string& path);
  // A scene given as text; `name` stands for the file in messages.
  static Source from_text(std::string name, std::string text);

  Source(Source&&) noexcept;
  Source& operator=(Source&&) noexcept;
  ~Source();

  const std::string& name() const;  // as the user wrote it; "<stdin>" for standard input
  std::string_view text() const;    // text_padding NUL bytes follow it
  // For when little more of the text will be read: gives the memory of a mapped file back. What is read all
  // the same comes from the file again.
  void release_memory() const;
  // The folder that relative names in the scene start from ("." for text and standard input).
  std::filesystem::path directory() const;

  Position position(std::uint32_t offset) const;
  // The line that holds `offset`, without its line end.
  std::string_view line_at(std::uint32_t offset) const;
  std::uint32_t line_begin(std::uint32_t offset) const;

 private:
  struct Contents;
  explicit Source(std::unique_ptr<Contents> contents);
  std::unique_ptr<Contents> contents_;
};

}  // namespace trace::parser
