// The program: chooses the command by its first argument. What is not the name of another command is
// `trace [options] scene.ray out.png`; a scene of such a name is written ./diff.
#include <cstdio>
#include <exception>
#include <new>
#include <string_view>

#include "tools/trace/batch/batch_command.hpp"
#include "tools/trace/diff/diff_command.hpp"
#include "tools/trace/exit_status.hpp"
#include "tools/trace/render/render_command.hpp"

int main(int argc, char** argv) {
  try {
    const std::string_view command = argc > 1 ? argv[1] : "";
    if (command == "batch") return trace::batch_command(argc - 1, argv + 1);
    if (command == "diff") return trace::diff_command(argc - 1, argv + 1);
    return trace::render_command(argc, argv);
  } catch (const std::bad_alloc&) {
    std::fputs("trace: error: out of memory\n", stderr);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "trace: error: %s\n", e.what());
  }
  return trace::exit_bad_input;
}
