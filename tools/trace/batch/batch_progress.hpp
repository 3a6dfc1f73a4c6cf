// What a person sees of a batch while it runs: one line on a terminal that changes in place, or else a plain
// line for each finished scene. Messages of scenes that failed stay on the screen either way. All of it goes
// to standard error.
#pragma once

#include <chrono>
#include <string>

#include "batch/batch.hpp"

namespace trace {

class BatchProgress : public BatchObserver {
 public:
  struct Style {
    bool quiet = false;     // nothing but messages of errors
    bool terminal = false;  // one line in place
    bool color = false;
    int columns = 80;                            // of the terminal
    static Style of_standard_error(bool quiet);  // heeds NO_COLOR
  };

  explicit BatchProgress(const Style& style, bool several_renderers)
      : style_(style), several_renderers_(several_renderers) {}
  ~BatchProgress() override;

  void finished(const Record& record, const BatchStatus& status) override;
  void tick(const BatchStatus& status) override;

 private:
  void show(const std::string& text);
  void clear_line();

  Style style_;
  bool several_renderers_;
  bool line_shown_ = false;
  std::chrono::steady_clock::time_point last_tick_{};
};

// "simple/box.ray: identical, 21 ms", "(student)" behind the name where there are several renderers.
std::string result_line(const Record& record, bool with_renderer);

// "[12/68] 13.1 Mrays/s, 4 s left, 1 failure: simple/box.ray polymesh/dragon.ray", cut to so many columns.
std::string status_line(const BatchStatus& status, int columns);

}  // namespace trace
