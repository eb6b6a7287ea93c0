#include "cli/camera.hpp"

#include <algorithm>

namespace graze::cli {

template <Real T>
std::optional<Camera> Camera::of(const Bounds<T>& bounds, const Vec3<double>& from, int size) {
  const Vec3<double> low = corner(bounds, 0), high = corner(bounds, 7);
  const Vec3<double> middle{low.x / 2 + high.x / 2, low.y / 2 + high.y / 2, low.z / 2 + high.z / 2};
  const double magnitude = std::max({std::fabs(middle.x), std::fabs(middle.y), std::fabs(middle.z)});
  double radius = std::hypot(high.x - low.x, high.y - low.y, high.z - low.z) / 2;
  // One point is seen from anywhere.
  if (radius == 0) radius = magnitude > 0 ? magnitude : 1;
  const Vec3<double> direction = unit(from);
  const auto along = [&](double m, double d) { return static_cast<double>(static_cast<T>(m + 3 * radius * d)); };
  Camera camera;
  camera.eye_ = {along(middle.x, direction.x), along(middle.y, direction.y), along(middle.z, direction.z)};
  const Vec3<double> to{middle.x - camera.eye_.x, middle.y - camera.eye_.y, middle.z - camera.eye_.z};
  camera.distance_ = std::hypot(to.x, to.y, to.z);
  if (!std::isfinite(camera.distance_) || !(camera.distance_ > 0)) return {};
  camera.forward_ = unit(to);
  const bool is_upright = std::fabs(camera.forward_.y) < 0.999;
  camera.right_ = unit(cross(camera.forward_, is_upright ? Vec3<double>{0, 1, 0} : Vec3<double>{0, 0, -1}));
  camera.up_ = cross(camera.right_, camera.forward_);
  camera.pixel_ = 1;
  // On the plane, from the middle.
  double left = 0, right = 0, top = 0, bottom = 0;
  for (int i = 0; i < 8; ++i) {
    const auto spot = camera.spot_of(corner(bounds, i));
    if (!spot) continue;
    left = std::min(left, spot->x);
    right = std::max(right, spot->x);
    top = std::min(top, spot->y);
    bottom = std::max(bottom, spot->y);
  }
  // A margin of a fiftieth.
  const double width = right - left, height = bottom - top, longer = std::max({width, height, radius * 0x1p-20});
  camera.pixel_ = longer * 1.04 / size;
  if (!(camera.pixel_ > 0)) return {};
  const auto pixels = [&](double extent) {
    return std::clamp(static_cast<int>(std::ceil((extent + 0.04 * longer) / camera.pixel_)), 1, size);
  };
  camera.width_ = pixels(width);
  camera.height_ = pixels(height);
  camera.left_ = (left + right) / 2 - camera.width_ * camera.pixel_ / 2;
  camera.top_ = (top + bottom) / 2 - camera.height_ * camera.pixel_ / 2;
  return camera;
}

Vec3<double> Camera::way_to(double x, double y) const {
  const double r = left_ + x * pixel_, u = -(top_ + y * pixel_);
  return {distance_ * forward_.x + r * right_.x + u * up_.x, distance_ * forward_.y + r * right_.y + u * up_.y,
          distance_ * forward_.z + r * right_.z + u * up_.z};
}

std::optional<Camera::Spot> Camera::spot_of(const Vec3<double>& point) const {
  const Vec3<double> way{point.x - eye_.x, point.y - eye_.y, point.z - eye_.z};
  const double depth = dot(way, forward_);
  if (!(depth > 0)) return {};
  const double scale = distance_ / depth;
  return Spot{(dot(way, right_) * scale - left_) / pixel_, (-dot(way, up_) * scale - top_) / pixel_, depth};
}

template std::optional<Camera> Camera::of(const Bounds<float>&, const Vec3<double>&, int);
template std::optional<Camera> Camera::of(const Bounds<double>&, const Vec3<double>&, int);

}  // namespace graze::cli
