#include "scene/splits.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

namespace graze::scene {
namespace {

/// In box space, each coordinate within 2^-50.
using Point = std::array<double, 3>;
using Points = std::array<Point, 3>;

template <Real T>
[[nodiscard]] Points points_of(const Data<T>& data, std::uint32_t primitive) noexcept {
  const Triangle<T> triangle = triangle_of(data, primitive);
  Points out;
  int i = 0;
  for (const Vec3<T>& p : {triangle.a, triangle.b, triangle.c}) {
    out[i++] = {data.space.coordinate(to_double(p.x), 0), data.space.coordinate(to_double(p.y), 1),
                data.space.coordinate(to_double(p.z), 2)};
  }
  return out;
}

/// What a box has more than the many small ones that a triangle would come to: half of its surface less half the absolute
/// components of the edges' cross product. The cube root of that, so that the greatest do not take all.
[[nodiscard]] float waste(const Points& p, const Reference& r) noexcept {
  double ideal = 0;
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    ideal += 0.5 * std::fabs((p[1][i] - p[0][i]) * (p[2][j] - p[0][j]) - (p[1][j] - p[0][j]) * (p[2][i] - p[0][i]));
  }
  const float rest = r.box().half_area() - static_cast<float>(ideal);
  return rest > 0x1p-60f ? std::cbrt(rest) : 0;
}

/// How often each is parted, `budget` in all or a few less: in proportion to its waste.
[[nodiscard]] std::vector<std::uint32_t> shares(const std::vector<float>& wastes, std::size_t budget) {
  double sum = 0;
  for (const float w : wastes) sum += static_cast<double>(w);
  std::vector<std::uint32_t> out(wastes.size(), 0);
  if (!(sum > 0)) return out;
  const auto share = [](float w, double factor) { return static_cast<std::uint32_t>(static_cast<double>(w) * factor); };
  // At the upper end at least the budget is spent, for rounding down takes less than one from each.
  double low = 0, high = static_cast<double>(budget + wastes.size()) / sum;
  for (int step = 0; step < 24; ++step) {
    const double middle = 0.5 * (low + high);
    std::size_t spent = 0;
    for (const float w : wastes) spent += share(w, middle);
    (spent <= budget ? low : high) = middle;
  }
  for (std::size_t i = 0; i < wastes.size(); ++i) out[i] = share(wastes[i], low);
  return out;
}

/// A plane through a box at a multiple of a power of two, near its middle, so that neighbours are parted at the same planes.
/// None where floats are too coarse for one.
[[nodiscard]] std::optional<float> plane_through(float low, float high) noexcept {
  const double from = static_cast<double>(low), extent = static_cast<double>(high) - from;
  if (!(extent > 0x1p-40)) return {};
  for (const double step : {power_of_two(exponent_of(extent)), power_of_two(exponent_of(extent) - 1)}) {
    const auto plane = static_cast<float>(std::nearbyint((from + 0.5 * extent) / step) * step);
    if (plane > low && plane < high) return plane;
  }
  return {};
}

/// The reference of what lies on one side of a plane; none where that is nothing. No point of the exact triangle that is in
/// the whole's box and not beyond the plane is outside. For that part is the hull of the corners on this side, and of where
/// edges cross the plane. Corners are known within 2^-50; those within 2^-48 of the plane count as on both sides, and edges
/// that come as near as crossing. Where an edge's run r along the axis is at least 2^-30, s, the share of the edge up to the
/// plane, errs by 2^-49 / r for its numerator, and by less than 2^-19 of it for its denominator, hence, as |s| <= 1 once
/// clamped, by less than 2^-48 / r; so its point errs by 2^-48 |b - a| / r for s, and 2^-49 for the rest. An edge of less
/// run is taken whole.
[[nodiscard]] std::optional<Reference> side_of(const Points& corners, const Reference& whole, int axis, float plane,
                                               bool is_above) noexcept {
  Reference out = whole;
  const double at = static_cast<double>(plane);
  Point low{2, 2, 2}, high{-2, -2, -2};
  const auto include = [&](int k, double x, double error) {
    low[k] = std::min(low[k], x - error);
    high[k] = std::max(high[k], x + error);
  };
  for (int i = 0; i < 3; ++i) {
    const Point &a = corners[i], &b = corners[(i + 1) % 3];
    const double run = b[axis] - a[axis];
    const bool is_on_side = is_above ? a[axis] >= at - 0x1p-48 : a[axis] <= at + 0x1p-48;
    const bool is_crossing = std::min(a[axis], b[axis]) <= at + 0x1p-48 && std::max(a[axis], b[axis]) >= at - 0x1p-48;
    const bool is_whole = is_crossing && std::fabs(run) < 0x1p-30;
    const double share = is_crossing && !is_whole ? std::clamp((at - a[axis]) / run, 0.0, 1.0) : 0;
    for (int k = 0; k < 3; ++k) {
      if (is_on_side || is_whole) include(k, a[k], 0x1p-47);
      if (is_whole) include(k, b[k], 0x1p-47);
      if (is_crossing && !is_whole) {
        include(k, a[k] + share * (b[k] - a[k]), 0x1p-47 * std::fabs((b[k] - a[k]) / run) + 0x1p-47);
      }
    }
  }
  for (int k = 0; k < 3; ++k) {
    out.low[k] = std::max(whole.low[k], below(low[k], 0x1p-47));
    out.high[k] = std::min(whole.high[k], above(high[k], 0x1p-47));
  }
  float& bound = is_above ? out.low[axis] : out.high[axis];
  bound = is_above ? std::max(bound, plane) : std::min(bound, plane);
  const bool is_nothing = out.low[0] > out.high[0] || out.low[1] > out.high[1] || out.low[2] > out.high[2];
  return is_nothing ? std::nullopt : std::optional(out);
}

[[nodiscard]] int longest_axis(const Reference& r) noexcept {
  int axis = 0;
  for (int k = 1; k < 3; ++k) axis = r.high[k] - r.low[k] > r.high[axis] - r.low[axis] ? k : axis;
  return axis;
}

/// Parts the reference `times` times, where that is possible, and appends what it comes to.
void part(const Points& corners, const Reference& whole, std::uint32_t times, Pages<Reference>& out) {
  const int axis = longest_axis(whole);
  const std::optional<float> plane = times == 0 ? std::nullopt : plane_through(whole.low[axis], whole.high[axis]);
  const auto one = plane ? side_of(corners, whole, axis, *plane, false) : std::nullopt;
  const auto other = plane ? side_of(corners, whole, axis, *plane, true) : std::nullopt;
  if (!one || !other) {
    out.push_back(one ? *one : other ? *other : whole);
    return;
  }
  const auto length = [](const Reference& r) {
    const int k = longest_axis(r);
    return static_cast<double>(r.high[k] - r.low[k]);
  };
  const double share = length(*one) / (length(*one) + length(*other));
  const auto first = std::min(times - 1, static_cast<std::uint32_t>(share * static_cast<double>(times)));
  part(corners, *one, first, out);
  part(corners, *other, times - 1 - first, out);
}

}  // namespace

template <Real T>
void split(const Data<T>& data, Pages<Reference>& references) {
  std::vector<float> wastes(references.size(), 0);
  for (std::size_t i = 0; i < references.size(); ++i) {
    const Reference& r = references[i];
    if (r.is_sphere == 0) wastes[i] = waste(points_of(data, r.index), r);
  }
  const std::vector<std::uint32_t> times = shares(wastes, references.size());
  Pages<Reference> out;
  out.reserve(2 * references.size());
  for (std::size_t i = 0; i < references.size(); ++i) {
    const Reference& r = references[i];
    if (times[i] == 0) {
      out.push_back(r);
    } else {
      part(points_of(data, r.index), r, times[i], out);
    }
  }
  references.swap(out);
}

template void split(const Data<float>&, Pages<Reference>&);
template void split(const Data<double>&, Pages<Reference>&);

}  // namespace graze::scene
