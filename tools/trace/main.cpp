// The program: chooses the command. What is not the name of another command is `trace [options] scene.ray
// out.png`.
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>

#include "tools/trace/batch_command.hpp"
#include "tools/trace/exit_status.hpp"
#include "tools/trace/render_command.hpp"

int main(int argc, char** argv) {
  try {
    if (argc > 1 && std::strcmp(argv[1], "batch") == 0) return trace::batch_command(argc - 1, argv + 1);
    return trace::render_command(argc, argv);
  } catch (const std::bad_alloc&) {
    std::fputs("trace: error: out of memory\n", stderr);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "trace: error: %s\n", e.what());
  }
  return trace::exit_bad_input;
}
