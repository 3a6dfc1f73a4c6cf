#include "acceleration/bvh.hpp"

namespace trace {

BvhRay::BvhRay(const Bvh& bvh, const Ray& ray) {
  const Vec3 relative = ray.origin - bvh.centre;
  const __m128 sign = _mm_set1_ps(-0.0f);
  const __m128 origin = _mm_setr_ps(static_cast<float>(relative.x), static_cast<float>(relative.y),
                                    static_cast<float>(relative.z), 0);
  const __m128 direction =
      _mm_setr_ps(static_cast<float>(ray.direction.x), static_cast<float>(ray.direction.y),
                  static_cast<float>(ray.direction.z), 1);
  const __m128 error = _mm_add_ps(_mm_mul_ps(_mm_set1_ps(0x1p-22f), _mm_andnot_ps(sign, origin)),
                                  _mm_loadu_ps(bvh.centre_error.data()));
  // Apart: back where the ray goes up.
  const __m128 apart = _mm_or_ps(error, _mm_and_ps(sign, direction));
  const __m128 inverse = _mm_div_ps(_mm_set1_ps(1), direction);
  _mm_store_ps(near_origin, _mm_add_ps(origin, apart));
  _mm_store_ps(far_origin, _mm_sub_ps(origin, apart));
  _mm_store_ps(near_inverse, _mm_mul_ps(inverse, _mm_set1_ps(1 - 0x1p-21f)));
  _mm_store_ps(far_inverse, _mm_mul_ps(inverse, _mm_set1_ps(1 + 0x1p-21f)));
  const int signs = _mm_movemask_ps(direction);
  for (int axis = 0; axis < 3; ++axis) negative[axis] = (signs >> axis & 1) != 0;
}

}  // namespace trace
