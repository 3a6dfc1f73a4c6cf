#include "instruction_set/instruction_set.hpp"

#include <array>
#include <utility>

namespace trace {
namespace {

constexpr std::array<std::pair<std::string_view, InstructionSet>, 4> names{{
    {"baseline", InstructionSet::baseline},
    {"sse4", InstructionSet::sse4},
    {"avx2", InstructionSet::avx2},
    {"avx512", InstructionSet::avx512},
}};

}  // namespace

// What Highway's targets of the same names take for granted (F16C, which they do too, came before AVX2).
InstructionSet best_instruction_set() {
  const bool sse4 = __builtin_cpu_supports("sse4.1") && __builtin_cpu_supports("sse4.2") &&
                    __builtin_cpu_supports("pclmul") && __builtin_cpu_supports("aes");
  if (!sse4) return InstructionSet::baseline;
  const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                    __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
  if (!avx2) return InstructionSet::sse4;
  const bool avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
                      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw");
  return avx512 ? InstructionSet::avx512 : InstructionSet::avx2;
}

std::string_view name_of(InstructionSet set) {
  return names[static_cast<std::size_t>(set)].first;
}

std::optional<InstructionSet> instruction_set_named(std::string_view name) {
  for (const auto& [text, set] : names) {
    if (text == name) return set;
  }
  return std::nullopt;
}

}  // namespace trace
