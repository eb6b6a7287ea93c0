// Oracle against oracle, bit by bit: they share no arithmetic, so what both say is true.
#include <array>
#include <bit>
#include <sstream>

#include "tests/oracle/both_oracles.hpp"
#include "tests/oracle/random_cases.hpp"

namespace graze::oracle {
namespace {

constexpr std::uint64_t kSeed = 20240229;

template <Real T>
[[nodiscard]] bool same_bits(T x, T y) {
  using Bits = std::conditional_t<std::same_as<T, double>, std::uint64_t, std::uint32_t>;
  return std::bit_cast<Bits>(x) == std::bit_cast<Bits>(y);
}

template <Real T>
[[nodiscard]] bool same_bits(const SphereHit<T>& x, const SphereHit<T>& y) {
  return x == y && same_bits(x.t[0], y.t[0]) && same_bits(x.t[1], y.t[1]);
}

template <Real T>
[[nodiscard]] bool same_bits(const TriangleHit<T>& x, const TriangleHit<T>& y) {
  return x == y && same_bits(x.t, y.t) && same_bits(x.t_end, y.t_end) && same_bits(x.u, y.u) && same_bits(x.v, y.v);
}

[[nodiscard]] bool same(const Exact& x, const Exact& y) {
  return x.rational == y.rational && x.radicand == y.radicand && x.root_sign == y.root_sign;
}

template <Real T>
[[nodiscard]] std::array<const Exact*, 2> values(const SphereTruth<T>& truth) {
  return {&truth.t[0], &truth.t[1]};
}

template <Real T>
[[nodiscard]] std::array<const Exact*, 4> values(const TriangleTruth<T>& truth) {
  return {&truth.t, &truth.t_end, &truth.u, &truth.v};
}

template <Real T>
[[nodiscard]] std::array<T, 2> numbers(const SphereHit<T>& hit) {
  return {hit.t[0], hit.t[1]};
}

template <Real T>
[[nodiscard]] std::array<T, 4> numbers(const TriangleHit<T>& hit) {
  return {hit.t, hit.t_end, hit.u, hit.v};
}

template <Real T>
void print(std::ostream& out, const Vec3<T>& v) {
  out << v.x << ' ' << v.y << ' ' << v.z << "  ";
}

template <Real T>
[[nodiscard]] std::string text(const Ray<T>& ray, const Sphere<T>& sphere) {
  std::ostringstream out;
  out << std::hexfloat << "ray_sphere ";
  for (const auto& v : {ray.origin, ray.direction, sphere.center}) print(out, v);
  out << sphere.radius << "  " << ray.t_min << ' ' << ray.t_max;
  return out.str();
}

template <Real T>
[[nodiscard]] std::string text(const Ray<T>& ray, const Triangle<T>& triangle) {
  std::ostringstream out;
  out << std::hexfloat << "ray_triangle ";
  for (const auto& v : {ray.origin, ray.direction, triangle.a, triangle.b, triangle.c}) print(out, v);
  out << ray.t_min << ' ' << ray.t_max;
  return out.str();
}

/// Both oracles on one case. Assertions are counted apart from cases, so the cheap test comes first.
template <Real T, class Shape>
auto agreed(const Ray<T>& ray, const Shape& shape, bool with_truth) {
  const auto gmp = gmp_oracle().answer(ray, shape);
  const auto cgal = cgal_oracle().answer(ray, shape);
  if (!same_bits(gmp, cgal)) {
    INFO(text(ray, shape));
    CAPTURE(gmp, cgal);
    REQUIRE(same_bits(gmp, cgal));
  }
  if (with_truth) {
    const auto gmp_truth = gmp_oracle().truth(ray, shape);
    const auto cgal_truth = cgal_oracle().truth(ray, shape);
    bool good = same_bits(gmp_truth.hit, gmp) && same_bits(cgal_truth.hit, gmp);
    for (std::size_t i = 0; i < values(gmp_truth).size(); ++i) {
      const Exact& value = *values(gmp_truth)[i];
      good = good && same(value, *values(cgal_truth)[i]) && error_in_ulps(value, numbers(gmp)[i]) <= 0.5;
    }
    if (!good) {
      INFO(text(ray, shape));
      REQUIRE(good);
    }
  }
  return gmp;
}

/// What a run has met, so that a run of misses doesn't pass for a test.
struct Tally {
  std::array<int, 4> spheres{};
  std::array<int, 11> triangles{};
  template <Real T>
  void count(const SphereHit<T>& hit) {
    ++spheres[static_cast<std::size_t>(hit.kind)];
  }
  template <Real T>
  void count(const TriangleHit<T>& hit) {
    ++triangles[static_cast<std::size_t>(hit.kind)];
  }
};

template <Real T>
Tally run(Sort sort, std::uint64_t seed, int cases) {
  CAPTURE(seed, sizeof(T));
  RandomCases<T> random(sort, seed);
  Tally tally;
  for (int index = 0; index < cases; ++index) {
    const bool with_truth = index % 8 == 0;
    Ray<T> ray = random.ray();
    const Sphere<T> sphere = sort == Sort::contacts ? random.touched_sphere(ray) : random.sphere();
    const SphereHit<T> hit = agreed(ray, sphere, with_truth);
    tally.count(hit);
    random.set_range(ray, hit.t[0], hit.t[1]);
    tally.count(agreed(ray, sphere, with_truth));

    ray = random.ray();
    const Triangle<T> triangle = sort == Sort::contacts ? random.grazed_triangle(ray) : random.triangle();
    const TriangleHit<T> triangle_hit = agreed(ray, triangle, with_truth);
    tally.count(triangle_hit);
    random.set_range(ray, triangle_hit.t, triangle_hit.t_end);
    tally.count(agreed(ray, triangle, with_truth));
  }
  return tally;
}

/// Both formats; each kind must have been met that often.
void run_both(Sort sort, int cases, int least_of_each) {
  for (const Tally& tally : {run<float>(sort, kSeed, cases), run<double>(sort, kSeed + 1, cases)}) {
    for (int count : tally.spheres) CHECK(count >= least_of_each);
    for (int count : tally.triangles) CHECK(count >= least_of_each);
  }
}

TEST_CASE("The oracles agree on small lattices") {
  run_both(Sort::lattice, 25000, 25);
}
TEST_CASE("The oracles agree on scaled lattices") {
  run_both(Sort::scaled_lattice, 12000, 10);
}
TEST_CASE("The oracles agree on tangents, edges and corners") {
  run_both(Sort::contacts, 20000, 2);
}
TEST_CASE("The oracles agree on uniform numbers") {
  run_both(Sort::uniform, 8000, 0);
}
TEST_CASE("The oracles agree on mixed exponents") {
  run_both(Sort::mixed_exponents, 4000, 0);
}
TEST_CASE("The oracles agree on random bit patterns") {
  run_both(Sort::bit_patterns, 1500, 0);
}

template <Real T>
void agree_on_sides(Sort sort, std::uint64_t seed, int cases) {
  CAPTURE(seed, sizeof(T), static_cast<int>(sort));
  RandomCases<T> random(sort, seed);
  const auto agree = [](const auto& point, const auto& surface) {
    const Side gmp = gmp_oracle().side(point, surface);
    const Side cgal = cgal_oracle().side(point, surface);
    if (gmp != cgal) REQUIRE(gmp == cgal);
  };
  for (int index = 0; index < cases; ++index) {
    CAPTURE(index);
    const Vec3<T> p = random.vec3();
    const Vec3<T> n = random.vec3();
    agree(Vec2<T>{p.x, p.y}, Line<T>{n.x, n.y, n.z});
    agree(p, Plane<T>{n.x, n.y, n.z, random.coordinate()});
    agree(p, random.sphere());
  }
}

TEST_CASE("The oracles agree on sides") {
  for (Sort sort : {Sort::lattice, Sort::scaled_lattice, Sort::uniform, Sort::bit_patterns, Sort::mixed_exponents}) {
    agree_on_sides<float>(sort, kSeed, 4000);
    agree_on_sides<double>(sort, kSeed + 1, 4000);
  }
}

}  // namespace
}  // namespace graze::oracle
