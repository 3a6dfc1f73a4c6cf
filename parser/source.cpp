#include "parser/source.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace trace::parser {

namespace {

constexpr std::uint64_t largest_file = 0xffffffffu;

[[noreturn]] void fail(const std::string& name, const std::string& reason) {
  throw std::runtime_error("cannot read '" + name + "': " + reason);
}

std::string reason_of(int error) {
  switch (error) {
    case ENOENT:
      return "no such file";
    case EACCES:
      return "permission denied";
    case EISDIR:
      return "it is a directory";
    default:
      return std::generic_category().message(error);
  }
}

// A file descriptor that is closed at the end of its scope. Standard input stays open.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ > STDIN_FILENO) ::close(number_);
  }
  int number() const { return number_; }

 private:
  int number_;
};

// Everything a pipe, a terminal or any other file that cannot be mapped gives.
std::string read_all(int descriptor, const std::string& name) {
  std::string text;
  std::size_t used = 0;
  for (;;) {
    if (text.size() - used < 65536) text.resize(std::max<std::size_t>(1 << 18, text.size() * 2));
    const ssize_t got = ::read(descriptor, text.data() + used, text.size() - used);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail(name, reason_of(errno));
    if (got == 0) break;
    used += static_cast<std::size_t>(got);
    if (used > largest_file) fail(name, "it is larger than 4 GiB");
  }
  text.resize(used);
  return text;
}

}  // namespace

// The text is either `owned` or mapped at `mapping`; both ways NUL bytes follow it (see text_padding).
struct Source::Contents {
  std::string name;
  std::filesystem::path directory = ".";
  std::string owned;
  char* mapping = nullptr;
  std::size_t mapping_size = 0;
  std::size_t size = 0;

  Contents() = default;
  Contents(const Contents&) = delete;
  Contents& operator=(const Contents&) = delete;
  ~Contents() {
    if (mapping != nullptr) ::munmap(mapping, mapping_size);
  }

  void own(std::string text) {
    size = text.size();
    owned = std::move(text);
    owned.append(text_padding, '\0');
  }

  // The file over the first pages of an anonymous mapping that is one page longer: whatever the file's size,
  // zero bytes follow it. False where the file system cannot map.
  bool map(int descriptor, std::size_t file_size) {
    const auto page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
    const std::size_t total = (file_size / page + 2) * page;
    void* const place = ::mmap(nullptr, total, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (place == MAP_FAILED) return false;
    mapping = static_cast<char*>(place);
    mapping_size = total;
    if (::mmap(place, file_size, PROT_READ, MAP_PRIVATE | MAP_FIXED | MAP_POPULATE, descriptor, 0) ==
        MAP_FAILED)
      return false;
    ::madvise(place, file_size, MADV_SEQUENTIAL);
    size = file_size;
    return true;
  }

  std::string_view text() const { return {size != 0 && mapping != nullptr ? mapping : owned.data(), size}; }
};

Source::Source(std::unique_ptr<Contents> contents) : contents_(std::move(contents)) {}
Source::Source(Source&&) noexcept = default;
Source& Source::operator=(Source&&) noexcept = default;
Source::~Source() = default;

Source Source::from_file(const std::string& path) {
  auto contents = std::make_unique<Contents>();
  const bool standard_input = path == "-";
  contents->name = standard_input ? "<stdin>" : path;
  const Descriptor file(standard_input ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.number() < 0) fail(path, reason_of(errno));

  struct stat status {};
  if (::fstat(file.number(), &status) != 0) fail(contents->name, reason_of(errno));
  if (S_ISDIR(status.st_mode)) fail(contents->name, reason_of(EISDIR));
  const bool regular = S_ISREG(status.st_mode) && !standard_input;
  const auto size = static_cast<std::uint64_t>(std::max<off_t>(status.st_size, 0));
  if (regular && size > largest_file) fail(contents->name, "it is larger than 4 GiB");
  if (!standard_input && std::filesystem::path(path).has_parent_path()) {
    contents->directory = std::filesystem::path(path).parent_path();
  }
  // Files of size 0 may still have a text (/proc), so they are read.
  if (!regular || size == 0 || !contents->map(file.number(), size)) {
    contents->own(read_all(file.number(), contents->name));
  }
  return Source(std::move(contents));
}

Source Source::from_text(std::string name, std::string text) {
  if (text.size() > largest_file) fail(name, "it is larger than 4 GiB");
  auto contents = std::make_unique<Contents>();
  contents->name = std::move(name);
  contents->own(std::move(text));
  return Source(std::move(contents));
}

const std::string& Source::name() const {
  return contents_->name;
}
std::string_view Source::text() const {
  return contents_->text();
}
void Source::release_memory() const {
  if (contents_->mapping != nullptr && contents_->owned.empty())
    ::madvise(contents_->mapping, contents_->mapping_size, MADV_DONTNEED);
}
std::filesystem::path Source::directory() const {
  return contents_->directory;
}

std::uint32_t Source::line_begin(std::uint32_t offset) const {
  const std::string_view all = text();
  std::size_t at = std::min<std::size_t>(offset, all.size());
  // Between CR and LF the line has not ended yet.
  if (at > 0 && at < all.size() && all[at] == '\n' && all[at - 1] == '\r') --at;
  while (at > 0 && all[at - 1] != '\n' && all[at - 1] != '\r') --at;
  return static_cast<std::uint32_t>(at);
}

std::string_view Source::line_at(std::uint32_t offset) const {
  const std::string_view all = text();
  const std::size_t begin = line_begin(offset);
  const std::size_t end = std::min(all.find_first_of("\r\n", begin), all.size());
  return all.substr(begin, end - begin);
}

Position Source::position(std::uint32_t offset) const {
  const std::string_view before = text().substr(0, line_begin(offset));
  Position result;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const bool ends =
        before[i] == '\n' || (before[i] == '\r' && !(i + 1 < before.size() && before[i + 1] == '\n'));
    result.line += ends ? 1 : 0;
  }
  result.column = std::min<std::size_t>(offset, text().size()) - before.size() + 1;
  return result;
}

}  // namespace trace::parser
