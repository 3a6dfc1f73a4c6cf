#include "tests/support/run_python.hpp"

#include <sys/wait.h>

#include <cstdlib>

#include "tests/support/temporary_folder.hpp"

namespace trace::test {
namespace {

// The schemas refer to one another by their file names.
constexpr const char* validate = R"(
import json, pathlib, sys
import jsonschema
folder = pathlib.Path(sys.argv[1])
schemas = {file.name: json.loads(file.read_text()) for file in folder.glob("*.json")}
for schema in schemas.values():
    jsonschema.Draft7Validator.check_schema(schema)
schema = schemas[sys.argv[2]]
resolver = jsonschema.RefResolver(schema["$id"], schema, store=schemas)
def refuse(word):
    raise ValueError(word + " is not JSON")
document = json.loads(sys.stdin.buffer.read().decode("utf-8"), parse_constant=refuse)
for fault in jsonschema.Draft7Validator(schema, resolver=resolver).iter_errors(document):
    print("/".join(map(str, fault.absolute_path)) + ": " + fault.message)
)";

}  // namespace

PythonResult run_python(const std::string& program, const std::vector<std::string>& arguments,
                        const std::string& input) {
  const TemporaryFolder folder;
  write_text(folder / "program.py", program);
  write_text(folder / "in", input);
  std::string command = "cd '" + folder.path().string() + "' && /usr/bin/python3 program.py";
  for (const std::string& argument : arguments) command += " '" + argument + "'";
  command += " <in >out 2>&1";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_text(folder / "out")};
}

std::string schema_faults(const std::string& schema, const std::string& json) {
  const PythonResult result = run_python(validate, {TRACE_SOURCE_DIR "/docs/schemas", schema}, json);
  return result.status == 0 ? result.output : "python: " + result.output;
}

}  // namespace trace::test
