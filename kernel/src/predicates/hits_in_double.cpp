// Decisions on floats that the filter in float leaves in doubt: the filter in double, then integers.
#include "graze/sphere.hpp"
#include "graze/triangle.hpp"

namespace graze::predicates {

bool hits_in_double(const Ray<float>& ray, const Triangle<float>& triangle) noexcept {
  const TriangleVerdict answer = verdict(triangle_terms<double>(ray, triangle), ray);
  return answer == TriangleVerdict::uncertain ? exact::hits(ray, triangle) : answer == TriangleVerdict::face;
}

bool hits_in_double(const Ray<float>& ray, const Sphere<float>& sphere) noexcept {
  SphereTerms<double> terms = sphere_terms<double>(ray, sphere);
  const SphereKind answer = verdict(terms, ray, sphere).kind;
  return answer == SphereKind::invalid ? exact::hits(ray, sphere) : answer == SphereKind::secant;
}

}  // namespace graze::predicates
