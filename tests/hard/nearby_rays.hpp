// Whether an answer in double is the true one, where truth is known for every ray in 113 digits.
//
// A ray in double stands for all that round to it: an answer is right if it is that of a ray whose origin and
// direction differ from the given ones by `band`, relative to the size of their coordinates. Where all of
// those agree that there is a hit (or none), so must the answer.
#pragma once

#include <optional>

#include "tests/hard/quad.hpp"
#include "tests/hard/row.hpp"

namespace trace::hard {

// The true t, or none.
using TrueHit = std::optional<Quad>;

// The answers of the ray and of twelve around it.
struct Around {
  bool any_hit = false, any_miss = false;
  Quad least = 0, most = 0;
  TrueHit exact;

  void add(const TrueHit& hit) {
    if (!hit) {
      any_miss = true;
    } else {
      least = any_hit && least < *hit ? least : *hit;
      most = any_hit && most > *hit ? most : *hit;
      any_hit = true;
    }
  }
  bool decided() const { return any_hit != any_miss; }
};

template <class Truth>
Around answers_around(const Truth& truth, const Ray& ray, double band) {
  const QuadRay given(ray);
  Around around;
  around.exact = truth(given);
  around.add(around.exact);
  const Vec3 size = glm::abs(ray.origin);
  const Quad shift = band * (1 + std::max({size.x, size.y, size.z})), turn = band;
  for (const int side : {-1, 1}) {
    for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}) {
      const QuadVec along(static_cast<double>(side) * axis);
      around.add(truth(QuadRay(given.origin + shift * along, given.direction)));
      around.add(truth(QuadRay(given.origin, given.direction + turn * along)));
    }
  }
  return around;
}

// Notes what an answer is worth: a lost hit, a wrong one, or its error. The error of t is that beyond what
// the rays around account for, relative to t; the answer is wrong where it exceeds `allowed`. The spread of
// those rays is a sample, so twice it is granted.
template <class Truth>
void note_answer(const Truth& truth, const Ray& ray, double band, bool hit, double t, double allowed,
                 Row& row) {
  ++row.rays;
  Around around = answers_around(truth, ray, band);
  const bool decided = around.decided();
  if (!hit) {
    if (!around.any_miss) ++row.misses;
    return;
  }
  if (!around.any_hit || !(t == t)) {
    ++row.wrong;
    return;
  }
  // Where few of the rays around hit, they say little of how far t may be off; those further around do.
  if (!decided) around = answers_around(truth, ray, 8 * band);
  const Quad spread = around.most - around.least;
  const Quad beyond = t < around.least ? around.least - t : (t > around.most ? t - around.most : Quad(0));
  // Between hit and miss the chord shrinks to nothing, past what the rays that do hit tell.
  const Quad granted = decided ? spread : 64 * spread;
  const Quad error =
      (beyond > granted ? beyond - granted : Quad(0)) / (magnitude(around.most) + Quad(1e-300));
  if (error > allowed) ++row.wrong;
  if (decided) row.note_error(static_cast<double>(error));
}

}  // namespace trace::hard
