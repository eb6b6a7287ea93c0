// The parts' validity, the scene's bounds and its box space.
#include <algorithm>
#include <array>
#include <cmath>

#include "scene/build.hpp"
#include "scene/lanes.hpp"

namespace graze::scene {
namespace {

constexpr std::uint32_t most_primitives = std::uint32_t(1) << 30;

template <Real T>
BuildStatus check(const Mesh<T>& mesh, std::uint32_t part) noexcept {
  const std::span<const Vec3<T>> points = mesh.points.get();
  const std::span<const Corners> triangles = mesh.triangles.get();
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    for (std::uint32_t c = 0; c < 3; ++c) {
      const std::uint32_t point = triangles[i][c];
      if (point >= points.size()) return {BuildError::bad_index, part, i, c};
      if (!numeric::is_finite(points[point])) return {BuildError::non_finite, part, i, c};
    }
  }
  return {};
}

template <Real T>
BuildStatus check(const Spheres<T>& spheres, std::uint32_t part) noexcept {
  const std::span<const Sphere<T>> all = spheres.spheres.get();
  for (std::uint32_t i = 0; i < all.size(); ++i) {
    if (!numeric::is_finite(all[i].center) || !numeric::is_finite(all[i].radius)) return {BuildError::non_finite, part, i, 0};
    if (numeric::is_negative(all[i].radius)) return {BuildError::negative_radius, part, i, 0};
  }
  return {};
}

/// x - r and x + r rounded outward, in every mode: one operation errs by less than a unit, or by less than the least normal
/// number.
template <Real T>
T outward(T x, T r, int direction) noexcept {
  using Limits = std::numeric_limits<T>;
  const T sum = direction < 0 ? x - r : x + r;
  if (numeric::magnitude_bits(sum) <= numeric::bits_of(2 * Limits::min())) return direction * 4 * Limits::min();
  if (!numeric::is_finite(sum)) return sum;
  const bool grows = (direction < 0) == ((numeric::bits_of(sum) & numeric::sign_bit<T>) != 0);
  return std::bit_cast<T>(static_cast<numeric::Bits<T>>(numeric::bits_of(sum) + (grows ? 1 : -1)));
}

/// Ordered as integers, for which subnormal numbers count.
template <Real T>
void include(Bounds<T>& bounds, const Vec3<T>& low, const Vec3<T>& high) noexcept {
  const auto lower = [](T& to, T x) {
    if (numeric::order_key(x) < numeric::order_key(to)) to = x;
  };
  const auto raise = [](T& to, T x) {
    if (numeric::order_key(x) > numeric::order_key(to)) to = x;
  };
  lower(bounds.low.x, low.x);
  lower(bounds.low.y, low.y);
  lower(bounds.low.z, low.z);
  raise(bounds.high.x, high.x);
  raise(bounds.high.y, high.y);
  raise(bounds.high.z, high.z);
}

template <Real T>
Bounds<T> bounds_of(const Content<T>& content) noexcept {
  constexpr T infinity = std::numeric_limits<T>::infinity();
  Bounds<T> bounds{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
  for (const Part<T>& part : content.parts) {
    if (const auto* mesh = std::get_if<Mesh<T>>(&part)) {
      const std::span<const Vec3<T>> points = mesh->points.get();
      for (const Corners& corners : mesh->triangles.get()) {
        for (const std::uint32_t c : corners) include(bounds, points[c], points[c]);
      }
    } else {
      for (const auto& [c, r] : std::get<Spheres<T>>(part).spheres.get()) {
        include(bounds, {outward(c.x, r, -1), outward(c.y, r, -1), outward(c.z, r, -1)},
                {outward(c.x, r, 1), outward(c.y, r, 1), outward(c.z, r, 1)});
      }
    }
  }
  return bounds;
}

/// The median of up to 1,001 primitives' first corners or centers: a few shapes far away do not move it.
template <Real T>
std::array<double, 3> middle(const Content<T>& content) {
  constexpr std::uint32_t samples = 1001;
  std::array<std::array<double, samples>, 3> sample;
  std::uint32_t n = 0;
  const std::uint32_t size = content.size(), step = size / samples + 1;
  for (std::uint32_t i = 0; i < size; i += step) {
    const std::uint32_t part = content.part_of(i), element = i - content.first[part];
    const auto* mesh = std::get_if<Mesh<T>>(&content.parts[part]);
    const Vec3<T> p = mesh != nullptr ? mesh->points[mesh->triangles[element][0]]
                                      : std::get<Spheres<T>>(content.parts[part]).spheres[element].center;
    sample[0][n] = to_double(p.x);
    sample[1][n] = to_double(p.y);
    sample[2][n++] = to_double(p.z);
  }
  std::array<double, 3> out{};
  for (int k = 0; k < 3; ++k) {
    std::nth_element(sample[k].begin(), sample[k].begin() + n / 2, sample[k].begin() + n);
    out[k] = sample[k][n / 2];
  }
  return out;
}

/// All coordinates, and centers plus radii, come to at most 1 in magnitude, nearly: scale 2^900 at most.
template <Real T>
Space space_of(const Content<T>& content) {
  Space space;
  const std::array<double, 3> origin = middle(content);
  for (int k = 0; k < 3; ++k) space.quarter_origin[k] = 0.25 * origin[k];
  double largest = 0;
  const auto include = [&](const Vec3<T>& p, T radius) {
    const T x[3] = {p.x, p.y, p.z};
    for (int k = 0; k < 3; ++k) {
      const double size = __builtin_fabs(0.25 * to_double(x[k]) - space.quarter_origin[k]) + 0.25 * to_double(radius);
      largest = size > largest ? size : largest;
    }
  };
  for (const Part<T>& part : content.parts) {
    if (const auto* mesh = std::get_if<Mesh<T>>(&part)) {
      const std::span<const Vec3<T>> points = mesh->points.get();
      for (const Corners& corners : mesh->triangles.get()) {
        for (const std::uint32_t c : corners) include(points[c], T(0));
      }
    } else {
      for (const auto& [center, radius] : std::get<Spheres<T>>(part).spheres.get()) include(center, radius);
    }
  }
  // Quarters of at most 2^1023, so the exponent of the scale is at least -1024 + 2.
  const int exponent = std::clamp(-exponent_of(largest) - 1, -1022, 900);
  space.scale = power_of_two(exponent);
  space.exponent = exponent - 2;
  return space;
}

template <Real T>
numeric::Extent extent_of(const Content<T>& content) noexcept {
  numeric::Extent extent;
  for (const Part<T>& part : content.parts) {
    const auto* mesh = std::get_if<Mesh<T>>(&part);
    if (mesh == nullptr) continue;
    const std::span<const Vec3<T>> points = mesh->points.get();
    for (const Corners& corners : mesh->triangles.get()) {
      for (const std::uint32_t c : corners) extent.include(numeric::dyadic(points[c]));
      // What is no scene of small integers is seldom taken for one for long.
      if (!is_small(extent)) return extent;
    }
  }
  return extent;
}

}  // namespace

template <Real T>
BuildStatus measure(Content<T>& content) {
  std::vector<std::uint32_t> first{0};
  std::uint64_t total = 0;
  for (std::uint32_t i = 0; i < content.parts.size(); ++i) {
    total += size_of(content.parts[i]);
    if (total > most_primitives) return {BuildError::too_many, i, 0, 0};
    const BuildStatus status = std::visit([&](const auto& part) { return check(part, i); }, content.parts[i]);
    if (!status.ok()) return status;
    first.push_back(static_cast<std::uint32_t>(total));
  }
  content.first = std::move(first);
  content.bounds = total == 0 ? Bounds<T>{} : bounds_of(content);
  content.extent = extent_of(content);
  content.space = total == 0 ? Space{} : space_of(content);
  return {};
}

template BuildStatus measure(Content<float>&);
template BuildStatus measure(Content<double>&);

}  // namespace graze::scene
