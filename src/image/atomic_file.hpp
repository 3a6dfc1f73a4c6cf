// A file that appears whole or not at all.
//
// The bytes go to a file without a name (O_TMPFILE) in the directory of the target; commit() gives it the
// target's name. Whatever ends the program before that, even a signal, leaves neither half a picture nor
// rubbish behind, and needs no clean-up by the program. If the target exists already, commit() links the
// complete file as a hidden name and renames that over the target; only being killed between these two calls
// leaves the hidden file. Where the file system has no nameless files the hidden name is there from the
// start.
//
// A target that is not a regular file (/dev/stdout, a pipe) is written to directly, since it must not be
// replaced. A symbolic link is followed: its target is replaced, the link stays.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

namespace trace {

class AtomicFile {
 public:
  enum class Temporary { nameless, named };  // `named` is what old file systems get

  // Throws ImageError if the target is a directory or may not be written.
  explicit AtomicFile(const std::filesystem::path& target, Temporary temporary = Temporary::nameless);
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  // Without commit(): the bytes are dropped, the target is as it was.
  ~AtomicFile();

  // Whether there is nothing yet that others could see.
  bool is_nameless() const { return !direct_ && hidden_.empty(); }

  // Appends. Throws ImageError, for instance "no space left on device".
  void write(std::span<const std::uint8_t> bytes);

  // The target now holds what was written. Throws ImageError; the target is then as it was.
  void commit();

 private:
  void open_temporary(Temporary temporary);
  void link_hidden();

  std::filesystem::path target_;  // symbolic links resolved
  std::filesystem::path hidden_;  // the temporary's name as long as it has one
  int descriptor_ = -1;
  bool direct_ = false;    // the target itself is open
  bool replaces_ = false;  // there is a file already
};

}  // namespace trace
