// Rays through two lattice points against triangles of lattice points: in space three wide, in planes four and five wide. By
// default in strides that are prime to all radices; everything:
//   bin/test_triangle "[exhaustive]"
#include "tests/support/lattice.hpp"

#include <array>

#include "tests/support/agreement.hpp"

namespace graze::test {
namespace {

template <Real T>
Vec3<T> difference(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

/// How often each kind was met.
using Kinds = std::array<int, 11>;

template <Real T>
void count(Kinds& kinds, const fuzz::Answer<T>& answer) {
  ++kinds[static_cast<std::size_t>(std::get<TriangleHit<T>>(answer).kind)];
}

void check_all_met(const Kinds& kinds, bool in_space) {
  using enum TriangleKind;
  for (const TriangleKind kind : {miss, face, edge_ab, edge_bc, edge_ca, vertex_a, vertex_b, vertex_c, coplanar, degenerate}) {
    CAPTURE(static_cast<int>(kind));
    if (in_space || kind == miss || kind >= coplanar) CHECK(kinds[static_cast<std::size_t>(kind)] > 100);
  }
}

/// Origin, another point of the ray and three corners from {0, 1, 2}^3; one query in `stride`.
template <Real T>
void require_agreement_in_space(std::uint64_t stride) {
  constexpr std::uint64_t points = 27, all = points * points * points * points * points;
  CAPTURE(stride);
  Kinds kinds{};
  for (std::uint64_t index = 0; index < all; index += stride) {
    Digits digits(index);
    fuzz::RayTriangle<T> query;
    query.ray.origin = digits.point<T>(0, 3);
    query.ray.direction = difference(digits.point<T>(0, 3), query.ray.origin);
    for (Vec3<T>* corner : {&query.triangle.a, &query.triangle.b, &query.triangle.c}) *corner = digits.point<T>(0, 3);
    set_range(query.ray, index / stride);
    count(kinds, require_agreement(fuzz::Case<T>(query)));
  }
  check_all_met(kinds, true);
}

/// A plane through lattice points: (i, j) is at i p + j q.
template <Real T>
struct LatticePlane {
  Vec3<T> p, q;
  [[nodiscard]] Vec3<T> at(int i, int j) const {
    return {T(i) * p.x + T(j) * q.x, T(i) * p.y + T(j) * q.y, T(i) * p.z + T(j) * q.z};
  }
};

/// Corners from a square of that side, the ray's points from one that is wider by one all around.
template <Real T>
void require_agreement_in_plane(const LatticePlane<T>& plane, std::uint64_t side, std::uint64_t stride) {
  const std::uint64_t wide = side + 2, all = wide * wide * wide * wide * side * side * side * side * side * side;
  CAPTURE(side, stride);
  Kinds kinds{};
  for (std::uint64_t index = 0; index < all; index += stride) {
    Digits digits(index);
    const auto point = [&](std::uint64_t width, int low) {
      const int i = digits.next(width), j = digits.next(width);
      return plane.at(low + i, low + j);
    };
    fuzz::RayTriangle<T> query;
    query.ray.origin = point(wide, -1);
    query.ray.direction = difference(point(wide, -1), query.ray.origin);
    for (Vec3<T>* corner : {&query.triangle.a, &query.triangle.b, &query.triangle.c}) *corner = point(side, 0);
    set_range(query.ray, index / stride);
    count(kinds, require_agreement(fuzz::Case<T>(query)));
  }
  check_all_met(kinds, false);
}

/// The three axis planes, and a slanting one in which no axis is special.
template <Real T>
void require_agreement_in_planes(std::uint64_t side, std::uint64_t stride) {
  require_agreement_in_plane<T>({{1, 0, 0}, {0, 1, 0}}, side, stride);
  require_agreement_in_plane<T>({{0, 1, 0}, {0, 0, 1}}, side, stride);
  require_agreement_in_plane<T>({{0, 0, 1}, {1, 0, 0}}, side, stride);
  require_agreement_in_plane<T>({{1, 2, -1}, {2, -1, 3}}, side, stride);
}

TEST_CASE("Rays and triangles on {0,1,2}^3, in a stride") {
  require_agreement_in_space<float>(17);
  require_agreement_in_space<double>(11);
}

TEST_CASE("Coplanar rays and triangles on lattices four wide, in a stride") {
  require_agreement_in_planes<float>(4, 41);
  require_agreement_in_planes<double>(4, 23);
}

TEST_CASE("Coplanar rays and triangles on lattices five wide, in a stride") {
  require_agreement_in_planes<double>(5, 1009);
}

TEST_CASE("Every ray and triangle on {0,1,2}^3", "[.exhaustive]") {
  require_agreement_in_space<float>(1);
  require_agreement_in_space<double>(1);
}

TEST_CASE("Every coplanar ray and triangle on lattices four wide", "[.exhaustive]") {
  require_agreement_in_planes<float>(4, 1);
  require_agreement_in_planes<double>(4, 1);
}

}  // namespace
}  // namespace graze::test
