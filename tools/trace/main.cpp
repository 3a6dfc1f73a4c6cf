// The program: chooses the command. What is not the name of another command is `trace [options] scene.ray
// out.png`.
#include <cstdio>
#include <exception>
#include <new>

#include "tools/trace/exit_status.hpp"
#include "tools/trace/render_command.hpp"

int main(int argc, char** argv) {
  try {
    return trace::render_command(argc, argv);
  } catch (const std::bad_alloc&) {
    std::fputs("trace: error: out of memory\n", stderr);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "trace: error: %s\n", e.what());
  }
  return trace::exit_bad_input;
}
