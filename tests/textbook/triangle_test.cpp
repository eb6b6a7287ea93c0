// Cramer's rule, the right barycentric tests, and the slips that are met in their place.
#include "graze/textbook/triangle.hpp"

#include <limits>

#include "fuzz/subjects/moller_trumbore.hpp"
#include "tests/catch.hpp"

using graze::Facing;
using graze::Ray;
using graze::Triangle;
using graze::TriangleHit;
using graze::TriangleKind;
namespace cramer = graze::textbook::cramer;
namespace moller_trumbore = graze::fuzz::moller_trumbore;

namespace {

const Triangle<double> unit{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

// Straight down on the unit triangle, where u = x and v = y.
Ray<double> down(double x, double y) {
  return {{x, y, 1}, {0, 0, -1}};
}

// Deliberately wrong twins of the last barycentric test.
bool hits_with_1_minus_u_less_u(const Ray<double>& ray, const Triangle<double>& triangle) {
  const auto s = cramer::solve(ray, triangle);
  if (s.u < 0 || s.v < 0 || 1 - s.u < s.u) return false;
  return ray.t_min <= s.t && s.t <= ray.t_max;
}
bool hits_with_v_against_1(const Ray<double>& ray, const Triangle<double>& triangle) {
  const auto s = cramer::solve(ray, triangle);
  if (s.u < 0 || s.u > 1 || s.v < 0 || s.v > 1) return false;
  return ray.t_min <= s.t && s.t <= ray.t_max;
}

template <class Check>
void for_each_form(const Ray<double>& ray, const Triangle<double>& triangle, Check check) {
  {
    INFO("cramer");
    check(cramer::intersect(ray, triangle), cramer::hits(ray, triangle));
  }
  {
    INFO("moller-trumbore");
    check(moller_trumbore::intersect(ray, triangle), moller_trumbore::hits(ray, triangle));
  }
}

}  // namespace

TEST_CASE("the system is solved for u, v and t") {
  const Triangle<double> triangle{{1, 1, 4}, {5, 1, 4}, {1, 9, 4}};
  const auto s = cramer::solve(Ray<double>{{2, 5, 0}, {0, 0, 2}}, triangle);
  CHECK(s.u == 0.25);
  CHECK(s.v == 0.5);
  CHECK(s.t == 2);
  CHECK(s.determinant == 64);  // d . n, with n = (0, 0, 32)
}

TEST_CASE("the kind is the part of the triangle that is hit") {
  const auto kind = [](double u, double v, TriangleKind wanted) {
    for_each_form(down(u, v), unit, [&](const TriangleHit<double>& hit, bool hits) {
      CAPTURE(u, v);
      CHECK(hit.kind == wanted);
      CHECK(hits == (wanted != TriangleKind::miss));
      CHECK(hit.facing == Facing::front);
      if (hits) {
        CHECK(hit.t == 1);
        CHECK(hit.t_end == 1);
        CHECK(hit.u == u);
        CHECK(hit.v == v);
      } else {
        CHECK(hit == TriangleHit<double>{.facing = Facing::front});
      }
    });
  };
  kind(0.25, 0.5, TriangleKind::face);
  kind(0.25, 0, TriangleKind::edge_ab);
  kind(0.25, 0.75, TriangleKind::edge_bc);
  kind(0, 0.75, TriangleKind::edge_ca);
  kind(0, 0, TriangleKind::vertex_a);
  kind(1, 0, TriangleKind::vertex_b);
  kind(0, 1, TriangleKind::vertex_c);
  kind(-0.25, 0.5, TriangleKind::miss);
  kind(0.25, -0.5, TriangleKind::miss);
  kind(0.75, 0.5, TriangleKind::miss);
}

TEST_CASE("the range ends at both its ends, and the back is told from the front") {
  const auto kind = [](double t_min, double t_max, TriangleKind wanted) {
    for_each_form(Ray<double>{{0.25, 0.5, -3}, {0, 0, 1}, t_min, t_max}, unit, [&](const TriangleHit<double>& hit, bool hits) {
      CAPTURE(t_min, t_max);
      CHECK(hit.kind == wanted);
      CHECK(hits == (wanted != TriangleKind::miss));
      CHECK(hit.facing == Facing::back);
    });
  };
  kind(0, 3, TriangleKind::face);
  kind(3, 4, TriangleKind::face);
  kind(0, 2.5, TriangleKind::miss);
  kind(3.5, 9, TriangleKind::miss);
}

TEST_CASE("a determinant of 0 is a miss: coplanar rays and degenerate triangles are never hit") {
  const auto misses = [](const TriangleHit<double>& hit, bool hits) {
    CHECK(hit == TriangleHit<double>{});
    CHECK(!hits);
  };
  for_each_form(Ray<double>{{-1, 0.25, 0}, {1, 0, 0}}, unit, misses);
  for_each_form(down(1, 0), Triangle<double>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, misses);
  for_each_form(down(0, 0), Triangle<double>{}, misses);
  // A triangle with area whose determinant underflows.
  const double tiny = 1e-170;
  for_each_form(Ray<double>{{0, 0, 1}, {0, 0, -1}}, Triangle<double>{{0, 0, 0}, {tiny, 0, 0}, {0, tiny, 0}}, misses);
}

TEST_CASE("the slip 1 - u < u rejects points inside and accepts points outside") {
  const Ray<double> inside = down(0.75, 0.125);
  const Ray<double> outside = down(0.25, 0.875);
  for_each_form(inside, unit, [](const TriangleHit<double>&, bool hits) { CHECK(hits); });
  for_each_form(outside, unit, [](const TriangleHit<double>&, bool hits) { CHECK(!hits); });
  CHECK(!hits_with_1_minus_u_less_u(inside, unit));
  CHECK(hits_with_1_minus_u_less_u(outside, unit));
}

TEST_CASE("testing v alone against 1 accepts the other half of the parallelogram") {
  const Ray<double> outside = down(0.75, 0.75);
  for_each_form(outside, unit, [](const TriangleHit<double>&, bool hits) { CHECK(!hits); });
  CHECK(hits_with_v_against_1(outside, unit));
  CHECK(hits_with_v_against_1(down(0.75, 0.125), unit));
}

TEST_CASE("the rounded sum u + v lets a hair of the outside in") {
  // u + v = 1 + 2^-60, which rounds to 1.
  const double hair = 0x1p-60;
  for_each_form(down(1, hair), unit, [](const TriangleHit<double>& hit, bool hits) {
    CHECK(hits);
    CHECK(hit.kind == TriangleKind::edge_bc);
  });
}

TEST_CASE("triangle: hits says what intersect says, whatever the numbers are") {
  const double numbers[] = {
      0, -0.0, 0.5, -2, 1e-200, 1e200, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()};
  for (const double x : numbers) {
    for (const double d : numbers) {
      for (const double b : numbers) {
        for (const double c : numbers) {
          CAPTURE(x, d, b, c);
          for_each_form(Ray<double>{{x, 0.25, 1}, {0, d, -1}}, Triangle<double>{{0, 0, 0}, {b, 0, 0.5}, {0, c, 0}},
                        [](const TriangleHit<double>& hit, bool hits) { CHECK(hits == (hit.kind != TriangleKind::miss)); });
        }
      }
    }
  }
}
