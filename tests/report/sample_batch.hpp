// Batches of real renderings with known defects, as `trace batch` reports them.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

namespace trace::test {

// Renders scenes of ours and their solutions into `folder`: most as they should be, one without shadows, one
// without reflections, one off by a level in one pixel, one of another size, one with half a PNG, one with a
// syntax error; and two results without a picture, of which one has markup for its name. Throws where a
// rendering fails that should not.
nlohmann::ordered_json sample_batch(const std::filesystem::path& folder);

// The same with a second renderer, for which everything is right except one scene that takes too long.
nlohmann::ordered_json with_second_renderer(nlohmann::ordered_json report);

}  // namespace trace::test
