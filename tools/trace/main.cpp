// The program: chooses the command by its first argument. What is not the name of another command is
// `trace [options] scene.ray out.png`; a scene of such a name is written ./diff.
#include <string_view>

#include "tools/trace/batch/batch_command.hpp"
#include "tools/trace/diff/diff_command.hpp"
#include "tools/trace/render/render_command.hpp"
#include "tools/trace/reported.hpp"

int main(int argc, char** argv) {
  return trace::reported([&] {
    const std::string_view command = argc > 1 ? argv[1] : "";
    if (command == "batch") return trace::batch_command(argc - 1, argv + 1);
    if (command == "diff") return trace::diff_command(argc - 1, argv + 1);
    return trace::render_command(argc, argv);
  });
}
