// Counts of defects and what was said of them.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "image/raster.hpp"

namespace trace::test {

class Confusion {
 public:
  // Diagnoses the pair. `right` is the name of the diagnosis that the defect should get, "-" for none. Pairs
  // that hardly differ are counted apart.
  void record(const std::string& defect, const std::string& right, const Raster& reference,
              const Raster& test);

  // A Markdown table with a row a defect, in the order they were first recorded.
  std::string table() const;
  // "3449 pairs; 4.1 ms a pair in the mean, 20.3 ms at most"
  std::string summary() const;

 private:
  struct Row {
    std::string right;
    int pairs = 0;  // that differ
    std::map<std::string, int> said;
  };

  std::vector<std::string> order_;
  std::map<std::string, Row> rows_;
  int pairs_ = 0;
  double seconds_ = 0, longest_ = 0;
};

// Whether there is anything to diagnose.
bool differ(const Raster& reference, const Raster& test);

}  // namespace trace::test
