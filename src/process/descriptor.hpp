// An open file that is closed with its owner.
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <utility>

namespace trace {

class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    if (this != &other) {
      reset();
      number_ = std::exchange(other.number_, -1);
    }
    return *this;
  }
  ~Descriptor() { reset(); }

  int get() const { return number_; }
  explicit operator bool() const { return number_ >= 0; }
  void reset() {
    if (number_ >= 0) close(std::exchange(number_, -1));
  }
  // Another number for the same open file; none where there is no room for one.
  Descriptor duplicate() const { return Descriptor(fcntl(number_, F_DUPFD_CLOEXEC, 3)); }

 private:
  int number_ = -1;
};

// The same open file with a number above those of standard input, output and error, where the numbers of a
// forked process are going to be rearranged. This process may itself have been started without these three.
inline Descriptor above_standard(Descriptor descriptor) {
  if (descriptor.get() > STDERR_FILENO || !descriptor) return descriptor;
  return descriptor.duplicate();
}

}  // namespace trace
