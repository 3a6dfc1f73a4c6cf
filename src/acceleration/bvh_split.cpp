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

FloatBox centres_of(std::span<const BoxReference> references) {
  FloatBox result;
  for (const BoxReference& reference : references) {
    const __m128 centre = centre_of(reference.box);
    result.add(centre, centre);
  }
  return result;
}

// From centres to bins, all three axes at once.
struct BinScale {
  int bins;
  __m128 low, scale;  // scale is 0 along axes that cannot be split

  explicit BinScale(const BvhRange& range)
      : bins(range.size() > 128 ? most_bins
             : range.size() > 8 ? 6
                                : 4),
        low(range.centres.low) {
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

// Which references belong to the left half.
class Side {
 public:
  Side(const Plane& plane, const BinScale& scale)
      : scale_(scale), border_(_mm_set1_ps(static_cast<float>(plane.bin))), axis_(plane.axis) {}

  unsigned is_left(__m128 centre) const {
    const auto bits = static_cast<unsigned>(_mm_movemask_ps(_mm_cmplt_ps(scale_.place(centre), border_)));
    return bits >> axis_ & 1;
  }
  unsigned is_left(const BoxReference& reference) const { return is_left(centre_of(reference.box)); }

 private:
  const BinScale& scale_;
  __m128 border_;
  int axis_;
};

// Few: without a branch on the side, which cannot be foretold.
constexpr std::size_t most_copied = 1024;

std::uint32_t partition_few(std::span<BoxReference> references, const Side& side, FloatBox& left_centres,
                            FloatBox& right_centres) {
  __m128 copy[2 * most_copied];  // not initialized
  std::size_t left = 0, right = 0;
  for (const BoxReference reference : references) {  // a copy
    const unsigned is_left = side.is_left(reference);
    references[left] = reference;
    copy[2 * right] = reference.box.low;
    copy[2 * right + 1] = reference.box.high;
    left += is_left;
    right += 1 - is_left;
  }
  for (std::size_t i = 0; i < right; ++i) references[left + i].box = {copy[2 * i], copy[2 * i + 1]};
  left_centres = centres_of(references.first(left));
  right_centres = centres_of(references.subspan(left));
  return static_cast<std::uint32_t>(left);
}

std::uint32_t partition_many(std::span<BoxReference> references, const Side& side, FloatBox& left_centres,
                             FloatBox& right_centres) {
  std::size_t left = 0, right = references.size();
  while (left < right) {
    const BoxReference a = references[left];
    const __m128 centre = centre_of(a.box);
    if (side.is_left(centre)) {
      left_centres.add(centre, centre);
      ++left;
      continue;
    }
    right_centres.add(centre, centre);
    // Its place goes to the last that belongs to the left.
    while (left < --right) {
      const BoxReference b = references[right];
      const __m128 other = centre_of(b.box);
      if (side.is_left(other)) {
        left_centres.add(other, other);
        references[left++] = b;
        references[right] = a;
        break;
      }
      right_centres.add(other, other);
    }
  }
  return static_cast<std::uint32_t>(left);
}

BvhHalves partition(std::span<BoxReference> references, const BvhRange& range, const Plane& plane,
                    const BinScale& scale) {
  BvhHalves result;
  const auto of_range = references.subspan(range.first, range.size());
  const std::uint32_t left =
      range.size() <= most_copied
          ? partition_few(of_range, Side(plane, scale), result.left.centres, result.right.centres)
          : partition_many(of_range, Side(plane, scale), result.left.centres, result.right.centres);
  result.left.box = plane.left;
  result.right.box = plane.right;
  result.left.first = range.first;
  result.left.last = result.right.first = range.first + left;
  result.right.last = range.last;
  result.left.depth = result.right.depth = range.depth + 1;
  return result;
}

}  // namespace

BvhRange whole_range(std::span<const BoxReference> references, std::uint32_t first, std::uint32_t last,
                     int depth) {
  BvhRange result;
  const auto of_range = references.subspan(first, last - first);
  for (const BoxReference& reference : of_range) result.box.add(reference.box);
  result.centres = centres_of(of_range);
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
