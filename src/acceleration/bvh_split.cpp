#include "acceleration/bvh_split.hpp"

#include <algorithm>
#include <limits>
#include <optional>

namespace trace {
namespace {

constexpr int most_bins = 16;
constexpr std::uint32_t parallel_size = 1 << 16;

// The sum of a box's corners, twice its centre; 0 where it has no end or is next to it, and in the lane that
// does not count.
__m128 centre_of(const FloatBox& box) {
  const float limit = std::numeric_limits<float>::infinity();
  const __m128 sum = _mm_sub_ps(box.low, box.minus_high);
  const __m128 size = _mm_andnot_ps(_mm_set1_ps(-0.0f), sum);
  return _mm_and_ps(sum, _mm_cmplt_ps(size, _mm_setr_ps(limit, limit, limit, 0)));
}

FloatBox point(__m128 at) {
  return {at, _mm_xor_ps(at, _mm_set1_ps(-0.0f))};
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
    const __m128 extent = _mm_sub_ps(range.centres.high(), low);
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

// What lies in each bin of each axis; only as many bins as the scale has are initialized.
struct Bins {
  FloatBox boxes[3][most_bins];
  std::uint32_t counts[most_bins][4];  // of the axes, and none

  Bins(std::span<const BoxReference> references, const BinScale& scale) {
    for (int bin = 0; bin < scale.bins; ++bin) {
      for (int axis = 0; axis < 3; ++axis) boxes[axis][bin] = FloatBox::empty();
      std::fill(std::begin(counts[bin]), std::end(counts[bin]), 0u);
    }
    // Neighbours in the list often fall into the same bin, where the second has to wait for the first: the
    // halves of the list take turns.
    const std::size_t half = references.size() / 2;
    const BoxReference* const second = references.data() + half;
    for (std::size_t i = 0; i < half; ++i) {
      add(references[i], scale);
      add(second[i], scale);
    }
    if (references.size() % 2 != 0) add(references.back(), scale);
  }

  void add(const BoxReference& reference, const BinScale& scale) {
    const __m128 last = _mm_set1_ps(static_cast<float>(scale.bins - 1));  // no number exceeds it
    const FloatBox box = reference.box;
    const __m128i bin = _mm_cvttps_epi32(_mm_min_ps(scale.place(centre_of(box)), last));
    const int x = _mm_cvtsi128_si32(bin);
    const int y = _mm_cvtsi128_si32(_mm_shuffle_epi32(bin, _MM_SHUFFLE(1, 1, 1, 1)));
    const int z = _mm_cvtsi128_si32(_mm_shuffle_epi32(bin, _MM_SHUFFLE(2, 2, 2, 2)));
    boxes[0][x].add(box);
    boxes[1][y].add(box);
    boxes[2][z].add(box);
    ++counts[x][0];
    ++counts[y][1];
    ++counts[z][2];
  }

  void add(const Bins& other, int bins) {
    for (int bin = 0; bin < bins; ++bin) {
      for (int axis = 0; axis < 3; ++axis) {
        boxes[axis][bin].add(other.boxes[axis][bin]);
        counts[bin][axis] += other.counts[bin][axis];
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

// Three boxes, one for each axis of the bins, coordinate by coordinate; the fourth lane does not count.
struct BoxOfAxis {
  __m128 at[6];  // x, y, z of the low corner, then of the high one, negated

  BoxOfAxis() { std::fill(std::begin(at), std::end(at), FloatBox::empty().low); }
  BoxOfAxis(const FloatBox& a, const FloatBox& b, const FloatBox& c) {
    transpose(a.low, b.low, c.low, at);
    transpose(a.minus_high, b.minus_high, c.minus_high, at + 3);
  }

  static void transpose(__m128 a, __m128 b, __m128 c, __m128* to) {
    const __m128 low = _mm_unpacklo_ps(a, b), high = _mm_unpackhi_ps(a, b);
    to[0] = _mm_movelh_ps(low, c);
    to[1] = _mm_shuffle_ps(low, c, _MM_SHUFFLE(1, 1, 3, 2));
    to[2] = _mm_shuffle_ps(high, c, _MM_SHUFFLE(2, 2, 1, 0));
  }

  void add(const BoxOfAxis& other) {
    for (int i = 0; i < 6; ++i) at[i] = _mm_min_ps(other.at[i], at[i]);
  }

  __m128 half_area() const {
    const __m128 x = _mm_add_ps(at[0], at[3]), y = _mm_add_ps(at[1], at[4]), z = _mm_add_ps(at[2], at[5]);
    return _mm_add_ps(_mm_add_ps(_mm_mul_ps(x, y), _mm_mul_ps(y, z)), _mm_mul_ps(z, x));
  }
};

struct SplitPlane {
  float cost = std::numeric_limits<float>::infinity();
  int axis = -1;
  int bin = 0;  // the first of the right half
};

// All axes at once. Half a surface of an empty half is infinite, so its cost, times no items, is NaN, which
// is never the least.
SplitPlane best_plane(const Bins& bins, int count) {
  BoxOfAxis boxes[most_bins];
  __m128 right_cost[most_bins];
  BoxOfAxis box;
  __m128i items = _mm_setzero_si128();
  const auto counts = [&](int bin) {
    return _mm_loadu_si128(reinterpret_cast<const __m128i*>(bins.counts[bin]));
  };
  for (int bin = count - 1; bin > 0; --bin) {
    boxes[bin] = BoxOfAxis(bins.boxes[0][bin], bins.boxes[1][bin], bins.boxes[2][bin]);
    box.add(boxes[bin]);
    items = _mm_add_epi32(items, counts(bin));
    right_cost[bin] = _mm_mul_ps(box.half_area(), _mm_cvtepi32_ps(items));
  }
  box = BoxOfAxis(bins.boxes[0][0], bins.boxes[1][0], bins.boxes[2][0]);
  items = counts(0);
  __m128 least = _mm_set1_ps(std::numeric_limits<float>::infinity());
  __m128 at = _mm_setzero_ps();
  for (int bin = 1; bin < count; ++bin) {
    const __m128 cost = _mm_add_ps(_mm_mul_ps(box.half_area(), _mm_cvtepi32_ps(items)), right_cost[bin]);
    const __m128 is_less = _mm_cmplt_ps(cost, least);
    least = _mm_min_ps(cost, least);
    at = _mm_or_ps(_mm_and_ps(is_less, _mm_set1_ps(static_cast<float>(bin))), _mm_andnot_ps(is_less, at));
    box.add(boxes[bin]);
    items = _mm_add_epi32(items, counts(bin));
  }
  alignas(16) float costs[4], places[4];
  _mm_store_ps(costs, least);
  _mm_store_ps(places, at);
  SplitPlane best;
  for (int axis = 0; axis < 3; ++axis) {
    if (costs[axis] < best.cost) best = {costs[axis], axis, static_cast<int>(places[axis])};
  }
  return best;
}

// Which references belong to the left half.
class Side {
 public:
  Side(const SplitPlane& plane, const BinScale& scale)
      : scale_(scale), border_(_mm_set1_ps(static_cast<float>(plane.bin))) {}

  // In all lanes.
  template <int axis>
  __m128 left_lanes(__m128 centre) const {
    const __m128 left = _mm_cmplt_ps(scale_.place(centre), border_);
    return _mm_shuffle_ps(left, left, _MM_SHUFFLE(axis, axis, axis, axis));
  }

 private:
  const BinScale& scale_;
  __m128 border_;
};

// The boxes of the centres of both halves.
struct HalfCentres {
  FloatBox left = FloatBox::empty(), right = FloatBox::empty();

  void add(const HalfCentres& other) {
    left.add(other.left);
    right.add(other.right);
  }
};

// Without branches, which could not be foretold: every reference trades places with the first of the right
// half, which grows by it or moves on by one.
template <int axis>
std::size_t partition_in_turn(std::span<BoxReference> references, const Side& side, HalfCentres& centres) {
  FloatBox left_centres = FloatBox::empty(), right_centres = FloatBox::empty();
  BoxReference* right = references.data();
  for (BoxReference& at : references) {
    const BoxReference reference = at;
    const __m128 centre = centre_of(reference.box);
    const __m128 is_left = side.left_lanes<axis>(centre);
    at = *right;
    *right = reference;
    right += static_cast<unsigned>(_mm_movemask_ps(is_left)) & 1;
    // Lanes of ones are NaN, which adds nothing.
    const FloatBox place = point(centre);
    const __m128 is_right = _mm_xor_ps(is_left, _mm_castsi128_ps(_mm_set1_epi32(-1)));
    left_centres.add({_mm_or_ps(place.low, is_right), _mm_or_ps(place.minus_high, is_right)});
    right_centres.add({_mm_or_ps(place.low, is_left), _mm_or_ps(place.minus_high, is_left)});
  }
  centres = {left_centres, right_centres};
  return static_cast<std::size_t>(right - references.data());
}

// Both halves of the list by themselves, then the right of the first for as many of the left of the second.
template <int axis>
std::size_t partition_side_by_side(std::span<BoxReference> references, const Side& side, HalfCentres& centres,
                                   ThreadBudget& threads) {
  if (references.size() < parallel_size) return partition_in_turn<axis>(references, side, centres);
  const std::size_t middle = references.size() / 2;
  HalfCentres others;
  std::size_t first = 0, second = 0;
  threads.both(
      [&] { first = partition_side_by_side<axis>(references.first(middle), side, centres, threads); },
      [&] { second = partition_side_by_side<axis>(references.subspan(middle), side, others, threads); });
  centres.add(others);
  const std::size_t left = first + second, moved = std::min(middle - first, second);
  const auto from = references.begin();
  const auto at = [&](std::size_t i) { return from + static_cast<std::ptrdiff_t>(i); };
  std::swap_ranges(at(first), at(first + moved), at(middle + second - moved));
  return left;
}

void partition(std::span<BoxReference> references, const BvhRange& range, const Bins& bins,
               const SplitPlane& plane, const BinScale& scale, ThreadBudget& threads, BvhHalves& halves) {
  const auto of_range = references.subspan(range.first, range.size());
  const Side side(plane, scale);
  HalfCentres centres;
  std::size_t left = 0;
  if (plane.axis == 0) {
    left = partition_side_by_side<0>(of_range, side, centres, threads);
  } else if (plane.axis == 1) {
    left = partition_side_by_side<1>(of_range, side, centres, threads);
  } else {
    left = partition_side_by_side<2>(of_range, side, centres, threads);
  }
  const std::uint32_t middle = range.first + static_cast<std::uint32_t>(left);
  halves.left = {FloatBox::empty(), centres.left, range.first, middle, range.depth + 1};
  halves.right = {FloatBox::empty(), centres.right, middle, range.last, range.depth + 1};
  for (int bin = 0; bin < plane.bin; ++bin) halves.left.box.add(bins.boxes[plane.axis][bin]);
  for (int bin = plane.bin; bin < scale.bins; ++bin) halves.right.box.add(bins.boxes[plane.axis][bin]);
}

void halve_by_count(std::span<BoxReference> references, const BvhRange& range, ThreadBudget& threads,
                    BvhHalves& halves) {
  const std::uint32_t middle = range.first + range.size() / 2;
  halves.left = whole_range(references, range.first, middle, range.depth + 1, threads);
  halves.right = whole_range(references, middle, range.last, range.depth + 1, threads);
}

}  // namespace

BvhRange whole_range(std::span<const BoxReference> references, std::uint32_t first, std::uint32_t last,
                     int depth, ThreadBudget& threads) {
  BvhRange result{FloatBox::empty(), FloatBox::empty(), first, last, depth};
  if (last - first < parallel_size) {
    for (const BoxReference& reference : references.subspan(first, last - first)) {
      result.box.add(reference.box);
      result.centres.add(point(centre_of(reference.box)));
    }
  } else {
    const std::uint32_t middle = first + (last - first) / 2;
    BvhRange left, right;
    threads.both([&] { left = whole_range(references, first, middle, depth, threads); },
                 [&] { right = whole_range(references, middle, last, depth, threads); });
    for (const BvhRange& half : {left, right}) {
      result.box.add(half.box);
      result.centres.add(half.centres);
    }
  }
  return result;
}

bool split(std::span<BoxReference> references, const BvhRange& range, const LeafSizes& leaves,
           ThreadBudget& threads, BvhHalves& halves) {
  const std::uint32_t count = range.size();
  if (count <= leaves.always) return false;
  if (range.depth >= max_sah_depth) {
    if (count <= leaves.most) return false;
    halve_by_count(references, range, threads, halves);
    return true;
  }
  const BinScale scale(range);
  const Bins bins = bins_of(references.subspan(range.first, count), scale, threads);
  const SplitPlane plane = best_plane(bins, scale.bins);
  if (count <= leaves.most) {
    const float area = range.box.half_area();
    const float split_cost = area > 0 ? leaves.box + plane.cost / area : leaves.box;
    if (!(split_cost < static_cast<float>(count))) return false;
  }
  if (plane.axis >= 0) {
    partition(references, range, bins, plane, scale, threads, halves);
  } else {
    halve_by_count(references, range, threads, halves);  // no plane separates the centres
  }
  return true;
}

}  // namespace trace
