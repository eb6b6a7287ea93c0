// A pinhole camera that sees a whole scene.
#pragma once

#include <cmath>
#include <optional>

#include "graze/scene.hpp"

namespace graze::cli {

/// Looks at the middle of the bounds from three half diagonals off. The picture is what of the plane through the middle, square
/// to the view, is between the eye and the bounds' corners; its pixels are squares on that plane.
class Camera {
 public:
  /// A place on the picture, in pixels from its upper left, and the distance from the eye along the view.
  struct Spot {
    double x, y, depth;
  };

  /// `from` is where the eye is, seen from the middle, at any distance; y is up. `size` is the number of pixels on the longer
  /// side. The eye is a point of the format T, so that rays start there. None where the bounds are too large for that.
  template <Real T>
  [[nodiscard]] static std::optional<Camera> of(const Bounds<T>& bounds, const Vec3<double>& from, int size);

  [[nodiscard]] const Vec3<double>& eye() const { return eye_; }
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  /// From the eye to a place on the picture.
  [[nodiscard]] Vec3<double> way_to(double x, double y) const;
  /// Where a point is seen; none where it is not before the eye.
  [[nodiscard]] std::optional<Spot> spot_of(const Vec3<double>& point) const;

 private:
  Vec3<double> eye_, right_, up_, forward_;
  double distance_ = 0, left_ = 0, top_ = 0, pixel_ = 0;
  int width_ = 0, height_ = 0;
};

[[nodiscard]] inline double dot(const Vec3<double>& a, const Vec3<double>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
[[nodiscard]] inline Vec3<double> cross(const Vec3<double>& a, const Vec3<double>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// Of length 1; the zero vector stays.
[[nodiscard]] inline Vec3<double> unit(const Vec3<double>& v) {
  const double length = std::hypot(v.x, v.y, v.z);
  return length > 0 ? Vec3<double>{v.x / length, v.y / length, v.z / length} : v;
}
/// The corners of a box, i from 0 to 7.
template <Real T>
[[nodiscard]] Vec3<double> corner(const Bounds<T>& b, int i) {
  return {double((i & 1) != 0 ? b.high.x : b.low.x), double((i & 2) != 0 ? b.high.y : b.low.y),
          double((i & 4) != 0 ? b.high.z : b.low.z)};
}

}  // namespace graze::cli
