// Many primary rays at once, in packets as wide as the processor's vectors.
//
// The pictures are those of WhittedTracer, bit by bit: each lane computes what it computes. A sample in which
// anything goes beyond plain finite numbers is marked, and left to it.
#pragma once

#include "instruction_set/instruction_set.hpp"
#include "shading/ray_counts.hpp"
#include "shading/traced_scene.hpp"

namespace trace {

// Rays of one camera and what they see. Neighbours should lie near each other in the picture.
struct SampleBatch {
  static constexpr std::size_t capacity = 256;

  std::size_t count = 0;
  // Directions, not yet of unit length; of an orthographic camera where the rays start from the eye.
  alignas(64) double x[capacity], y[capacity], z[capacity];
  // The results. Those marked count neither here nor in the ray counts.
  alignas(64) double red[capacity], green[capacity], blue[capacity];
  bool left_out[capacity];

  void add(const Vec3& direction) {
    x[count] = direction.x;
    y[count] = direction.y;
    z[count] = direction.z;
    ++count;
  }
  Rgb color(std::size_t i) const { return {red[i], green[i], blue[i]}; }
};

class PacketTracer {
 public:
  // Refers to its arguments, which must outlive it. `counts` is for one thread. The baseline leaves out all
  // samples; so does every set in a scene that is not drawn by the rules of utexas (scene/dialect_rules.hpp).
  PacketTracer(const TracedScene& world, InstructionSet set, RayCounts& counts);

  void trace(SampleBatch& batch, int depth) const;

 private:
  const TracedScene& world_;
  InstructionSet set_;
  RayCounts& counts_;
};

}  // namespace trace
