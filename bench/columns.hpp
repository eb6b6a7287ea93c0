// Shapes, rays and answers as the arrays that batches take.
#pragma once

#include <span>
#include <vector>

#include "bench/entry.hpp"
#include "graze/batch.hpp"

namespace graze::bench {

/// N arrays of T, filled row by row.
template <Real T, std::size_t N>
class Columns {
 public:
  void add(const T (&row)[N]) {
    for (std::size_t k = 0; k < N; ++k) column_[k].push_back(row[k]);
  }
  [[nodiscard]] const T* at(std::size_t k) const { return column_[k].data(); }
  [[nodiscard]] batch::Vec3Arrays<T> vec3(std::size_t k) const { return {at(k), at(k + 1), at(k + 2)}; }
  [[nodiscard]] std::size_t size() const { return column_[0].size(); }

 private:
  std::vector<T> column_[N];
};

template <Real T>
class RayColumns {
 public:
  void add(const Ray<T>& r) { columns_.add({r.origin.x, r.origin.y, r.origin.z, r.direction.x, r.direction.y, r.direction.z}); }
  /// With the default range.
  [[nodiscard]] batch::RayArrays<T> arrays() const { return {columns_.vec3(0), columns_.vec3(3), columns_.size()}; }

 private:
  Columns<T, 6> columns_;
};

template <Real T>
class TriangleColumns {
 public:
  void add(const Triangle<T>& t) { columns_.add({t.a.x, t.a.y, t.a.z, t.b.x, t.b.y, t.b.z, t.c.x, t.c.y, t.c.z}); }
  [[nodiscard]] batch::TriangleArrays<T> arrays() const {
    return {columns_.vec3(0), columns_.vec3(3), columns_.vec3(6), columns_.size()};
  }
  /// Back one by one, from the arrays.
  [[nodiscard]] static Triangle<T> at(const batch::TriangleArrays<T>& t, std::size_t i) {
    return {{t.a.x[i], t.a.y[i], t.a.z[i]}, {t.b.x[i], t.b.y[i], t.b.z[i]}, {t.c.x[i], t.c.y[i], t.c.z[i]}};
  }

 private:
  Columns<T, 9> columns_;
};

template <Real T>
class SphereColumns {
 public:
  void add(const Sphere<T>& s) { columns_.add({s.center.x, s.center.y, s.center.z, s.radius}); }
  [[nodiscard]] batch::SphereArrays<T> arrays() const { return {columns_.vec3(0), columns_.at(3), columns_.size()}; }
  [[nodiscard]] static Sphere<T> at(const batch::SphereArrays<T>& s, std::size_t i) {
    return {{s.center.x[i], s.center.y[i], s.center.z[i]}, s.radius[i]};
  }

 private:
  Columns<T, 4> columns_;
};

}  // namespace graze::bench
