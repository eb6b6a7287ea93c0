// A ray that crosses a triangle's plane, computed by hand.
#include "tests/oracle/both_oracles.hpp"

namespace graze::oracle {
namespace {

using enum TriangleKind;

template <Real T>
const Triangle<T> kRight{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};

TEST_CASE("A point of a triangle is inside, on an edge or on a corner") {
  everywhere([]<Real T>(const Oracle& oracle) {
    const auto down_at = [&](T x, T y) { return oracle.answer(Ray<T>{{x, y, 5}, {0, 0, -1}}, kRight<T>); };
    CHECK(down_at(1, 1) == at_point<T>(face, Facing::front, 5, T(0.25), T(0.25)));
    CHECK(down_at(2, 0) == at_point<T>(edge_ab, Facing::front, 5, T(0.5), 0));
    CHECK(down_at(1, 3) == at_point<T>(edge_bc, Facing::front, 5, T(0.25), T(0.75)));
    CHECK(down_at(0, 2) == at_point<T>(edge_ca, Facing::front, 5, 0, T(0.5)));
    CHECK(down_at(0, 0) == at_point<T>(vertex_a, Facing::front, 5, 0, 0));
    CHECK(down_at(4, 0) == at_point<T>(vertex_b, Facing::front, 5, 1, 0));
    CHECK(down_at(0, 4) == at_point<T>(vertex_c, Facing::front, 5, 0, 1));
    // Beyond each edge; at (3, 3) u and v are at most 1 and their sum is not.
    CHECK(down_at(3, 3) == triangle_miss<T>(Facing::front));
    CHECK(down_at(-1, 1) == triangle_miss<T>(Facing::front));
    CHECK(down_at(1, -1) == triangle_miss<T>(Facing::front));
    // Hair's breadths.
    CHECK(down_at(2, kLeast<T>) == at_point<T>(face, Facing::front, 5, T(0.5), kLeast<T> / 4));
    CHECK(down_at(2, -kLeast<T>) == triangle_miss<T>(Facing::front));
    CHECK(down_at(kLeast<T>, 4) == triangle_miss<T>(Facing::front));
  });
}

TEST_CASE("From behind, the same features and the other facing") {
  everywhere([]<Real T>(const Oracle& oracle) {
    const auto up_at = [&](T x, T y) { return oracle.answer(Ray<T>{{x, y, -1}, {0, 0, 2}}, kRight<T>); };
    CHECK(up_at(1, 1) == at_point<T>(face, Facing::back, T(0.5), T(0.25), T(0.25)));
    CHECK(up_at(2, 0) == at_point<T>(edge_ab, Facing::back, T(0.5), T(0.5), 0));
    CHECK(up_at(4, 0) == at_point<T>(vertex_b, Facing::back, T(0.5), 1, 0));
    CHECK(up_at(3, 3) == triangle_miss<T>(Facing::back));
  });
}

TEST_CASE("t is compared with the range exactly") {
  everywhere([]<Real T>(const Oracle& oracle) {
    const auto within = [&](T t_min, T t_max) {
      return oracle.answer(Ray<T>{{1, 1, -5}, {0, 0, -1}, t_min, t_max}, kRight<T>);
    };
    CHECK(within(0, kInfinity<T>) == triangle_miss<T>(Facing::front));
    CHECK(within(-5, kInfinity<T>) == at_point<T>(face, Facing::front, -5, T(0.25), T(0.25)));
    CHECK(within(-10, -5) == at_point<T>(face, Facing::front, -5, T(0.25), T(0.25)));
    CHECK(within(-5, -5) == at_point<T>(face, Facing::front, -5, T(0.25), T(0.25)));
    CHECK(within(std::nextafter(T(-5), T(0)), 0) == triangle_miss<T>(Facing::front));
    CHECK(within(-10, std::nextafter(T(-5), T(-6))) == triangle_miss<T>(Facing::front));
  });
}

TEST_CASE("An origin in the plane hits at t = 0") {
  everywhere([]<Real T>(const Oracle& oracle) {
    CHECK(oracle.answer(Ray<T>{{1, 1, 0}, {3, -7, -1}}, kRight<T>) == at_point<T>(face, Facing::front, 0, T(0.25), T(0.25)));
    CHECK(oracle.answer(Ray<T>{{4, 0, T(-0.0)}, {3, -7, 1}}, kRight<T>) == at_point<T>(vertex_b, Facing::back, 0, 1, 0));
  });
}

TEST_CASE("Thirds are rounded correctly, and the truth tells them") {
  everywhere([]<Real T>(const Oracle& oracle) {
    const Ray<T> ray{{1, 1, 1}, {0, 0, -3}};
    const Triangle<T> triangle{{0, 0, 0}, {3, 0, 0}, {0, 3, 0}};
    const T third = T(1) / T(3);
    CHECK(oracle.answer(ray, triangle) == at_point<T>(face, Facing::front, third, third, third));
    const TriangleTruth<T> truth = oracle.truth(ray, triangle);
    CHECK(truth.hit == oracle.answer(ray, triangle));
    for (const Exact* value : {&truth.t, &truth.t_end, &truth.u, &truth.v}) CHECK(value->rational == mpq_class(1, 3));
    // The nearest double to 1/3 lies below it, the nearest float above.
    const Ray<T> up_to_third{{1, 1, 1}, {0, 0, -3}, 0, third};
    const bool below = std::same_as<T, double>;
    CHECK(oracle.answer(up_to_third, triangle).kind == (below ? miss : face));
    const Ray<T> from_third{{1, 1, 1}, {0, 0, -3}, third};
    CHECK(oracle.answer(from_third, triangle).kind == (below ? face : miss));
  });
}

TEST_CASE("Numbers of all sizes in one triangle") {
  everywhere([]<Real T>(const Oracle& oracle) {
    const T big = kGreatest<T>;
    const T least = kLeast<T>;
    // As wide as numbers go, and as thin: the corner b is seen past the edge by the least of all distances.
    const Triangle<T> sliver{{-big, -least, 0}, {big, 0, 0}, {-big, least, 0}};
    const auto down_at = [&](T x, T y) { return oracle.answer(Ray<T>{{x, y, big}, {0, 0, -big}}, sliver); };
    CHECK(down_at(0, 0) == at_point<T>(face, Facing::front, 1, T(0.5), T(0.25)));
    CHECK(down_at(big, 0) == at_point<T>(vertex_b, Facing::front, 1, 1, 0));
    CHECK(down_at(big, least) == triangle_miss<T>(Facing::front));
    CHECK(down_at(-big, 0) == at_point<T>(edge_ca, Facing::front, 1, 0, T(0.5)));
  });
}

}  // namespace
}  // namespace graze::oracle
