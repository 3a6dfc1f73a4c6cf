// The kernels of the shapes against their intersect() and distance().
#include "tests/packets/same_bits.hpp"
#include "tests/packets/shape_rays.hpp"

using namespace trace;
using namespace trace::test;

namespace {

const std::vector<Shape>& shapes() {
  static const std::vector<Shape> all{Sphere{},
                                      Box{},
                                      Square{},
                                      Cylinder{},
                                      Cone(1, 0, 1, true),
                                      Cone(0, 1, 2, false),
                                      Cone(1, 0.5, 1, true),
                                      Cone(0.5, 1.5, 0.25, false),
                                      Cone(1, 1, 3, true),
                                      Cone(1, 0.5, -1, true)};
  return all;
}

struct ShapeDisagreements {
  int hits = 0, unusual = 0, different = 0;
  std::string first;  // the first ray that differs
};

void compare(const Shape& shape, const std::vector<Ray>& rays, const PacketKernels& kernels,
             ShapeDisagreements& result) {
  for_each_packet(rays, kernels.lanes, [&](std::span<const Ray> packet, std::size_t first) {
    // Of some packets, not all rays are active.
    const unsigned active = first % 5 == 0 ? all_of(packet.size()) & 0xb6d7u : all_of(packet.size());
    const auto answers = kernels.intersect(shape, packet, active);
    for (std::size_t i = 0; i < packet.size(); ++i) {
      if ((active >> i & 1) == 0) {
        if (answers[i].found) ++result.different;
        continue;
      }
      if (answers[i].unusual) {
        ++result.unusual;
        continue;
      }
      const auto expected = meet(shape, packet[i]);
      if (expected) ++result.hits;
      const bool same = expected
                            ? answers[i].found && !expected->is_gap && same_bits(answers[i].hit, *expected)
                            : !answers[i].found;
      if (same) continue;
      ++result.different;
      if (result.first.empty()) result.first = shown(packet[i]);
    }
  });
}

std::vector<Ray> some_rays(const Shape& shape, RayKind kind, int count) {
  Random random(7 + static_cast<std::uint32_t>(kind));
  std::vector<Ray> rays;
  for (int i = 0; i < count; ++i) rays.push_back(ray_at(shape, kind, random));
  return rays;
}

bool can_be_hit(const Shape& shape) {
  const auto* cone = std::get_if<Cone>(&shape);
  return !cone || cone->height() > 0;
}

}  // namespace

TEST_CASE("a shape's packet kernel has the bits of its scalar code, or says that it does not know") {
  int hits = 0;
  for (std::size_t shape = 0; shape < shapes().size(); ++shape) {
    if (!can_be_hit(shapes()[shape])) continue;
    for (const RayKind kind : all_ray_kinds) {
      const auto rays = some_rays(shapes()[shape], kind, 1500);
      for (const PacketKernels& kernels : packet_kernels()) {
        ShapeDisagreements result;
        compare(shapes()[shape], rays, kernels, result);
        INFO("shape " << shape << ", rays " << static_cast<int>(kind) << ", " << name_of(kernels.set) << ": "
                      << result.first);
        CHECK(result.different == 0);
        hits += result.hits;
      }
    }
  }
  CHECK((hits > 10'000 || packet_kernels().empty()));
}

TEST_CASE("packets have the bits of a shape's scalar code where it has no kernel") {
  Bounds slab = Bounds::everything();
  slab.min.z = 0;
  slab.max.z = 1;
  const std::vector<Shape> others{Tube{}, Plane(Vec3(0, 0, 0.25), Vec3(1, 2, 3)), Torus(1, 0.25),
                                  Quadric({1, 1, -1, 0, 0, 0, 0, 0, 0, -1}),
                                  Quadric({1, -1, 0, 0, 0, 0, 0, 0, 0, -1}, slab, Bounds::everything())};
  int hits = 0;
  for (const Shape& shape : others) {
    for (const RayKind kind : {RayKind::past, RayKind::inside, RayKind::on_grid, RayKind::far_away}) {
      const auto rays = some_rays(shape, kind, 1000);
      for (const PacketKernels& kernels : packet_kernels()) {
        ShapeDisagreements result;
        compare(shape, rays, kernels, result);
        INFO("shape " << shape.index() << ": " << result.first);
        CHECK(result.different + result.unusual == 0);
        hits += result.hits;
      }
    }
  }
  CHECK((hits > 2000 || packet_kernels().empty()));
}

TEST_CASE("packets never hit a cone of negative height") {
  const Shape cone = Cone(1, 0.5, -1, true);
  for (const RayKind kind : {RayKind::past, RayKind::inside, RayKind::on_grid}) {
    const auto rays = some_rays(cone, kind, 500);
    for (const PacketKernels& kernels : packet_kernels()) {
      ShapeDisagreements result;
      compare(cone, rays, kernels, result);
      CHECK(result.hits + result.different + result.unusual == 0);
    }
  }
}

TEST_CASE("of ordinary rays hardly any is unusual for packets") {
  for (std::size_t shape = 0; shape < shapes().size(); ++shape) {
    if (!can_be_hit(shapes()[shape])) continue;
    for (const RayKind kind : {RayKind::towards, RayKind::past, RayKind::inside, RayKind::leaving}) {
      const auto rays = some_rays(shapes()[shape], kind, 4000);
      for (const PacketKernels& kernels : packet_kernels()) {
        ShapeDisagreements result;
        compare(shapes()[shape], rays, kernels, result);
        INFO("shape " << shape << ", rays " << static_cast<int>(kind) << ", " << name_of(kernels.set));
        CHECK(result.unusual <= 4);
      }
    }
  }
}

TEST_CASE("rays along a face of the box and beside it are not unusual") {
  std::vector<Ray> rays;
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const double beside = random.between(0.6, 3);
    rays.push_back({{beside, random.between(-1, 1), -2}, {0, random.between(-0.1, 0.1), 1}});
  }
  for (const PacketKernels& kernels : packet_kernels()) {
    ShapeDisagreements result;
    compare(Box{}, rays, kernels, result);
    CHECK(result.unusual + result.different == 0);
  }
}

TEST_CASE("rays that pass the rim of a cylinder between side and cap are found unusual") {
  const auto rays = some_rays(Cylinder{}, RayKind::through_edge, 20'000);
  int gaps = 0;
  for (const Ray& ray : rays) {
    const auto hit = meet(Cylinder{}, ray);
    if (hit && hit->is_gap) ++gaps;
  }
  REQUIRE(gaps > 0);
  for (const PacketKernels& kernels : packet_kernels()) {
    ShapeDisagreements result;
    compare(Cylinder{}, rays, kernels, result);
    CHECK(result.different == 0);
    CHECK(result.unusual >= gaps * 9 / 10);  // less those of rays that were not active
  }
}

TEST_CASE("the distance of a point from a shape has the same bits in packets") {
  int compared = 0;
  for (const Shape& shape : shapes()) {
    std::vector<Vec3> points, normals;
    for (const Ray& ray : some_rays(shape, RayKind::towards, 2000)) {
      const auto hit = meet(shape, ray);
      if (!hit) continue;
      points.push_back(ray.at(hit->t));
      normals.push_back(hit->normal);
    }
    for (const PacketKernels& kernels : packet_kernels()) {
      for_each_packet(points, kernels.lanes, [&](std::span<const Vec3> packet, std::size_t first) {
        const auto found =
            kernels.distance(shape, packet, std::span<const Vec3>(normals).subspan(first, packet.size()));
        for (std::size_t i = 0; i < packet.size(); ++i) {
          const Vec3 &p = packet[i], &n = normals[first + i];
          const double expected = std::visit(
              [&](const auto& s) {
                if constexpr (requires { s.distance(p); }) return s.distance(p) + gamma(4);
                if constexpr (requires { s.distance(p, n); }) {
                  return s.distance(p, n) + gamma(4) * (1 + largest(p));
                }
                return 0.0;
              },
              shape);
          CHECK(same_bits(found[i], expected));
          ++compared;
        }
      });
    }
  }
  CHECK((compared > 1000 || packet_kernels().empty()));
}
