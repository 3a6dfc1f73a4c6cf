// Scenes with something wrong in them, made at random from scenes that are right.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace trace::test {

// One to four changes: bytes changed, lost or doubled, words and numbers put in place of others, pieces of
// another scene put in, the end cut off. `scenes` is what pieces are taken from. Deterministic.
std::string mutated(const std::string& scene, const std::vector<std::string>& scenes,
                    std::mt19937_64& random);

}  // namespace trace::test
