// Pictures of scenes told in other words, compared with the picture of the plain words.
#pragma once

#include "image/image.hpp"
#include "tests/metamorphic/scene_text.hpp"

namespace trace::test {

// A square picture, at most four bounces deep. Throws with the messages where the text is not a scene.
Image picture(const SceneText& scene, const Retelling& retelling, int width);

struct Off {
  std::size_t pixels = 0;  // that were compared
  std::size_t off = 0;     // of them off by more than one level in some channel
};

// A pixel looks through its lower left corner, x = i / width from the left; mirrored, it is at 1 - x, which
// is pixel width - i. The first column of a mirrored picture has no other and is left out.
Off compare(const Image& plain, const Image& retold, bool mirrored);

}  // namespace trace::test
