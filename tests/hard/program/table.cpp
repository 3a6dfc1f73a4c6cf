#include "tests/hard/program/table.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <nlohmann/json.hpp>
#include <ostream>

namespace trace::hard {
namespace {

std::string error_text(const Row& row) {
  return row.largest_error > 0 ? fmt::format("{:.1e}", row.largest_error) : "";
}

std::string digest_text(const Row& row) {
  return row.digest == 0 ? "" : fmt::format("{:016x}", row.digest);
}

}  // namespace

void print_lines(std::ostream& out, const Result& result) {
  fmt::print(out, "{}. {} ({:.1f} s)\n", result.hard.row, result.hard.name, result.seconds);
  for (const Row& row : result.rows) {
    fmt::print(
        out,
        "   {:<18} {:<34} rays {:>10} misses {:>8} self-hits {:>8} parity {:>8} wrong {:>8} error {:>7} {}\n",
        row.form, row.workload, row.rays, row.misses, row.self_hits, row.parity, row.wrong, error_text(row),
        digest_text(row));
  }
}

void print_digests(std::ostream& out, const Result& result) {
  for (const Row& row : result.rows) {
    if (row.form == ours && row.digest != 0) {
      fmt::print(out, "{}\t{}\t{}\t{}\n", result.hard.row, result.hard.name, row.workload, digest_text(row));
    }
  }
}

void print_markdown(std::ostream& out, const std::vector<Result>& results) {
  for (const Result& result : results) {
    fmt::print(out, "## {}. {}\n\n{}\n\n", result.hard.row, result.hard.name, result.hard.says);
    fmt::print(
        out,
        "| form | workload | rays | misses | self-hits | parity | wrong | largest error of t | digest |\n");
    fmt::print(out, "|---|---|---|---|---|---|---|---|---|\n");
    for (const Row& row : result.rows) {
      fmt::print(out, "| {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", row.form, row.workload, row.rays,
                 row.misses, row.self_hits, row.parity, row.wrong, error_text(row), digest_text(row));
    }
    fmt::print(out, "\n");
  }
}

void print_json(std::ostream& out, const std::vector<Result>& results) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const Result& result : results) {
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const Row& row : result.rows) {
      rows.push_back({{"form", row.form},
                      {"workload", row.workload},
                      {"rays", row.rays},
                      {"misses", row.misses},
                      {"self_hits", row.self_hits},
                      {"parity", row.parity},
                      {"wrong", row.wrong},
                      {"largest_error", row.largest_error},
                      {"digest", digest_text(row)}});
    }
    all.push_back(
        {{"row", result.hard.row}, {"name", result.hard.name}, {"seconds", result.seconds}, {"rows", rows}});
  }
  out << all.dump(2) << '\n';
}

}  // namespace trace::hard
