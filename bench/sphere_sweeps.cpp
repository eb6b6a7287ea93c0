#include "bench/sphere_sweeps.hpp"

#include <algorithm>

namespace graze::bench {
namespace {

using Query = fuzz::RaySphere<double>;

/// From e through a point inside the sphere.
Query aimed(const Vec3<double>& e, const Sphere<double>& s, Draws& draws) {
  const Vec3<double> target = sum(s.center, scaled(draws.ball_point(), 0.9 * s.radius));
  return {{e, difference(target, e)}, s};
}

Query far(int level, Draws& draws) {
  const double r = 1 + draws.fraction();
  const Vec3<double> e = draws.point();
  return aimed(e, {sum(e, scaled(draws.direction(), std::ldexp(r, level))), r}, draws);
}

/// D / B^2 = 2^-level, exactly known: with the orthogonal columns R1, R2 of a quaternion's matrix, of length N, d = R1,
/// c - e = j R1 + beta R2 and r = beta N (1 + x) it is beta^2 (2 x + x^2) / j^2.
Query near_tangent(int level, Draws& draws) {
  std::int64_t q[4];
  for (std::int64_t& part : q) part = draws.integer(7);
  if (q[0] == 0) q[0] = 1;
  const auto a = static_cast<double>(q[0]), b = static_cast<double>(q[1]), c = static_cast<double>(q[2]),
             d = static_cast<double>(q[3]);
  const double length = a * a + b * b + c * c + d * d;
  const Vec3<double> r1{a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)};
  const Vec3<double> r2{2 * (b * c - a * d), a * a - b * b + c * c - d * d, 2 * (c * d + a * b)};
  const double beta = 1 + static_cast<double>(draws.bits() % 7);
  // j takes up to 39 bits; what is left of the level is x.
  const int shift = std::min(level * 37 / 100, 39);
  const double j = std::floor(std::ldexp(1 + draws.fraction(), shift));
  const double x = std::min(std::ldexp(j / beta * j / beta, -level - 1), 1.0);
  const auto coordinate = [&] { return static_cast<double>(draws.integer(1000)); };
  const Vec3<double> e{coordinate(), coordinate(), coordinate()};
  return {{e, r1}, {combination(e, j, r1, beta, r2), beta * length * (1 + x)}};
}

Query offset(int level, Draws& draws) {
  const Vec3<double> e = draws.point(), c = draws.point(), away = scaled(draws.direction(), std::ldexp(1.0, level));
  Query q = aimed(e, {c, 0.25 + draws.fraction()}, draws);
  q.ray.origin = sum(e, away);
  q.sphere.center = sum(c, away);
  return q;
}

Query scale(int level, Draws& draws) {
  const Vec3<double> e = draws.point(), c = draws.point();
  Query q = aimed(e, {c, 0.25 + draws.fraction()}, draws);
  q.ray.direction = scaled(q.ray.direction, std::ldexp(1.0, level));
  return q;
}

Query spread(int level, Draws& draws) {
  const Vec3<double> e = spread_out(draws.point(), level, draws), c = spread_out(draws.point(), level, draws);
  return aimed(e, {c, std::ldexp(1 + draws.fraction(), -static_cast<int>(draws.fraction() * (level + 1)))}, draws);
}

}  // namespace

std::vector<Sweep<Query>> sphere_sweeps() {
  return {
      {"sphere-distance", "Spheres: distance over radius", "distance / radius", 2, 60, 2, 1,
       "C = L·L − r² loses r² beside L²: error of D ∝ (L/r)², of √D against t ∝ L/r", far},
      {"sphere-discriminant", "Spheres: the discriminant's relative size", "B² / D", 0, 106, 2, 0.5,
       "the error of D is a unit of B²: of √D ∝ B/√D", near_tangent},
      {"sphere-offset", "Spheres: common offset", "offset / size of the scene", 0, 48, 2, 0, "", offset},
      {"sphere-scale", "Spheres: scale of the direction", "factor of d", -1000, 1000, 50, 0, "", scale},
      {"sphere-spread", "Spheres: spread of the exponents", "greatest / least coordinate", 0, 300, 10, 0, "", spread},
  };
}

}  // namespace graze::bench
