// The program in its wholly static form (start_over.hpp): renders one picture, and leaves the other commands,
// whose code and initialization would be read for nothing whenever a picture is rendered, to trace_dynamic.
#include <cstdio>
#include <string_view>

#include "image/start_over.hpp"
#include "tools/trace/render/render_command.hpp"
#include "tools/trace/reported.hpp"

int main(int argc, char** argv) {
  return trace::reported([&]() -> int {
    const std::string_view command = argc > 1 ? argv[1] : "";
    if (command == "batch" || command == "diff") {
      trace::start_over_dynamically();
      std::fprintf(stderr, "trace: error: this command needs %s beside the program\n",
                   trace::dynamic_program_name);
      return command == "diff" ? int{trace::diff_file} : int{trace::batch_failed};
    }
    return trace::render_command(argc, argv);
  });
}
