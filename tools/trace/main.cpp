// The program: chooses the command by its first argument. What is not the name of another command is
// `trace [options] scene.ray out.png`; a scene of such a name is written ./diff.
#include <cstdio>
#include <exception>
#include <new>
#include <string_view>

#include "image/openimageio.hpp"
#include "tools/trace/batch/batch_command.hpp"
#include "tools/trace/diff/diff_command.hpp"
#include "tools/trace/exit_status.hpp"
#include "tools/trace/render/render_command.hpp"
#include "tools/trace/study/study_command.hpp"

namespace {

int run(int argc, char** argv) {
  const std::string_view command = argc > 1 ? argv[1] : "";
  if (command != "batch" && command != "diff" && command != "study") return trace::render_command(argc, argv);
  // They may come upon a picture of any format when they have shown or written something.
  trace::settle_openimageio();
  if (command == "batch") return trace::batch_command(argc - 1, argv + 1);
  if (command == "diff") return trace::diff_command(argc - 1, argv + 1);
  return trace::study_command(argc - 1, argv + 1);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::bad_alloc&) {
    std::fputs("trace: error: out of memory\n", stderr);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "trace: error: %s\n", e.what());
  }
  return trace::exit_bad_input;
}
