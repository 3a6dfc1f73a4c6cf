// What makes a picture another one for a batch.
#include "batch/fingerprint.hpp"

#include <catch2/catch.hpp>

using namespace trace;

TEST_CASE("a batch draws anew for another least contribution, not for everything modelled or counted") {
  Job job;
  job.scene = "a.ray";
  job.picture = "a.png";
  const std::string key = picture_key(job, "program");
  job.options.shading.model_everything = job.options.shading.count_work = true;
  CHECK(picture_key(job, "program") == key);
  job.options.shading.least_contribution = 0.1;
  CHECK(picture_key(job, "program") != key);
  job.options.shading = {};
  job.options.shading.light_samples = 5;
  CHECK(picture_key(job, "program") != key);
  job.options.shading = {};
  job.options.shading.transmissive_shadows = TransmissiveShadows::none;
  CHECK(picture_key(job, "program") != key);
}
