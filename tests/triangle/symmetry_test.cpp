// Ray and triangle: permuted corners, permuted and reflected axes, a ray turned around; features and numbers move with them.
#include "fuzz/case_text.hpp"
#include "fuzz/same_bits.hpp"
#include "graze/triangle.hpp"
#include "tests/support/answers.hpp"
#include "tests/support/family_cases.hpp"
#include "tests/support/formats.hpp"
#include "tests/support/isometry.hpp"

namespace graze::test {
namespace {

using fuzz::RayTriangle;
using enum TriangleKind;

Facing flipped(Facing facing) {
  return facing == Facing::front ? Facing::back : facing == Facing::back ? Facing::front : Facing::none;
}

template <Real T>
TriangleHit<T> answer(const RayTriangle<T>& query) {
  return intersect(query.ray, query.triangle);
}

template <Real T>
void require_same(const RayTriangle<T>& query, const TriangleHit<T>& found, const TriangleHit<T>& expected) {
  if (fuzz::same_bits(found, expected)) return;
  CAPTURE(found, expected);
  INFO(fuzz::format_case(fuzz::Case<T>(query)));
  REQUIRE(fuzz::same_bits(found, expected));
}

TEST_CASE("Ray and triangle: permutations and reflections of axes change the facing alone") {
  in_both_formats([]<Real T>() {
    each_family_query<RayTriangle, T>(150, [](const RayTriangle<T>& query) {
      const TriangleHit<T> base = answer(query);
      each_isometry([&](const Isometry& isometry) {
        TriangleHit<T> expected = base;
        if (isometry.flips()) expected.facing = flipped(base.facing);
        require_same(query, answer(isometry(query)), expected);
      });
    });
  });
}

/// The kind after b and c have changed places.
TriangleKind exchanged(TriangleKind kind) {
  switch (kind) {
    case edge_ab:
      return edge_ca;
    case edge_ca:
      return edge_ab;
    case vertex_b:
      return vertex_c;
    case vertex_c:
      return vertex_b;
    default:
      return kind;
  }
}

/// The kind of a, b, c where (b, c, a) has been asked about.
TriangleKind turned_back(TriangleKind kind) {
  switch (kind) {
    case edge_ab:
      return edge_bc;
    case edge_bc:
      return edge_ca;
    case edge_ca:
      return edge_ab;
    case vertex_a:
      return vertex_b;
    case vertex_b:
      return vertex_c;
    case vertex_c:
      return vertex_a;
    default:
      return kind;
  }
}

TEST_CASE("Ray and triangle: b and c exchanged exchange u and v") {
  in_both_formats([]<Real T>() {
    each_family_query<RayTriangle, T>(1500, [](const RayTriangle<T>& query) {
      const auto& [a, b, c] = query.triangle;
      TriangleHit<T> expected = answer(query);
      std::swap(expected.u, expected.v);
      expected.kind = exchanged(expected.kind);
      expected.facing = flipped(expected.facing);
      require_same(query, answer(RayTriangle<T>{query.ray, {a, c, b}}), expected);
    });
  });
}

TEST_CASE("Ray and triangle: turned corners turn the features and the weights") {
  in_both_formats([]<Real T>() {
    each_family_query<RayTriangle, T>(1500, [](const RayTriangle<T>& query) {
      const auto& [a, b, c] = query.triangle;
      // The weights of b and c are u and v; after one turn those of c and a, after two those of a and b.
      const TriangleHit<T> base = answer(query);
      const TriangleHit<T> once = answer(RayTriangle<T>{query.ray, {b, c, a}});
      const TriangleHit<T> twice = answer(RayTriangle<T>{query.ray, {c, a, b}});
      TriangleHit<T> expected = base;
      expected.u = twice.v;
      expected.v = once.u;
      require_same(query, base, expected);
      expected = once;
      expected.kind = turned_back(once.kind);
      expected.u = base.u;
      expected.v = base.v;
      require_same(query, base, expected);
      expected.kind = turned_back(turned_back(twice.kind));
      require_same(query, base, expected);
      const bool same_weight_of_a = fuzz::same_bits(once.v, twice.u);
      if (!same_weight_of_a) REQUIRE(same_weight_of_a);
    });
  });
}

TEST_CASE("Ray and triangle: a ray turned around has t of other sign, and comes from the other side") {
  in_both_formats([]<Real T>() {
    each_family_query<RayTriangle, T>(1500, [](const RayTriangle<T>& query) {
      constexpr T greatest = std::numeric_limits<T>::max();
      const auto& [e, d, t_min, t_max] = query.ray;
      const TriangleHit<T> hit = intersect(Ray<T>{e, d, -greatest, greatest}, query.triangle);
      const TriangleHit<T> turned = intersect(Ray<T>{e, {-d.x, -d.y, -d.z}, -greatest, greatest}, query.triangle);
      const auto negative = [](T t) { return t == T(0) ? T(0) : -t; };
      TriangleHit<T> expected = hit;
      expected.facing = flipped(hit.facing);
      expected.t = negative(hit.t_end);
      expected.t_end = negative(hit.t);
      require_same(query, turned, expected);
    });
  });
}

}  // namespace
}  // namespace graze::test
