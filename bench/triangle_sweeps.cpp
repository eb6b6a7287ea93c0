#include "bench/triangle_sweeps.hpp"

#include <algorithm>

namespace graze::bench {
namespace {

using Query = fuzz::RayTriangle<double>;

Triangle<double> any_triangle(Draws& draws) {
  const Vec3<double> a = draws.point(), b = draws.point(), c = draws.point();
  return {a, b, c};
}

Vec3<double> face_point(const Triangle<double>& t, Draws& draws) {
  double u = draws.fraction(), v = draws.fraction();
  if (u + v > 1) u = 1 - u, v = 1 - v;
  return combination(t.a, u, difference(t.b, t.a), v, difference(t.c, t.a));
}

Query aimed(const Vec3<double>& e, const Triangle<double>& t, Draws& draws) {
  return {{e, difference(face_point(t, draws), e)}, t};
}

/// The rows of an integer matrix of determinant 1 with entries below 2^bits.
struct Rows {
  Vec3<double> row[3];
};
Rows unimodular(int bits, Draws& draws) {
  Rows rows{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const auto largest = [](const Vec3<double>& v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); };
  std::size_t to = draws.bits() % 3;
  const auto most = static_cast<std::int64_t>(std::ldexp(1.0, std::min(bits / 3, 8)));
  for (int i = 0; i < 12; ++i) {
    const std::size_t from = (to + 1 + draws.bits() % 2) % 3;
    const Vec3<double> next =
        combination(rows.row[to], static_cast<double>(draws.integer(most)), rows.row[from], 0.0, rows.row[to]);
    if (largest(next) < std::ldexp(1.0, bits)) rows.row[to] = next;
    to = from;
  }
  return rows;
}

/// An edge weight of about 2^-level, exactly: with a unimodular matrix of entries of level / 3 bits, the ray runs from 0 along
/// its first row, and two corners are multiples of the others; the third corner is any vector. All are filled up to 52 bits,
/// so the edge's determinant is 2^-level of the others.
Query near_edge(int level, Draws& draws) {
  const int bits = std::max(level / 3, 1);
  const Rows rows = unimodular(bits, draws);
  const auto factor = [&] { return std::floor(std::ldexp(1 + draws.fraction(), 51 - bits)); };
  const Vec3<double> d = scaled(rows.row[0], factor()), p = scaled(rows.row[1], factor()), q = scaled(rows.row[2], factor());
  const auto entry = [&] { return std::nearbyint(std::ldexp(draws.uniform(), 51)); };
  const auto det = [](const Vec3<double>& u, const Vec3<double>& v, const Vec3<double>& w) {
    const Vec3<double> n = perpendicular(v, w);
    return u.x * n.x + u.y * n.y + u.z * n.z;
  };
  Vec3<double> r;
  // Two determinants of one sign, which is made that of the edge's; signs at least, for a few tries.
  for (int attempt = 0; attempt < 4; ++attempt) {
    const double x = entry(), y = entry(), z = entry();
    r = {x, y, z};
    const double one = det(d, q, r), other = det(d, r, p);
    if (one < 0 && other < 0) r = scaled(r, -1.0);
    if ((one < 0) == (other < 0)) break;
  }
  Query query{{{0, 0, 0}, d}, {p, q, r}};
  // t < 0: the ray looks the other way.
  const Vec3<double> n = perpendicular(difference(q, p), difference(r, p));
  const double along = n.x * d.x + n.y * d.y + n.z * d.z, distance = n.x * p.x + n.y * p.y + n.z * p.z;
  if ((along < 0) != (distance < 0)) query.ray.direction = scaled(d, -1.0);
  return query;
}

Query sliver(int level, Draws& draws) {
  const Vec3<double> a = draws.point(), b = draws.point(), aside = draws.direction();
  const Vec3<double> foot = combination(a, draws.fraction(), difference(b, a), 0.0, a);
  const Triangle<double> t{a, b, combination(foot, std::ldexp(1.0, -level), aside, 0.0, aside)};
  return aimed(draws.point(), t, draws);
}

Query offset(int level, Draws& draws) {
  const Triangle<double> t = any_triangle(draws);
  const Vec3<double> e = draws.point(), away = scaled(draws.direction(), std::ldexp(1.0, level));
  Query q = aimed(e, t, draws);
  return {{sum(e, away), q.ray.direction}, {sum(t.a, away), sum(t.b, away), sum(t.c, away)}};
}

Query scale(int level, Draws& draws) {
  const Triangle<double> t = any_triangle(draws);
  Query q = aimed(draws.point(), t, draws);
  q.ray.direction = scaled(q.ray.direction, std::ldexp(1.0, level));
  return q;
}

Query angle(int level, Draws& draws) {
  const Triangle<double> t = any_triangle(draws);
  const Vec3<double> p = face_point(t, draws), q = face_point(t, draws);
  const Vec3<double> normal = unit(perpendicular(difference(t.b, t.a), difference(t.c, t.a)));
  const Vec3<double> d = combination(unit(difference(p, q)), std::ldexp(draws.sign(), -level), normal, 0.0, normal);
  return {{combination(p, -2.0, d, 0.0, d), d}, t};
}

Query spread(int level, Draws& draws) {
  const Vec3<double> a = spread_out(draws.point(), level, draws), b = spread_out(draws.point(), level, draws),
                     c = spread_out(draws.point(), level, draws);
  return aimed(spread_out(draws.point(), level, draws), {a, b, c}, draws);
}

}  // namespace

std::vector<Sweep<Query>> triangle_sweeps() {
  return {
      {"triangle-edge", "Triangles: distance from an edge", "size / distance from the edge", 3, 105, 3, 1,
       "the edge's determinant cancels to 2^-k of its terms: error of its weight ∝ 2^k", near_edge},
      {"triangle-sliver", "Triangles: aspect of a sliver", "length / height", 0, 46, 2, 1,
       "both determinants cancel to the height: error ∝ length / height", sliver},
      {"triangle-offset", "Triangles: common offset", "offset / size of the scene", 0, 48, 2, 1,
       "where the ray's second point e + d is rounded, as in EPICK: error ∝ |e| / |d|", offset},
      {"triangle-scale", "Triangles: scale of the direction", "factor of d", -1000, 1000, 50, 0, "", scale},
      {"triangle-angle", "Triangles: angle to the plane", "1 / angle", 0, 46, 2, 1,
       "d·n cancels to the angle: error ∝ 1 / angle", angle},
      {"triangle-spread", "Triangles: spread of the exponents", "greatest / least coordinate", 0, 300, 10, 0, "", spread},
  };
}

}  // namespace graze::bench
