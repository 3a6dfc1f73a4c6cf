#include "instruction_set/instruction_set.hpp"

#include <array>
#include <utility>

// Where the C library tells what it found out about the processor when the program started (glibc 2.33), it
// is asked.
// __builtin_cpu_supports asks the processor again, also in programs that never come to call it: ten CPUID
// instructions, and on a virtual machine each is a call of the host, four microseconds.
#if __has_include(<sys/platform/x86.h>) && !defined(__clang__)  // its C++ does not know the header's _Bool
#include <sys/platform/x86.h>
#define TRACE_PROCESSOR_HAS(library_name, compiler_name) CPU_FEATURE_ACTIVE(library_name)
#else
#define TRACE_PROCESSOR_HAS(library_name, compiler_name) __builtin_cpu_supports(compiler_name)
#endif

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
  const bool sse4 = TRACE_PROCESSOR_HAS(SSE4_1, "sse4.1") && TRACE_PROCESSOR_HAS(SSE4_2, "sse4.2") &&
                    TRACE_PROCESSOR_HAS(PCLMULQDQ, "pclmul") && TRACE_PROCESSOR_HAS(AES, "aes");
  if (!sse4) return InstructionSet::baseline;
  const bool avx2 = TRACE_PROCESSOR_HAS(AVX2, "avx2") && TRACE_PROCESSOR_HAS(FMA, "fma") &&
                    TRACE_PROCESSOR_HAS(BMI1, "bmi") && TRACE_PROCESSOR_HAS(BMI2, "bmi2");
  if (!avx2) return InstructionSet::sse4;
  const bool avx512 = TRACE_PROCESSOR_HAS(AVX512F, "avx512f") && TRACE_PROCESSOR_HAS(AVX512VL, "avx512vl") &&
                      TRACE_PROCESSOR_HAS(AVX512DQ, "avx512dq") && TRACE_PROCESSOR_HAS(AVX512BW, "avx512bw");
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
