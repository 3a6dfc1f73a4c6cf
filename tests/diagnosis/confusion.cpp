#include "tests/diagnosis/confusion.hpp"

#include <fmt/format.h>

#include <chrono>

#include "comparison/diagnosis/diagnosis.hpp"
#include "comparison/diagnosis/diagnosis_pair.hpp"

namespace trace::test {

bool differ(const Raster& reference, const Raster& test) {
  const auto pair = make_pair(reference, test);
  return pair && pair->differing.size() >= least_pixels_to_judge;
}

void Confusion::record(const std::string& defect, const std::string& right, const Raster& reference,
                       const Raster& test) {
  if (rows_.find(defect) == rows_.end()) order_.push_back(defect);
  Row& row = rows_[defect];
  row.right = right;
  if (!differ(reference, test)) return;
  const auto begin = std::chrono::steady_clock::now();
  const auto diagnosis = diagnose(reference, test, {});
  const double took = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  seconds_ += took;
  longest_ = std::max(longest_, took);
  ++pairs_;
  ++row.pairs;
  ++row.said[diagnosis ? std::string(name(diagnosis->kind)) : "-"];
}

std::string Confusion::table() const {
  std::string text =
      "| defect | pairs that differ | right | nothing | another diagnosis |\n|---|---|---|---|---|\n";
  for (const std::string& defect : order_) {
    const Row& row = rows_.at(defect);
    std::string others;
    const auto count = [&](const std::string& said) {
      const auto found = row.said.find(said);
      return found == row.said.end() ? 0 : found->second;
    };
    for (const auto& [said, times] : row.said)
      if (said != row.right && said != "-")
        others += fmt::format("{}{} {}", others.empty() ? "" : ", ", said, times);
    const bool has_name = row.right != "-";
    text += fmt::format("| {} | {} | {} | {} | {} |\n", defect, row.pairs,
                        has_name ? fmt::format("{}", count(row.right)) : "", count("-"), others);
  }
  return text;
}

std::string Confusion::summary() const {
  return fmt::format("{} pairs; {:.1f} ms a pair in the mean, {:.1f} ms at most", pairs_,
                     1000 * seconds_ / pairs_, 1000 * longest_);
}

}  // namespace trace::test
