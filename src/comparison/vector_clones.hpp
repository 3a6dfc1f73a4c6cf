// TRACE_VECTOR_CLONES before a function compiles it twice, for AVX2 and for every x86-64, of which the
// machine it runs on takes the better. Results are the same: neither clone fuses multiplications with
// additions or changes their order. Nothing with sanitizers, which do not work before the choice is made, nor
// on other machines.
#pragma once

#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) && defined(__OPTIMIZE__) && defined(__GNUC__) && \
    !defined(__clang__)
#define TRACE_VECTOR_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define TRACE_VECTOR_CLONES
#endif
