#include "batch/foreign_renderer.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <map>
#include <set>

#include "batch/failure.hpp"
#include "batch/fingerprint.hpp"
#include "batch/run_job.hpp"
#include "image/raster.hpp"
#include "image/system_error.hpp"
#include "loading/scene_loader.hpp"
#include "process/command_line.hpp"
#include "process/run_program.hpp"

namespace trace {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view new_folder_prefix = ".trace-";

// Tells which pictures a scene names, without reading any.
class NamesOfImages : public ImageSource {
 public:
  SharedImage read(const fs::path& file) override {
    names_.insert_or_assign(file.string(), true);
    return share({1, 1, {0, 0, 0}});
  }
  std::string bytes(const fs::path& file, std::uint64_t limit) override {
    names_.insert_or_assign(file.string(), true);
    return ImageSource::bytes(file, limit);
  }
  bool exists(const fs::path& file) override {
    std::error_code ignored;
    names_.try_emplace(file.string(), false);
    return fs::exists(file, ignored);
  }
  const std::map<std::string, bool>& names() const { return names_; }

 private:
  std::map<std::string, bool> names_;
};

// What the picture depends on: the scene, its pictures as far as this program understands the scene, the
// program.
Record inputs_of(const Job& job) {
  Record inputs = Record::array();
  inputs.push_back(input(job.scene, file_hash(job.scene)));
  NamesOfImages images;
  load_scene(job.scene, job.options, images);
  for (const auto& [file, wanted] : images.names()) inputs.push_back(input(file, file_hash(file)));
  const fs::path program = find_program(job.renderer.command.front());
  if (!program.empty()) inputs.push_back(input(program, file_hash(program)));
  // "python3 ray.py {scene} {out}": the script too.
  for (std::size_t i = 1; i < job.renderer.command.size(); ++i) {
    std::error_code ignored;
    const fs::path word = job.renderer.command[i];
    if (fs::is_regular_file(word, ignored)) inputs.push_back(input(word, file_hash(word)));
  }
  return inputs;
}

// A new folder that goes away with everything in it.
class NewFolder {
 public:
  explicit NewFolder(const fs::path& in) {
    std::string name = (in / (std::string(new_folder_prefix) + "XXXXXX")).string();
    if (!mkdtemp(name.data()))
      throw ImageError(fmt::format("cannot make a folder in '{}': {}", in.string(), system_reason(errno)));
    path_ = name;
  }
  NewFolder(const NewFolder&) = delete;
  NewFolder& operator=(const NewFolder&) = delete;
  ~NewFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

// The file is on the disk and then has its new name.
void move_to(const fs::path& from, const fs::path& to) {
  const int descriptor = open(from.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor >= 0) {
    fsync(descriptor);
    close(descriptor);
  }
  fs::rename(from, to);
}

struct Finding {
  const char* outcome;
  std::string problem;  // empty where the picture is good
};

// What the program left at `out`. `begin` is when it was started.
Finding look_at(const fs::path& out, std::time_t begin) {
  struct stat state {};
  if (lstat(out.c_str(), &state) != 0) return {outcome::no_picture, "wrote no picture to {out}"};
  if (!S_ISREG(state.st_mode))
    return {outcome::bad_picture, "left something at {out} that is no file of its own"};
  // Two seconds for file systems whose times are that coarse.
  if (state.st_mtime < begin - 2)
    return {outcome::stale_picture, "left a picture that is older than its run: it has not drawn this one"};
  try {
    read_raster(out);
  } catch (const ImageError& e) {
    return {outcome::bad_picture, fmt::format("wrote a picture that cannot be read: {}", e.what())};
  }
  return {outcome::rendered, ""};
}

}  // namespace

std::vector<std::string> parse_renderer_command(const std::string& text) {
  try {
    std::vector<std::string> words = parse_command(text);
    fill_in(words, {{"scene", ""}, {"out", ""}, {"depth", ""}, {"width", ""}});
    for (const char* needed : {"{scene}", "{out}"}) {
      bool found = false;
      for (const std::string& word : words) found |= word.find(needed) != word.npos;
      if (!found) throw std::invalid_argument(fmt::format("the command needs the word {}", needed));
    }
    return words;
  } catch (const CommandError& e) {
    throw std::invalid_argument(e.what());
  }
}

void draw_with_program(const Job& job, Record& record) {
  record["inputs"] = inputs_of(job);
  const NewFolder folder(job.picture.parent_path());
  const fs::path out = folder.path() / job.picture.filename();
  const std::time_t begin = std::time(nullptr);
  ProgramOptions options;
  options.limits = job.limits;
  options.refuse_allocations = false;  // its own affair how much it reserves
  const ProgramResult result =
      run_program(fill_in(job.renderer.command, {{"scene", job.scene},
                                                 {"out", out.string()},
                                                 {"depth", fmt::format("{}", job.options.depth)},
                                                 {"width", fmt::format("{}", job.options.width)}}),
                  options);
  record["seconds"] = result.seconds;
  record["cpu_seconds"] = result.cpu_seconds;
  record["memory_mib"] = static_cast<double>(result.peak_memory_bytes) / (1 << 20);
  if (result.outcome != Outcome{Outcome::Kind::exited, 0}) {
    record["outcome"] = outcome_word(result.outcome);
    record["message"] = failure_message(job, job.renderer.name, result.outcome) + result.output;
    return;
  }
  const Finding finding = look_at(out, begin);
  record["outcome"] = finding.outcome;
  if (finding.problem.empty()) {
    move_to(out, job.picture);
  } else {
    record["message"] =
        fmt::format("{}: error: {} {}\n{}", job.scene, job.renderer.name, finding.problem, result.output);
  }
}

void remove_leftovers(const std::vector<Job>& jobs) {
  std::set<fs::path> folders;
  for (const Job& job : jobs) {
    if (!job.renderer.command.empty()) folders.insert(job.picture.parent_path());
  }
  FileImages files;
  for (const fs::path& folder : folders) {
    std::error_code ignored;
    for (const fs::path& entry : files.list(folder, ignored)) {
      const std::string name = entry.filename().string();
      if (name.starts_with(new_folder_prefix) && name.size() == new_folder_prefix.size() + 6)
        fs::remove_all(entry, ignored);
    }
  }
}

}  // namespace trace
