// Decisions of the stage behind the filters are the truth, for any input, in every environment of floating point: on all
// families, and where inputs lie on lattices about as fine as its words can hold.
#include <vector>

#include "fuzz/case_numbers.hpp"
#include "fuzz/case_text.hpp"
#include "graze/sphere.hpp"
#include "graze/triangle.hpp"
#include "oracle/oracle.hpp"
#include "tests/support/bit_patterns.hpp"
#include "tests/support/family_cases.hpp"
#include "tests/support/formats.hpp"
#include "tests/support/in_mode.hpp"

namespace graze::test {
namespace {

using fuzz::RaySphere;
using fuzz::RayTriangle;

template <Real T>
bool decide(const RayTriangle<T>& query) {
  return predicates::hits_in_doubt(query.ray, query.triangle);
}
template <Real T>
bool decide(const RaySphere<T>& query) {
  return predicates::hits_in_doubt(query.ray, query.sphere);
}

template <Real T>
bool is_hit(const RayTriangle<T>& query) {
  const TriangleKind kind = oracle::gmp_oracle().answer(query.ray, query.triangle).kind;
  return kind != TriangleKind::miss && kind != TriangleKind::invalid;
}
template <Real T>
bool is_hit(const RaySphere<T>& query) {
  const SphereKind kind = oracle::gmp_oracle().answer(query.ray, query.sphere).kind;
  return kind != SphereKind::miss && kind != SphereKind::invalid;
}

template <Real T, template <class> class Query>
void require_truth(const Query<T>& query, int& hits, int& misses) {
  const bool truth = is_hit(query);
  ++(truth ? hits : misses);
  for (const Environment& environment : environments) {
    const bool answer = in_mode(environment, static_cast<bool (*)(const Query<T>&)>(decide<T>), query);
    if (answer == truth) continue;
    INFO(environment << ": " << fuzz::format_case(fuzz::Case<T>(query)));
    REQUIRE(answer == truth);
  }
}

/// An integer of at most `bits` bits.
template <Real T>
T integer(fuzz::Random& random, int bits) {
  const auto n = static_cast<T>(random.bits() >> (64 - bits));
  return random.one_in(2) ? n : -n;
}
template <Real T>
Vec3<T> integers(fuzz::Random& random, int bits) {
  const T x = integer<T>(random, bits), y = integer<T>(random, bits), z = integer<T>(random, bits);
  return {x, y, z};
}
template <Real T>
Vec3<T> sum(const Vec3<T>& p, T s, const Vec3<T>& v) {
  return {p.x + s * v.x, p.y + s * v.y, p.z + s * v.z};
}

/// One number moved by an ulp, by a unit, or to a subnormal number.
template <Real T, template <class> class Query>
void disturb(Query<T>& query, fuzz::Random& random) {
  std::vector<T*> numbers;
  fuzz::for_each_number(query, [&](T& x) { numbers.push_back(&x); });
  T& x = *numbers[random.below(numbers.size())];
  switch (random.below(4)) {
    case 0:
      x += T(random.sign());
      break;
    case 1:
      x = std::numeric_limits<T>::denorm_min();
      break;
    default:
      x = std::nextafter(x, random.one_in(2) ? T(-1e30) : T(1e30));
      break;
  }
}

/// Powers of two for positions, directions and their quotient, the range.
template <Real T, class Shape>
void scale(Ray<T>& ray, Shape scale_shape, fuzz::Random& random) {
  const int positions = random.between(-30, 30), directions = random.between(-30, 30);
  const auto by = [](Vec3<T>& v, int exponent) {
    for (T* x : {&v.x, &v.y, &v.z}) *x = std::ldexp(*x, exponent);
  };
  by(ray.origin, positions);
  by(ray.direction, directions);
  scale_shape(by, positions);
  ray.t_min = std::ldexp(ray.t_min, positions - directions);
  ray.t_max = std::ldexp(ray.t_max, positions - directions);
}

/// A range that begins or ends at t, or is the default.
template <Real T>
void set_range(Ray<T>& ray, T t, fuzz::Random& random) {
  if (random.one_in(2)) return;
  ray.t_min = random.one_in(2) ? t : t - 1;
  if (random.one_in(2)) ray.t_max = random.one_in(2) ? t : t + 1;
  if (ray.t_min > ray.t_max) ray.t_min = ray.t_max;
}

TEST_CASE("Decisions in doubt are the truth on all families") {
  in_both_formats([]<class T>() {
    int hits = 0, misses = 0;
    each_family_query<RayTriangle, T>(2000, [&](const RayTriangle<T>& query) { require_truth(query, hits, misses); });
    each_family_query<RaySphere, T>(2000, [&](const RaySphere<T>& query) { require_truth(query, hits, misses); });
    CHECK(hits > 10000);
    CHECK(misses > 10000);
  });
}

TEST_CASE("Decisions in doubt are the truth where rays meet edges and corners of lattices") {
  in_both_formats([]<class T>() {
    constexpr std::uint64_t seed = 34;
    CAPTURE(seed);
    fuzz::Random random(seed, "edges of lattices", sizeof(T));
    const int most_bits = std::same_as<T, float> ? 17 : 42;
    int hits = 0, misses = 0;
    for (int round = 0; round < 40000; ++round) {
      RayTriangle<T> query{};
      auto& [a, b, c] = query.triangle;
      const Vec3<T> f = integers<T>(random, random.between(2, most_bits)),
                    g = integers<T>(random, random.between(2, most_bits));
      a = integers<T>(random, random.between(2, most_bits + 4));
      b = sum(a, T(16), f);
      c = sum(a, T(16), g);
      const T i = T(random.below(17));
      const T shares[4][2] = {{i, 0}, {0, i}, {16 - i, i}, {i, random.one_in(2) ? T(-1) : T(1)}};
      const T* share = shares[random.below(4)];
      Vec3<T>& d = query.ray.direction;
      d = integers<T>(random, random.between(2, most_bits + 3));
      const T t = T(random.between(-1, 4));
      query.ray.origin = sum(sum(sum(a, share[0], f), share[1], g), -t, d);
      set_range(query.ray, t, random);
      if (random.one_in(2)) disturb(query, random);
      scale(
          query.ray, [&](auto by, int exponent) { by(a, exponent), by(b, exponent), by(c, exponent); }, random);
      require_truth(query, hits, misses);
    }
    CHECK(hits > 5000);
    CHECK(misses > 5000);
  });
}

TEST_CASE("Decisions in doubt are the truth where rays touch spheres of lattices") {
  in_both_formats([]<class T>() {
    constexpr std::uint64_t seed = 35;
    CAPTURE(seed);
    fuzz::Random random(seed, "tangents of lattices", sizeof(T));
    const int most_bits = std::same_as<T, float> ? 8 : 20;
    int hits = 0, misses = 0;
    for (int round = 0; round < 40000; ++round) {
      // The columns of |q|^2 times a rotation are orthogonal and of length |q|^2.
      const int bits = random.between(1, most_bits);
      const T p = integer<T>(random, bits), q = integer<T>(random, bits), r = integer<T>(random, bits),
              s = integer<T>(random, bits);
      const T length = p * p + q * q + r * r + s * s;
      const Vec3<T> first{p * p + q * q - r * r - s * s, 2 * (q * r + p * s), 2 * (q * s - p * r)};
      const Vec3<T> second{2 * (q * r - p * s), p * p - q * q + r * r - s * s, 2 * (r * s + p * q)};
      RaySphere<T> query{};
      auto& [center, radius] = query.sphere;
      query.ray.origin = integers<T>(random, random.between(2, 2 * most_bits + 3));
      query.ray.direction = first;
      const T t = T(random.between(-1, 6)), distance = T(random.between(-2, 2));
      center = sum(sum(query.ray.origin, t, first), distance, second);
      radius = std::fabs(distance) * length;
      set_range(query.ray, t, random);
      if (random.one_in(2)) disturb(query, random);
      scale(
          query.ray, [&](auto by, int exponent) { by(center, exponent), radius = std::ldexp(radius, exponent); }, random);
      require_truth(query, hits, misses);
    }
    CHECK(hits > 5000);
    CHECK(misses > 5000);
  });
}

}  // namespace
}  // namespace graze::test
