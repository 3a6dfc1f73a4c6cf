// Properties: statements about every input, tried on many; where one fails, the smallest input found that
// fails it is shown (RapidCheck).
#pragma once

#include <rapidcheck.h>

#include <catch2/catch.hpp>
#include <sstream>

namespace trace::test {

// Fails the test that calls it, with the shrunk counterexample, unless the property holds for `cases` inputs.
// The arguments of `property` are its inputs; it makes them with *generator itself where it takes none. The
// seed is fixed, so that a run is the same on every machine.
template <class Property>
void holds(Property&& property, int cases = 400) {
  rc::detail::TestParams params;
  params.seed = 20240607;
  params.maxSuccess = cases;
  params.maxDiscardRatio = 50;  // inputs outside a property's precondition, for each one inside
  const rc::detail::TestResult result =
      rc::detail::checkTestable(std::forward<Property>(property), rc::detail::TestMetadata(), params);
  std::ostringstream text;
  rc::detail::printResultMessage(result, text);
  INFO(text.str());
  REQUIRE(result.template is<rc::detail::SuccessResult>());
}

}  // namespace trace::test
