#include "fuzz/report/drawing.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "fuzz/case_numbers.hpp"
#include "fuzz/case_text.hpp"
#include "fuzz/report/markup.hpp"
#include "fuzz/report/numbers.hpp"

namespace graze::fuzz {
namespace {

/// For pictures alone: its exponents reach far enough for products of three doubles.
using Number = long double;
struct Point3 {
  Number x, y, z;
};
struct Point {
  Number x, y;
};

Point3 operator-(const Point3& a, const Point3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Point operator-(const Point& a, const Point& b) {
  return {a.x - b.x, a.y - b.y};
}
Number dot(const Point3& a, const Point3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
Point3 cross(const Point3& a, const Point3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Number cross(const Point& a, const Point& b) {
  return a.x * b.y - a.y * b.x;
}
Number length(const Point3& a) {
  return std::sqrt(dot(a, a));
}
Point3 unit(const Point3& a) {
  const Number size = length(a);
  return {a.x / size, a.y / size, a.z / size};
}
template <Real T>
Point3 wide(const Vec3<T>& p) {
  return {p.x, p.y, p.z};
}

constexpr Number width = 240, height = 170;

/// Lines of a picture; points in pixels, y downward.
class Picture {
 public:
  void line(const char* style, Point a, Point b) {
    add(formatted("<line class='%s' x1='%.1f' y1='%.1f' x2='%.1f' y2='%.1f'/>", style, f(a.x), f(a.y), f(b.x), f(b.y)));
  }
  void circle(const char* style, Point center, Number radius) {
    add(formatted("<circle class='%s' cx='%.1f' cy='%.1f' r='%.1f'/>", style, f(center.x), f(center.y), f(radius)));
  }
  void triangle(Point a, Point b, Point c) {
    add(formatted("<path class='shape' d='M%.1f %.1fL%.1f %.1fL%.1f %.1fZ'/>", f(a.x), f(a.y), f(b.x), f(b.y), f(c.x), f(c.y)));
  }
  void text(Point at, const std::string& words) {
    add(formatted("<text x='%.1f' y='%.1f'>", f(at.x), f(at.y)) + escaped(words) + "</text>");
  }
  /// The tip of an arrow that comes from `from`.
  void tip(Point from, Point to) {
    const Point d = to - from;
    const Number size = std::hypot(d.x, d.y);
    if (!(size > 0)) return;
    const Point u{d.x / size * 8, d.y / size * 8};
    line("ray", to, {to.x - u.x - u.y / 2, to.y - u.y + u.x / 2});
    line("ray", to, {to.x - u.x + u.y / 2, to.y - u.y - u.x / 2});
  }
  [[nodiscard]] std::string markup(const std::string& caption) const {
    return formatted("<figure><svg viewBox='0 0 %.0f %.0f' role='img' aria-label=\"", f(width), f(height)) + escaped(caption) +
           "\">" + lines_ + "</svg>" + element("figcaption", caption) + "</figure>\n";
  }

 private:
  static double f(Number x) { return static_cast<double>(std::clamp<Number>(x, -1e4L, 1e4L)); }
  void add(const std::string& markup) { lines_ += markup; }
  std::string lines_;
};

/// "2^40", or "3.5" where that is shorter.
std::string magnitude(Number x) {
  if (x > 0.01L && x < 1000) return formatted("%.3g", static_cast<double>(x));
  return "2^" + std::to_string(std::ilogb(x));
}

template <Real T>
std::string drawing_of(const RaySphere<T>& q) {
  const Point3 d = wide(q.ray.direction), l = wide(q.sphere.center) - wide(q.ray.origin);
  const Number r = q.sphere.radius, along = dot(d, l) / length(d), beside = length(cross(d, l)) / length(d);
  if (!std::isfinite(along) || !std::isfinite(beside)) return {};
  std::string caption = "In the plane of the ray and the center.";
  // In radii; what is out of the picture is moved to its border.
  const Number unit = r > 0 ? r : std::max(std::abs(along), beside);
  const Number far = 2.3L, side = std::clamp<Number>(unit > 0 ? beside / unit : 0, 0, 1.6L);
  const Number start = std::clamp<Number>(unit > 0 ? -along / unit : 0, -far, far);
  if (unit > 0 && std::abs(along) / unit > far) {
    caption +=
        " Not to scale: the origin is " + magnitude(std::abs(along) / unit) + " radii from the point nearest to the center.";
  }
  if (unit > 0 && beside / unit > 1.6L)
    caption += " Not to scale: the ray passes " + magnitude(beside / unit) + " radii from the center.";
  if (r > 0 && r != beside && std::abs(beside - r) < 0.02L * r) {
    caption += " The ray's line passes " + magnitude(std::abs(beside - r) / r) + " radii " +
               (beside < r ? "within" : "beside") + " a tangent's: too little to be seen.";
  }
  if (!(r > 0)) caption = "The sphere is a point. Not to scale.";
  const Number scale = 48;
  const auto place = [&](Number x, Number y) { return Point{width / 2 + scale * x, height / 2 - scale * y}; };
  Picture picture;
  picture.circle(r > 0 ? "shape" : "dot", place(0, 0), r > 0 ? scale : 2.5L);
  picture.line("guide", place(-2.5L, side), place(2.5L, side));
  picture.line("ray", place(start, side), place(2.45L, side));
  picture.tip(place(start, side), place(2.45L, side));
  picture.circle("dot", place(start, side), 3.5L);
  picture.text({place(start, side).x - 3, place(start, side).y - 8}, "e");
  picture.circle("center", place(0, 0), 1.5L);
  return picture.markup(caption);
}

/// The triangle and a point in it or a line by it, in a plane; `at` is where the ray crosses, `from` and `to` where it runs
/// along.
struct Flat {
  std::array<Point, 3> corners;
  Point from, to;
  bool is_line;
};

/// Puts the corners into the picture. False where the triangle is too thin or the ray too far off for that.
bool fit(Flat& flat) {
  Point low = flat.corners[0], high = low;
  for (const Point& p : flat.corners) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const Number size = std::max(high.x - low.x, high.y - low.y);
  const Number area = std::abs(cross(flat.corners[1] - flat.corners[0], flat.corners[2] - flat.corners[0]));
  if (!(size > 0) || !std::isfinite(size) || !(area > 0.15L * size * size)) return false;
  const Point& p = flat.from;
  if (!(std::max({low.x - p.x, p.x - high.x, low.y - p.y, p.y - high.y}) < 0.6L * size)) return false;
  low = {std::min(low.x, flat.from.x), std::min(low.y, flat.from.y)};
  high = {std::max(high.x, flat.from.x), std::max(high.y, flat.from.y)};
  const Number scale =
      std::min((width - 50) / std::max(high.x - low.x, size / 9), (height - 50) / std::max(high.y - low.y, size / 9));
  const auto place = [&](const Point& p) {
    return Point{width / 2 + scale * (p.x - (low.x + high.x) / 2), height / 2 - scale * (p.y - (low.y + high.y) / 2)};
  };
  for (Point& p : flat.corners) p = place(p);
  flat.from = place(flat.from);
  flat.to = place(flat.to);
  return true;
}

/// The part of a ray that is in the frame.
void draw_ray(Picture& picture, const Point& from, const Point& direction, std::string& caption) {
  const Number size = std::hypot(direction.x, direction.y);
  const Point d{direction.x / size, direction.y / size};
  Number enter = 0, leave = 1e30L;
  const auto clip = [&](Number at, Number step, Number end) {
    if (!(std::abs(step) > 1e-12L)) {
      if (at < 4 || at > end - 4) leave = -1;
      return;
    }
    const Number one = (4 - at) / step, other = (end - 4 - at) / step;
    enter = std::max(enter, std::min(one, other));
    leave = std::min(leave, std::max(one, other));
  };
  clip(from.x, d.x, width);
  clip(from.y, d.y, height);
  if (!(size > 0) || !(enter < leave)) {
    caption += " The ray passes outside of the picture.";
    return;
  }
  const Point first{from.x + enter * d.x, from.y + enter * d.y}, last{from.x + leave * d.x, from.y + leave * d.y};
  picture.line("ray", first, last);
  picture.tip(first, last);
  if (enter > 0) {
    caption += " The origin lies outside of the picture.";
    return;
  }
  picture.circle("dot", from, 3.5L);
  picture.text({from.x + 6, from.y - 6}, "e");
}

std::string picture_of(const Flat& flat, std::string caption) {
  Picture picture;
  picture.triangle(flat.corners[0], flat.corners[1], flat.corners[2]);
  const Point middle{(flat.corners[0].x + flat.corners[1].x + flat.corners[2].x) / 3,
                     (flat.corners[0].y + flat.corners[1].y + flat.corners[2].y) / 3};
  for (std::size_t i = 0; i < 3; ++i) {
    const Point away = flat.corners[i] - middle;
    const Number size = std::max<Number>(std::hypot(away.x, away.y), 1);
    picture.text({flat.corners[i].x + away.x / size * 11 - 3, flat.corners[i].y + away.y / size * 11 + 4},
                 std::string(1, "abc"[i]));
  }
  if (flat.is_line) {
    draw_ray(picture, flat.from, flat.to - flat.from, caption);
  } else {
    // The tail of an arrow that flies away from the reader.
    picture.circle("ring", flat.from, 6);
    picture.line("ray", {flat.from.x - 4, flat.from.y - 4}, {flat.from.x + 4, flat.from.y + 4});
    picture.line("ray", {flat.from.x - 4, flat.from.y + 4}, {flat.from.x + 4, flat.from.y - 4});
  }
  return picture.markup(caption);
}

template <Real T>
std::string drawing_of(const RayTriangle<T>& q) {
  const Point3 e = wide(q.ray.origin), a = wide(q.triangle.a) - e, b = wide(q.triangle.b) - e, c = wide(q.triangle.c) - e;
  const Point3 d = unit(wide(q.ray.direction)), ab = b - a, ac = c - a;
  const Number extent = std::max(length(ab), length(ac));
  if (!std::isfinite(extent) || !std::isfinite(d.x)) return {};
  const Point3 n = cross(ab, ac);
  const Number facing = length(n) > 0 ? dot(d, unit(n)) : 0;
  const bool is_along = std::abs(facing) < 1e-3L;
  if (!(length(n) > 0)) {
    // A segment or a point: the ray from the side, the triangle as it lies to it.
    Picture picture;
    picture.line("shape", {60, 85}, {180, 85});
    for (const Number x : {60.0L, 180.0L}) picture.circle("dot", {x, 85}, 2.5L);
    return picture.markup("The triangle has no area. Not to scale, and without the ray.");
  }
  // A frame whose third axis is the direction of sight.
  const Point3 sight = is_along ? unit(n) : d;
  const Point3 first = unit(is_along ? d : std::abs(d.x) < 0.7L ? cross(d, {1, 0, 0}) : cross(d, {0, 1, 0}));
  const Point3 second = cross(sight, first);
  const auto flat_point = [&](const Point3& p) { return Point{dot(p, first), dot(p, second)}; };
  Flat flat{{flat_point(a), flat_point(b), flat_point(c)}, {0, 0}, {extent, 0}, is_along};
  const std::array<Point, 3> seen = flat.corners;
  const char* const view = is_along ? "Seen from above the triangle, whose plane the ray is in, or nearly so."
                                    : "As the ray sees it: it crosses at the mark.";
  if (fit(flat)) return picture_of(flat, view);

  // In u and v: an affine picture keeps what is inside, on an edge and at a corner.
  const Point p = seen[1] - seen[0], r = seen[2] - seen[0];
  const Number area = cross(p, r);
  const auto affine = [&](const Point& s) {
    const Point from_a = s - seen[0];
    return Point{cross(from_a, r) / area, cross(p, from_a) / area};
  };
  const Point at = affine({0, 0}), next = affine({extent, 0});
  if (!std::isfinite(at.x) || !std::isfinite(at.y)) return {};
  constexpr Number border = 0.45L;
  const Point shown{std::clamp<Number>(at.x, -border, 1 + border), std::clamp<Number>(at.y, -border, 1 + border)};
  const bool is_moved = !is_along && (shown.x != at.x || shown.y != at.y);
  const auto place = [](const Point& uv) { return Point{70 + 105 * uv.x + 20 * uv.y, 130 - 90 * uv.y}; };
  const Flat drawn{{place({0, 0}), place({1, 0}), place({0, 1})}, place(is_along ? at : shown), place(next), is_along};
  return picture_of(drawn, std::string(view) + " Not to scale: drawn in u and v, so that every triangle has this shape." +
                               (is_moved ? " The mark lies farther off." : ""));
}

template <class Query>
std::string drawing_of(const Query&) {
  return {};
}

template <Real T>
std::string drawing_in(const Offender& offender) {
  const auto parsed = parse_case<T>(offender.input);
  const auto* input = std::get_if<Case<T>>(&parsed);
  if (input == nullptr) return {};
  return std::visit(
      [](const auto& query) {
        bool is_finite = true;
        for_each_number(query, [&](T number) { is_finite = is_finite && !std::isnan(number); });
        return is_finite ? drawing_of(query) : std::string();
      },
      *input);
}

}  // namespace

std::string drawing(const Offender& offender) {
  return offender.precision == precision_name<float> ? drawing_in<float>(offender) : drawing_in<double>(offender);
}

}  // namespace graze::fuzz
