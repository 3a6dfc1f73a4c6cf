#include "precision/render-inl.hpp"

namespace trace::precision {

template ArithmeticPicture render_as<long double>(const Scene&, const SceneTree&, const RenderOptions&, int);

}  // namespace trace::precision
