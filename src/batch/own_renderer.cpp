#include "batch/own_renderer.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <chrono>

#include "batch/fingerprint.hpp"
#include "batch/run_job.hpp"
#include "batch/shared_images.hpp"
#include "loading/scene_loader.hpp"
#include "rendering/render.hpp"

namespace trace {
namespace {

double cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

// What went wrong goes into `messages`; false where there is no picture.
bool render_to_file(const Job& job, const parser::Source& source, SharedImages& images, std::string& messages,
                    std::uint64_t& rays) {
  LoadedScene loaded = load_scene(source, job.options, images);
  messages += loaded.messages;
  if (!loaded.scene) return false;
  messages += add_cube_map(*loaded.scene, job.cube_map, images);
  for (const auto& [file, hash] : images.asked()) {
    std::error_code ignored;
    if (std::filesystem::equivalent(file, job.picture, ignored)) {
      messages +=
          fmt::format("{}: error: its picture would replace '{}', which the scene uses\n", job.scene, file);
      return false;
    }
  }
  const SceneTree tree(*loaded.scene, job.options.threads, job.options.instruction_set);
  Progress progress;
  const Rendered rendered = render(*loaded.scene, tree, job.options, progress);
  rays = rendered.rays.total();
  if (rendered.non_finite.count > 0) {
    messages += fmt::format("{}: warning: {}\n", job.scene, to_text(rendered.non_finite));
  }
  try {
    write_image(job.picture, rendered.image);
  } catch (const ImageError& e) {
    messages += fmt::format("trace: error: cannot write '{}': {}\n", job.picture.string(), e.what());
    return false;
  }
  return true;
}

}  // namespace

void draw(const Job& job, BlobExchange& exchange, Record& record) {
  const auto begin = std::chrono::steady_clock::now();
  const double cpu_begin = cpu_seconds();
  SharedImages images(exchange);
  std::string messages;
  std::uint64_t rays = 0;
  bool done = false;
  Record inputs = Record::array();
  try {
    const parser::Source source = parser::Source::from_file(job.scene);
    inputs.push_back(input(job.scene, content_hash(source.text())));
    done = render_to_file(job, source, images, messages, rays);
  } catch (const std::bad_alloc&) {
    throw;  // the limit: the supervisor knows what to say
  } catch (const std::exception& e) {
    messages += fmt::format("trace: error: {}\n", e.what());
  }
  for (const auto& [file, hash] : images.asked()) inputs.push_back(input(file, hash));
  record["outcome"] = done ? outcome::rendered : outcome::failed;
  record["message"] = messages;
  record["seconds"] = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  record["cpu_seconds"] = cpu_seconds() - cpu_begin;
  record["rays"] = rays;
  record["inputs"] = std::move(inputs);
}

}  // namespace trace
