// Ray and triangle at both ends of the range of numbers, and at every scale between.
#include <cmath>

#include "fuzz/random.hpp"
#include "tests/support/agreement.hpp"
#include "tests/support/ask.hpp"
#include "tests/support/scaled.hpp"

namespace graze::test {
namespace {

using enum TriangleKind;
using enum Facing;

TEST_CASE("The least numbers make triangles like others") {
  in_both_formats([]<Real T>() {
    const T least = kLeast<T>;
    const Triangle<T> triangle{{0, 0, 0}, {2 * least, 0, 0}, {0, 2 * least, 0}};
    const auto down = [&](T x, T y) { return Ray<T>{{x, y, least}, {0, 0, -least}}; };
    check_answer(down(least, 0), triangle, at_point<T>(edge_ab, front, 1, T(0.5), 0));
    check_answer(down(least, least), triangle, at_point<T>(edge_bc, front, 1, T(0.5), T(0.5)));
    check_answer(down(0, 2 * least), triangle, at_point<T>(vertex_c, front, 1, 0, 1));
    check_answer(down(2 * least, least), triangle, triangle_miss<T>(front));
    check_answer(Ray<T>{{least, least, 1}, {0, 0, -least}}, triangle,
                 at_point<T>(edge_bc, front, kInfinity<T>, T(0.5), T(0.5)));
    check_answer(Ray<T>{{-least, least, 0}, {2 * least, 0, 0}}, triangle, along<T>(coplanar, T(0.5), 1));
  });
}

TEST_CASE("The largest numbers make triangles like others") {
  in_both_formats([]<Real T>() {
    const T big = kGreatest<T>;
    const Triangle<T> triangle{{-big, -big, 0}, {big, -big, 0}, {-big, big, 0}};
    check_answer(Ray<T>{{-big / 2, -big / 2, big}, {0, 0, -big}}, triangle, at_point<T>(face, front, 1, T(0.25), T(0.25)));
    check_answer(Ray<T>{{0, 0, big}, {0, 0, -big}}, triangle, at_point<T>(edge_bc, front, 1, T(0.5), T(0.5)));
    check_answer(Ray<T>{{0, kLeast<T>, big}, {0, 0, -big}}, triangle, triangle_miss<T>(front));
    check_answer(Ray<T>{{0, -kLeast<T>, big}, {0, 0, -big}}, triangle, at_point<T>(face, front, 1, T(0.5), T(0.5)));
    check_answer(Ray<T>{{0, 0, big}, {0, 0, -kLeast<T>}}, triangle, at_point<T>(edge_bc, front, kInfinity<T>, T(0.5), T(0.5)));
    check_answer(Ray<T>{{-big, 0, 0}, {big, 0, 0}}, triangle, along<T>(coplanar, 0, 1));
    // Twice the largest number is no number, but a t.
    const Triangle<T> wall{{big, -1, -1}, {big, 3, -1}, {big, -1, 3}};
    check_answer(Ray<T>{{-big, 0, 0}, {1, 0, 0}}, wall, at_point<T>(face, back, kInfinity<T>, T(0.25), T(0.25)));
    check_answer(Ray<T>{{-big, 0, 0}, {1, 0, 0}, 0, big}, wall, triangle_miss<T>(back));
    check_answer(Ray<T>{{-big, 0, 0}, {2, 0, 0}, 0, big}, wall, at_point<T>(face, back, big, T(0.25), T(0.25)));
  });
}

TEST_CASE("Numbers of every size in one triangle") {
  in_both_formats([]<Real T>() {
    const T big = kGreatest<T>, least = kLeast<T>;
    // As thin as a triangle can be, and a hit beside its long edge by the least number.
    const Triangle<T> thin{{0, 0, 0}, {big, 0, 0}, {0, least, 0}};
    check_answer(Ray<T>{{0, least, 1}, {0, 0, -1}}, thin, at_point<T>(vertex_c, front, 1, 0, 1));
    check_answer(Ray<T>{{1, 0, 1}, {0, 0, -1}}, thin, at_point<T>(edge_ab, front, 1, 1 / big, 0));
    check_answer(Ray<T>{{1, least, 1}, {0, 0, -1}}, thin, triangle_miss<T>(front));
    check_answer(Ray<T>{{least, 0, big}, {0, 0, -1}}, thin, at_point<T>(edge_ab, front, big, 0, 0));
  });
}

template <Real T>
Vec3<T> lattice_point(fuzz::Random& random) {
  const int x = random.between(-3, 3), y = random.between(-3, 3), z = random.between(-3, 3);
  return {T(x), T(y), T(z)};
}

/// Small integers, of which many meet edges and corners, lie in one plane or have no area.
template <Real T>
fuzz::RayTriangle<T> random_lattice_query(fuzz::Random& random) {
  fuzz::RayTriangle<T> query;
  query.ray.origin = lattice_point<T>(random);
  query.ray.direction = lattice_point<T>(random);
  for (Vec3<T>* corner : {&query.triangle.a, &query.triangle.b, &query.triangle.c}) *corner = lattice_point<T>(random);
  if (random.one_in(2)) {
    // Toward a corner, or the middle of an edge.
    const Vec3<T>&a = query.triangle.a, &b = random.one_in(2) ? query.triangle.b : a, &e = query.ray.origin;
    query.ray.direction = {a.x + b.x - 2 * e.x, a.y + b.y - 2 * e.y, a.z + b.z - 2 * e.z};
  }
  if (query.ray.direction == Vec3<T>{}) query.ray.direction.z = 1;
  query.ray.t_min = T(random.between(-3, 1));
  return query;
}

TEST_CASE("A power of two on all lengths changes no bit") {
  in_both_formats([]<Real T>() {
    constexpr std::uint64_t seed = 14;
    CAPTURE(seed);
    fuzz::Random random(seed, "scaled triangles", sizeof(T));
    for (int exponent = lowest_exponent<T>; exponent <= highest_exponent<T>; ++exponent) {
      for (int i = 0; i < 8; ++i) {
        const fuzz::RayTriangle<T> base = random_lattice_query<T>(random), query = scaled(base, exponent, exponent);
        const TriangleHit<T> expected = intersect(base.ray, base.triangle), found = intersect(query.ray, query.triangle);
        if (fuzz::same_bits(found, expected)) continue;
        CAPTURE(exponent, found, expected);
        INFO(fuzz::format_case(fuzz::Case<T>(query)));
        REQUIRE(fuzz::same_bits(found, expected));
      }
    }
  });
}

TEST_CASE("Powers of two on positions and directions apart, against the oracle") {
  in_both_formats([]<Real T>() {
    constexpr std::uint64_t seed = 15;
    CAPTURE(seed);
    fuzz::Random random(seed, "stretched triangles", sizeof(T));
    for (int i = 0; i < 6000; ++i) {
      const int positions = random.between(lowest_exponent<T>, highest_exponent<T>);
      const int directions = random.between(lowest_exponent<T>, highest_exponent<T>);
      require_agreement_in_all_environments(fuzz::Case<T>(scaled(random_lattice_query<T>(random), positions, directions)));
    }
  });
}

}  // namespace
}  // namespace graze::test
