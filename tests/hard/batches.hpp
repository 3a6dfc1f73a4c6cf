// Many rays over all cores, with results that do not depend on how many there are.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include "tests/hard/row.hpp"
#include "tests/support/scene_random.hpp"

namespace trace::hard {

using test::Random;

// One stream of random numbers a batch, so that what a batch draws depends on its number alone.
inline std::uint32_t batch_seed(std::uint32_t seed, std::uint64_t batch) {
  Digest mixed;
  mixed.add(std::uint64_t{seed});
  mixed.add(batch);
  return static_cast<std::uint32_t>(mixed.value() >> 32);
}

// Calls work(random, count, rows) for batches of up to `batch_size` rays that make up `rays`, at least one,
// side by side. `rows` is a std::vector<Row>& that starts as the given rows, with names and zeros; the sum of
// all is returned. `work` fills the counts and, where it tells a digest, that of its batch.
template <class Work>
std::vector<Row> in_batches(std::uint64_t rays, std::uint32_t seed, const std::vector<Row>& named,
                            Work&& work, std::uint64_t batch_size = 1024) {
  const std::uint64_t batches = std::max<std::uint64_t>(1, (rays + batch_size - 1) / batch_size);
  const auto merge = [](std::vector<Row> sum, const std::vector<Row>& part) {
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i].add(part[i]);
    return sum;
  };
  return tbb::parallel_reduce(
      tbb::blocked_range<std::uint64_t>(0, batches), named,
      [&](const tbb::blocked_range<std::uint64_t>& range, std::vector<Row> sum) {
        for (std::uint64_t batch = range.begin(); batch != range.end(); ++batch) {
          Random random(batch_seed(seed, batch));
          std::vector<Row> rows = named;
          work(random,
               std::min(batch_size, std::max<std::uint64_t>(1, rays - std::min(rays, batch * batch_size))),
               rows);
          sum = merge(std::move(sum), rows);
        }
        return sum;
      },
      merge);
}

}  // namespace trace::hard
