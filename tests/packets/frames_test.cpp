// Rays into objects, normals out of them and the test of bounds, for packets.
#include "tests/packets/same_bits.hpp"
#include "tests/support/scene_random.hpp"

using namespace trace;
using namespace trace::test;

namespace {

std::vector<Ray> random_rays(Random& random, double unit, int count) {
  std::vector<Ray> rays;
  for (int i = 0; i < count; ++i) {
    rays.push_back(random_ray(random, unit));
    if (random.below(2) == 0) continue;
    rays.back().origin_error = unit * std::pow(10.0, random.between(-17, -9));
    rays.back().least_t = unit * std::pow(10.0, random.between(-17, -9));
  }
  return rays;
}

}  // namespace

TEST_CASE("rays are carried into objects with the same bits in packets") {
  Random random(5);
  for (const double unit : {1.0, 1e-6, 100.0}) {
    int compared = 0, unusual = 0;
    const Scene scene = random_scene(random, 40, unit);
    for (const Frame& frame : scene.frames) {
      const auto rays = random_rays(random, unit, 50);
      for (const PacketKernels& kernels : packet_kernels()) {
        for_each_packet(rays, kernels.lanes, [&](std::span<const Ray> packet, std::size_t) {
          const auto found = kernels.object_rays(frame, packet);
          for (std::size_t i = 0; i < packet.size(); ++i) {
            ++compared;
            if (found[i].unusual) {
              ++unusual;
              continue;
            }
            const ObjectRay expected(frame, packet[i]);
            INFO(shown(packet[i]));
            CHECK(same_bits(found[i].ray, expected.ray));
            CHECK(same_bits(found[i].scale, expected.scale));
          }
        });
      }
    }
    // Where a step of unit length is lost in the rounding of the origin, only the scalar code knows.
    if (unit <= 1) CHECK(unusual == 0);
    CHECK((unusual < compared / 2 || packet_kernels().empty()));
  }
}

TEST_CASE("lanes whose direction cannot come of the difference of two points are unusual, the others not") {
  const Frame frame(Mat4(1));
  const Vec3 direction = glm::normalize(Vec3(1, 2, 3));
  for (const PacketKernels& kernels : packet_kernels()) {
    const std::vector<Ray> rays{{Vec3(1, 2, 3), direction}, {Vec3(1e12, 0, 0), direction}};
    const auto found = kernels.object_rays(frame, rays);
    CHECK(!found[0].unusual);
    CHECK(found[1].unusual);
  }
}

TEST_CASE("normals leave objects with the same bits in packets") {
  Random random(6);
  const Scene scene = random_scene(random, 40);
  for (const Frame& frame : scene.frames) {
    std::vector<Vec3> normals;
    for (int i = 0; i < 40; ++i)
      normals.push_back(random.below(2) == 0 ? random.in_cube(1) : Vec3(0, -0.0, 1));
    normals.push_back(1e-200 * normals[0]);
    for (const PacketKernels& kernels : packet_kernels()) {
      for_each_packet(normals, kernels.lanes, [&](std::span<const Vec3> packet, std::size_t first) {
        const auto found = kernels.world_normals(frame, packet);
        for (std::size_t i = 0; i < packet.size(); ++i) {
          CHECK(found[i].unusual == (first + i == 40));  // only the one whose square underflows
          if (!found[i].unusual) CHECK(same_bits(found[i].normal, frame.world_normal(packet[i])));
        }
      });
    }
  }
}

TEST_CASE("packets pass the test of bounds exactly where single rays do") {
  Random random(8);
  int hit = 0, missed = 0;
  for (int round = 0; round < 200; ++round) {
    Bounds box;
    const double unit = round % 3 == 0 ? 1e6 : 1;
    const bool on_grid = round % 2 == 0;
    for (int corner = 0; corner < 2; ++corner)
      box.add(unit * (on_grid ? random.on_grid(8, 0.25) : random.in_cube(3)));
    auto rays = random_rays(random, unit, 60);
    // Through edges and corners, where the last bit decides.
    for (std::size_t i = 0; i < rays.size(); i += 2) {
      Vec3 edge = box.min;
      edge[static_cast<int>(random.below(3))] = random.below(2) == 0 ? box.max.x : random.between(-1, 1);
      if (edge != rays[i].origin) rays[i].direction = glm::normalize(edge - rays[i].origin);
    }
    for (const PacketKernels& kernels : packet_kernels()) {
      for_each_packet(rays, kernels.lanes, [&](std::span<const Ray> packet, std::size_t first) {
        const unsigned active = first % 3 == 0 ? all_of(packet.size()) & 0xdb6du : all_of(packet.size());
        unsigned expected = 0;
        for (std::size_t i = 0; i < packet.size(); ++i) {
          if (hits_bounds(box, packet[i])) expected |= 1u << i;
        }
        CHECK(kernels.hit_bounds(box, packet, active) == (expected & active));
        (expected != 0 ? hit : missed) += 1;
      });
    }
  }
  CHECK(((hit > 100 && missed > 100) || packet_kernels().empty()));
}
