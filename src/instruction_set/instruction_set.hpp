// The sets of vector instructions that kernels are compiled for.
//
// Every kernel computes the same bits with each of them: only additions, subtractions, multiplications,
// divisions and square roots of doubles, which IEEE 754 rounds the same in any width.
#pragma once

#include <optional>
#include <string_view>

namespace trace {

// Ordered: each has what the ones before it have.
enum class InstructionSet {
  baseline,  // what every x86-64 processor has: no packets, rays are traced one at a time
  sse4,      // 2 doubles at once
  avx2,      // 4
  avx512,    // 8
};

// The best that this machine and its system support.
InstructionSet best_instruction_set();

std::string_view name_of(InstructionSet set);
std::optional<InstructionSet> instruction_set_named(std::string_view name);

}  // namespace trace
