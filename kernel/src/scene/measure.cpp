// The parts' validity, the scene's bounds and its box space.
#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <limits>

#include "scene/build.hpp"
#include "scene/lanes.hpp"
#include "scene/parallel.hpp"

namespace graze::scene {
namespace {

constexpr std::uint32_t most_primitives = std::uint32_t(1) << 30;

/// A box by integers in its coordinates' order, for which subnormal numbers count; of nothing, high is below low.
template <Real T>
struct Keys {
  using Point = std::array<std::int64_t, 3>;
  static constexpr std::int64_t none = std::numeric_limits<std::int64_t>::max();
  Point low{none, none, none}, high{-none, -none, -none};

  static Point of(const Vec3<T>& p) noexcept {
    return {numeric::order_key(p.x), numeric::order_key(p.y), numeric::order_key(p.z)};
  }
  void include(const Point& from, const Point& to) noexcept {
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], from[k]);
      high[k] = std::max(high[k], to[k]);
    }
  }
  void include(const Keys& other) noexcept { include(other.low, other.high); }

  [[nodiscard]] bool is_empty() const noexcept { return high[0] < low[0]; }
  /// Infinities and NaN lie beyond all numbers.
  [[nodiscard]] bool is_finite() const noexcept {
    const auto is_in = [](std::int64_t key) { return std::abs(key) < numeric::order_key(std::numeric_limits<T>::infinity()); };
    return is_empty() || (std::ranges::all_of(low, is_in) && std::ranges::all_of(high, is_in));
  }
  [[nodiscard]] Bounds<T> bounds() const noexcept { return {point(low), point(high)}; }

 private:
  static Vec3<T> point(const Point& keys) noexcept { return {number(keys[0]), number(keys[1]), number(keys[2])}; }
  static T number(std::int64_t key) noexcept {
    const T size = std::bit_cast<T>(static_cast<numeric::Bits<T>>(std::abs(key)));
    return key < 0 ? -size : size;
  }
};

/// What is wrong first with a part's elements, if anything is; if not, their bounds.
template <Real T>
struct Survey {
  BuildStatus status;
  Keys<T> keys;

  /// Another of elements that come later.
  void include(const Survey& later) noexcept {
    if (status.ok()) status = later.status;
    keys.include(later.keys);
  }
};

/// The first corner from a triangle on that is not finite; there is one.
template <Real T>
BuildStatus non_finite(const Mesh<T>& mesh, std::size_t from) noexcept {
  const std::span<const Vec3<T>> points = mesh.points.get();
  const std::span<const Corners> triangles = mesh.triangles.get();
  for (std::size_t i = from;; ++i) {
    for (std::uint32_t c = 0; c < 3; ++c) {
      if (!numeric::is_finite(points[triangles[i][c]])) return {BuildError::non_finite, 0, static_cast<std::uint32_t>(i), c};
    }
  }
}

template <Real T>
Survey<T> survey(const Mesh<T>& mesh, std::size_t begin, std::size_t end) noexcept {
  const std::span<const Vec3<T>> points = mesh.points.get();
  const std::span<const Corners> triangles = mesh.triangles.get();
  Survey<T> out;
  for (std::size_t i = begin; i < end && out.status.ok(); ++i) {
    for (std::uint32_t c = 0; c < 3; ++c) {
      const std::uint32_t point = triangles[i][c];
      if (point >= points.size()) {
        out.status = {BuildError::bad_index, 0, static_cast<std::uint32_t>(i), c};
        break;
      }
      const auto key = Keys<T>::of(points[point]);
      out.keys.include(key, key);
    }
  }
  // What is in the keys comes before a bad index.
  if (!out.keys.is_finite()) out.status = non_finite(mesh, begin);
  return out;
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

template <Real T>
Survey<T> survey(const Spheres<T>& spheres, std::size_t begin, std::size_t end) noexcept {
  const std::span<const Sphere<T>> all = spheres.spheres.get();
  Survey<T> out;
  for (std::size_t i = begin; i < end; ++i) {
    const auto& [c, r] = all[i];
    const auto element = static_cast<std::uint32_t>(i);
    if (!numeric::is_finite(c) || !numeric::is_finite(r)) {
      out.status = {BuildError::non_finite, 0, element, 0};
      return out;
    }
    if (numeric::is_negative(r)) {
      out.status = {BuildError::negative_radius, 0, element, 0};
      return out;
    }
    out.keys.include(Keys<T>::of({outward(c.x, r, -1), outward(c.y, r, -1), outward(c.z, r, -1)}),
                     Keys<T>::of({outward(c.x, r, 1), outward(c.y, r, 1), outward(c.z, r, 1)}));
  }
  return out;
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

/// All coordinates, and centers plus radii, come to at most 1 in magnitude, nearly: scale 2^900 at most. `corners` are the
/// triangles': of their coordinates the least or the greatest is farthest off, in every mode, for rounding keeps their order.
template <Real T>
Space space_of(const Content<T>& content, const Keys<T>& corners) {
  const std::array<double, 3> origin = middle(content);
  double largest = 0;
  const auto include = [&](const Vec3<T>& p, T radius) {
    const T x[3] = {p.x, p.y, p.z};
    for (int k = 0; k < 3; ++k) {
      const double size = __builtin_fabs(0.25 * to_double(x[k]) - 0.25 * origin[k]) + 0.25 * to_double(radius);
      largest = size > largest ? size : largest;
    }
  };
  if (!corners.is_empty()) {
    const Bounds<T> bounds = corners.bounds();
    include(bounds.low, T(0));
    include(bounds.high, T(0));
  }
  for (const Part<T>& part : content.parts) {
    const auto* spheres = std::get_if<Spheres<T>>(&part);
    if (spheres == nullptr) continue;
    for (const auto& [center, radius] : spheres->spheres.get()) include(center, radius);
  }
  // Quarters of at most 2^1023, so the exponent of the scale is at least -1024 + 2.
  const int exponent = std::clamp(-exponent_of(largest) - 1, -1022, 900);
  return Space::about<T>(origin, exponent - 2);
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
BuildStatus measure(Content<T>& content, Threads threads) {
  std::vector<std::uint32_t> first{0};
  std::uint64_t total = 0;
  Keys<T> all, corners;
  for (std::uint32_t i = 0; i < content.parts.size(); ++i) {
    const Part<T>& part = content.parts[i];
    total += size_of(part);
    if (total > most_primitives) return {BuildError::too_many, i, 0, 0};
    const auto of_range = [&](std::size_t begin, std::size_t end) {
      return std::visit([&](const auto& elements) { return survey(elements, begin, end); }, part);
    };
    // Spheres' bounds are rounded: all in the caller's mode.
    const bool is_mesh = std::holds_alternative<Mesh<T>>(part);
    Survey<T> one = summed<Survey<T>>(size_of(part), is_mesh ? threads : Threads::mine, of_range,
                                      [](auto& sum, const auto& later) { sum.include(later); });
    if (!one.status.ok()) {
      one.status.part = i;
      return one.status;
    }
    all.include(one.keys);
    if (is_mesh) corners.include(one.keys);
    first.push_back(static_cast<std::uint32_t>(total));
  }
  content.first = std::move(first);
  content.bounds = total == 0 ? Bounds<T>{} : all.bounds();
  content.extent = extent_of(content);
  content.space = total == 0 ? Space{} : space_of(content, corners);
  return {};
}

template BuildStatus measure(Content<float>&, Threads);
template BuildStatus measure(Content<double>&, Threads);

}  // namespace graze::scene
