// The primitives of a scene's parts, by their index.
#pragma once

#include <algorithm>
#include <vector>

#include "fuzz/case.hpp"
#include "graze/scene.hpp"

namespace graze::cli {

template <Real T>
class Primitives {
 public:
  /// The parts must outlive this.
  explicit Primitives(const std::vector<Part<T>>& parts) : parts_(parts), first_{0} {
    for (const Part<T>& part : parts) {
      const auto* mesh = std::get_if<Mesh<T>>(&part);
      const std::size_t size = mesh != nullptr ? mesh->triangles.size() : std::get<Spheres<T>>(part).spheres.size();
      first_.push_back(first_.back() + static_cast<std::uint32_t>(size));
    }
  }

  [[nodiscard]] std::uint32_t size() const { return first_.back(); }

  /// Calls f with the triangle or sphere.
  template <class F>
  auto with(std::uint32_t index, F f) const {
    const auto part = static_cast<std::size_t>(std::upper_bound(first_.begin(), first_.end(), index) - first_.begin()) - 1;
    const std::uint32_t element = index - first_[part];
    if (const auto* mesh = std::get_if<Mesh<T>>(&parts_[part])) {
      const auto& [a, b, c] = mesh->triangles[element];
      return f(Triangle<T>{mesh->points[a], mesh->points[b], mesh->points[c]});
    }
    return f(std::get<Spheres<T>>(parts_[part]).spheres[element]);
  }

 private:
  const std::vector<Part<T>>& parts_;
  std::vector<std::uint32_t> first_;
};

template <Real T>
[[nodiscard]] fuzz::Case<T> case_of(const Ray<T>& ray, const Triangle<T>& triangle) {
  return fuzz::RayTriangle<T>{ray, triangle};
}
template <Real T>
[[nodiscard]] fuzz::Case<T> case_of(const Ray<T>& ray, const Sphere<T>& sphere) {
  return fuzz::RaySphere<T>{ray, sphere};
}

/// A box about it, in double; a sphere's may be rounded inward by an ulp.
template <Real T>
[[nodiscard]] Bounds<double> bounds_of(const Triangle<T>& t) {
  const auto low = [](T a, T b, T c) { return static_cast<double>(std::min({a, b, c})); };
  const auto high = [](T a, T b, T c) { return static_cast<double>(std::max({a, b, c})); };
  return {{low(t.a.x, t.b.x, t.c.x), low(t.a.y, t.b.y, t.c.y), low(t.a.z, t.b.z, t.c.z)},
          {high(t.a.x, t.b.x, t.c.x), high(t.a.y, t.b.y, t.c.y), high(t.a.z, t.b.z, t.c.z)}};
}
template <Real T>
[[nodiscard]] Bounds<double> bounds_of(const Sphere<T>& s) {
  const double x = s.center.x, y = s.center.y, z = s.center.z, r = s.radius;
  return {{x - r, y - r, z - r}, {x + r, y + r, z + r}};
}

}  // namespace graze::cli
