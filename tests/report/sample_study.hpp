// Studies as `trace study` reports them.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "report/study_html.hpp"

namespace trace::test {

struct SampleStudy {
  nlohmann::ordered_json report;
  NamedPictures pictures;
};

// Three scenes of ours, rendered into `folder` with some settings and compared; times, and errors of settings
// that are not rendered, are made up. One setting has no error, one a picture of half the size. One scene has
// a solution; a fourth has markup for its name, no pictures but a solution that is missing, and few results.
SampleStudy sample_study(const std::filesystem::path& folder);

// Made up, without pictures: so many scenes, each with all of so many settings.
nlohmann::ordered_json made_up_study(std::size_t scene_count, std::size_t setting_count);

}  // namespace trace::test
