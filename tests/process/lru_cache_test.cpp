#include "process/lru_cache.hpp"

#include <catch2/catch.hpp>

namespace trace::test {

TEST_CASE("a cache lets go of what was used longest ago when it holds too many bytes") {
  LruCache<int> cache(100, 10);
  cache.put("a", 1, 40);
  cache.put("b", 2, 40);
  REQUIRE(cache.find("a") != nullptr);
  cache.put("c", 3, 40);
  CHECK(cache.find("b") == nullptr);
  CHECK(*cache.find("a") == 1);
  CHECK(*cache.find("c") == 3);
  CHECK(cache.bytes() == 80);
}

TEST_CASE("a cache has a limit on entries, and does not keep what is larger than all of it") {
  LruCache<int> cache(100, 2);
  cache.put("a", 1, 1);
  cache.put("b", 2, 1);
  cache.put("c", 3, 1);
  CHECK(cache.size() == 2);
  CHECK(cache.find("a") == nullptr);
  cache.put("large", 4, 101);
  CHECK(cache.find("large") == nullptr);
  CHECK(cache.bytes() <= 100);
}

TEST_CASE("a value put into a cache again replaces the first one") {
  LruCache<int> cache(100, 10);
  cache.put("a", 1, 60);
  cache.put("a", 2, 60);
  CHECK(*cache.find("a") == 2);
  CHECK(cache.bytes() == 60);
  cache.clear();
  CHECK(cache.find("a") == nullptr);
  CHECK(cache.bytes() == 0);
}

}  // namespace trace::test
