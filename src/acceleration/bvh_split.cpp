#include "acceleration/bvh_split.hpp"

#include <algorithm>

namespace trace {
namespace {

constexpr int most_bins = 16;
constexpr std::uint32_t parallel_size = 1 << 16;

// 0 where the box has no end.
__m128 centre_of(const FloatBox& box) {
  const __m128 half = _mm_set1_ps(0.5f);
  const __m128 centre = _mm_add_ps(_mm_mul_ps(half, box.low), _mm_mul_ps(half, box.high));
  const __m128 size = _mm_andnot_ps(_mm_set1_ps(-0.0f), centre);
  return _mm_and_ps(centre, _mm_cmplt_ps(size, _mm_set1_ps(std::numeric_limits<float>::infinity())));
}

// From centres to bins, all three axes at once.
struct BinScale {
  int bins;
  __m128 low, scale;  // scale is 0 along axes that cannot be split

  explicit BinScale(const BvhRange& range)
      : bins(range.size() > 32 ? most_bins : most_bins / 2), low(range.centres.low) {
    const __m128 extent = _mm_sub_ps(range.centres.high, low);
    scale = _mm_div_ps(_mm_set1_ps(static_cast<float>(bins)), extent);
    const __m128 infinity = _mm_set1_ps(std::numeric_limits<float>::infinity());
    const __m128 usable =
        _mm_and_ps(_mm_cmpgt_ps(extent, _mm_setzero_ps()),
                   _mm_and_ps(_mm_cmplt_ps(extent, infinity), _mm_cmplt_ps(scale, infinity)));
    scale = _mm_and_ps(scale, usable);
  }

  // Bin i is [i, i + 1); the last has its upper end too.
  __m128 place(__m128 centre) const { return _mm_mul_ps(_mm_sub_ps(centre, low), scale); }
};

struct Bins {
  FloatBox boxes[3][most_bins];
  std::uint32_t counts[3][most_bins] = {};

  Bins(std::span<const BoxReference> references, const BinScale& scale) {
    // No number exceeds the last bin; and NaN, of the lane that does not count, is none.
    const __m128 last = _mm_set1_ps(static_cast<float>(scale.bins - 1));
    for (const BoxReference& reference : references) {
      const FloatBox box = reference.box;
      const __m128i bin = _mm_cvttps_epi32(_mm_min_ps(scale.place(centre_of(box)), last));
      const int x = _mm_cvtsi128_si32(bin);
      const int y = _mm_cvtsi128_si32(_mm_shuffle_epi32(bin, _MM_SHUFFLE(1, 1, 1, 1)));
      const int z = _mm_cvtsi128_si32(_mm_shuffle_epi32(bin, _MM_SHUFFLE(2, 2, 2, 2)));
      boxes[0][x].add(box);
      boxes[1][y].add(box);
      boxes[2][z].add(box);
      ++counts[0][x];
      ++counts[1][y];
      ++counts[2][z];
    }
  }

  void add(const Bins& other, int bins) {
    for (int axis = 0; axis < 3; ++axis) {
      for (int bin = 0; bin < bins; ++bin) {
        boxes[axis][bin].add(other.boxes[axis][bin]);
        counts[axis][bin] += other.counts[axis][bin];
      }
    }
  }
};

Bins bins_of(std::span<const BoxReference> references, const BinScale& scale, ThreadBudget& threads) {
  if (references.size() < parallel_size) return {references, scale};
  const std::size_t middle = references.size() / 2;
  std::optional<Bins> left, right;
  threads.both([&] { left = bins_of(references.first(middle), scale, threads); },
               [&] { right = bins_of(references.subspan(middle), scale, threads); });
  left->add(*right, scale.bins);
  return *left;
}

struct Plane {
  float cost = std::numeric_limits<float>::infinity();
  int axis = -1;
  int bin = 0;  // the first of the right half
  FloatBox left, right;
};

Plane best_plane(const Bins& bins, const BinScale& scale) {
  Plane best;
  for (int axis = 0; axis < 3; ++axis) {
    const FloatBox* boxes = bins.boxes[axis];
    const std::uint32_t* counts = bins.counts[axis];
    FloatBox right_boxes[most_bins];
    float right_cost[most_bins];
    FloatBox box;
    std::uint32_t count = 0;
    for (int bin = scale.bins - 1; bin > 0; --bin) {
      box.add(boxes[bin]);
      count += counts[bin];
      right_boxes[bin] = box;
      right_cost[bin] = count == 0 ? -1 : box.half_area() * static_cast<float>(count);
    }
    box = {};
    count = 0;
    for (int bin = 1; bin < scale.bins; ++bin) {
      box.add(boxes[bin - 1]);
      count += counts[bin - 1];
      if (count == 0) continue;
      if (right_cost[bin] < 0) break;
      const float cost = box.half_area() * static_cast<float>(count) + right_cost[bin];
      if (cost < best.cost) best = {cost, axis, bin, box, right_boxes[bin]};
    }
  }
  return best;
}

BvhHalves partition(std::span<BoxReference> references, const BvhRange& range, const Plane& plane,
                    const BinScale& scale) {
  const __m128 border = _mm_set1_ps(static_cast<float>(plane.bin));
  const int bit = 1 << plane.axis;
  BvhHalves result;
  result.left.box = plane.left;
  result.right.box = plane.right;
  FloatBox left_centres, right_centres;
  std::uint32_t left = range.first, right = range.last;
  const auto is_left = [&](__m128 centre) {
    return (_mm_movemask_ps(_mm_cmplt_ps(scale.place(centre), border)) & bit) != 0;
  };
  while (left < right) {
    const BoxReference a = references[left];
    const __m128 centre = centre_of(a.box);
    if (is_left(centre)) {
      left_centres.add(centre, centre);
      ++left;
      continue;
    }
    right_centres.add(centre, centre);
    // Its place goes to the last that belongs to the left.
    while (left < --right) {
      const BoxReference b = references[right];
      const __m128 other = centre_of(b.box);
      if (is_left(other)) {
        left_centres.add(other, other);
        references[left++] = b;
        references[right] = a;
        break;
      }
      right_centres.add(other, other);
    }
  }
  result.left.centres = left_centres;
  result.right.centres = right_centres;
  result.left.first = range.first;
  result.left.last = result.right.first = left;
  result.right.last = range.last;
  result.left.depth = result.right.depth = range.depth + 1;
  return result;
}

}  // namespace

BvhRange whole_range(std::span<const BoxReference> references, std::uint32_t first, std::uint32_t last,
                     int depth) {
  BvhRange result;
  for (const BoxReference& reference : references.subspan(first, last - first)) {
    const __m128 centre = centre_of(reference.box);
    result.box.add(reference.box);
    result.centres.add(centre, centre);
  }
  result.first = first;
  result.last = last;
  result.depth = depth;
  return result;
}

std::optional<BvhHalves> split(std::span<BoxReference> references, const BvhRange& range,
                               const LeafSizes& leaves, ThreadBudget& threads) {
  const std::uint32_t count = range.size();
  if (count <= leaves.always) return std::nullopt;
  const BinScale scale(range);
  Plane plane;
  if (range.depth < max_sah_depth) {
    plane = best_plane(bins_of(references.subspan(range.first, count), scale, threads), scale);
  }
  if (count <= leaves.most) {
    const float area = range.box.half_area();
    const float split_cost = area > 0 ? leaves.box + plane.cost / area : leaves.box;
    if (!(split_cost < static_cast<float>(count))) return std::nullopt;
  }
  if (plane.axis >= 0) return partition(references, range, plane, scale);
  // No plane separates the centres, or the tree is deep: halve by count.
  const std::uint32_t middle = range.first + count / 2;
  return BvhHalves{whole_range(references, range.first, middle, range.depth + 1),
                   whole_range(references, middle, range.last, range.depth + 1)};
}

}  // namespace trace
