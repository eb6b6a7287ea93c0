// Scenes with spatial splits: the boxes of a triangle's parts cover it, the answers are those without, and less is tested.
#include "scene/splits.hpp"

#include <gmpxx.h>

#include <array>
#include <cmath>

#include "fuzz/random.hpp"
#include "fuzz/scene/truth.hpp"
#include "scene/build.hpp"
#include "tests/catch.hpp"
#include "tests/support/formats.hpp"
#include "tests/support/times_power.hpp"

namespace graze::test {
namespace {

using fuzz::Random;
using scene::Pages, scene::Reference;

using Place3 = std::array<mpq_class, 3>;

/// In box space, exactly.
template <Real T>
Place3 place_of(const scene::Space& space, const Vec3<T>& p) {
  const std::array<T, 3> x{p.x, p.y, p.z};
  Place3 out;
  for (int k = 0; k < 3; ++k) {
    out[k] = times_power(mpq_class(static_cast<double>(x[k])) - 4 * mpq_class(space.quarter_origin[k]), space.exponent);
  }
  return out;
}

bool holds(const Reference& r, const Place3& p) {
  for (int k = 0; k < 3; ++k) {
    if (p[k] < static_cast<double>(r.low[k]) || p[k] > static_cast<double>(r.high[k])) return false;
  }
  return true;
}

/// Long triangles, every which way: with corners at random, on a coarse lattice, where planes go through corners and edges, or
/// an ulp beside those.
template <Real T>
std::vector<Vec3<T>> hairs(Random& random, int triangles) {
  std::vector<Vec3<T>> points;
  const auto kind = random.below(3);
  const auto coordinate = [&] {
    if (kind == 0) return T(random.between(-(1 << 24), 1 << 24)) * T(0x1p-24);
    const T x = std::ldexp(static_cast<T>(static_cast<int>(random.below(33)) - 16), -4);
    return kind == 1 ? x : std::nextafter(x, random.one_in(2) ? T(2) : T(-2));
  };
  for (int i = 0; i < triangles; ++i) {
    const Vec3<T> a{coordinate(), coordinate(), coordinate()}, b{coordinate(), coordinate(), coordinate()};
    const T thickness = std::ldexp(T(1), -static_cast<int>(random.below(24)));
    points.insert(points.end(), {a, b, {b.x + thickness, b.y, b.z - thickness}});
  }
  return points;
}

std::vector<Corners> in_threes(std::size_t points) {
  std::vector<Corners> out;
  for (std::uint32_t i = 0; i + 2 < points; i += 3) out.push_back({i, i + 1, i + 2});
  return out;
}

TEST_CASE("The boxes of a triangle's parts hold every point of it") {
  in_both_formats([]<Real T>() {
    constexpr std::uint64_t seed = 11;
    const Random stream(seed, "split-boxes", sizeof(T));
    std::size_t parted = 0, outside = 0;
    for (std::uint64_t i = 0; i < 60; ++i) {
      Random random = stream.at(i);
      const std::vector<Vec3<T>> points = hairs<T>(random, 20);
      scene::Data<T> data;
      data.parts = {Mesh<T>{points, in_threes(points.size())}};
      REQUIRE(scene::measure(data, Threads::mine).ok());
      Pages<Reference> references = scene::references_of(data, Threads::mine);
      const std::size_t whole = references.size();
      scene::split(data, references);
      CHECK(references.size() <= 2 * whole);
      parted += references.size() - whole;
      for (std::uint32_t t = 0; t < whole; ++t) {
        const Place3 a = place_of(data.space, points[3 * t]), b = place_of(data.space, points[3 * t + 1]),
                     c = place_of(data.space, points[3 * t + 2]);
        for (int sample = 0; sample < 40; ++sample) {
          // Also corners, points of edges, and dyadic shares, which lie on the planes.
          const mpq_class u(static_cast<int>(random.below(17)), 16), rest = 1 - u;
          const mpq_class v = sample % 3 == 0   ? mpq_class(0)
                              : sample % 3 == 1 ? rest
                                                : rest * mpq_class(random.between(0, 255), 256);
          Place3 p;
          for (int k = 0; k < 3; ++k) p[k] = a[k] + u * (b[k] - a[k]) + v * (c[k] - a[k]);
          bool is_held = false;
          for (const Reference& r : references) is_held = is_held || (r.index == t && holds(r, p));
          outside += is_held ? 0 : 1;
        }
      }
    }
    CHECK(outside == 0);
    CHECK(parted > 500);
  });
}

TEST_CASE("A scene with spatial splits answers like one without, refitted too") {
  in_both_formats([]<Real T>() {
    constexpr std::uint64_t seed = 12;
    const Random stream(seed, "split-answers", sizeof(T));
    for (std::uint64_t i = 0; i < 12; ++i) {
      INFO("seed " << seed << ", scene " << i);
      Random random = stream.at(i);
      std::vector<Vec3<T>> points = hairs<T>(random, 400);
      const std::vector<Part<T>> parts{Mesh<T>{points, in_threes(points.size())},
                                       Spheres<T>{std::vector<Sphere<T>>{{{0, 0, 0}, T(0.25)}}}};
      Scene<T> plain, split;
      REQUIRE(plain.build(parts).ok());
      REQUIRE(split.build(parts, {false, Threads::all, true}).ok());
      CHECK(split.memory() > plain.memory());
      for (int pass = 0; pass < 2; ++pass) {
        int different = 0;
        for (int r = 0; r < 200; ++r) {
          Ray<T> ray{points[random.below(points.size())], points[random.below(points.size())]};
          ray.direction = {ray.direction.x - ray.origin.x, ray.direction.y - ray.origin.y, ray.direction.z - ray.origin.z};
          if (random.one_in(3)) ray.origin.x -= T(3);
          if (random.one_in(4)) ray.t_max = T(0.5);
          QueryOptions options;
          options.ignore_coplanar = random.one_in(4);
          options.leave_out = random.one_in(4) ? static_cast<std::uint32_t>(random.below(400)) : no_primitive;
          different +=
              !(plain.closest(ray, options) == split.closest(ray, options)) ||
              plain.any(ray, options) != split.any(ray, options) || plain.count(ray, options) != split.count(ray, options) ||
              plain.all(ray, options) != split.all(ray, options) || plain.ties(ray, options) != split.ties(ray, options);
        }
        CHECK(different == 0);
        for (Vec3<T>& p : points) p = {p.y, p.z, -p.x / 2};
        REQUIRE(plain.refit(0, points).ok());
        REQUIRE(split.refit(0, points).ok());
      }
    }
  });
}

TEST_CASE("A closed scene with spatial splits places points like one without") {
  in_both_formats([]<Real T>() {
    // Tetrahedra like needles along diagonals.
    Random random(13, "split-inside", sizeof(T));
    std::vector<Vec3<T>> points;
    std::vector<Corners> triangles;
    for (std::uint32_t i = 0; i < 60; ++i) {
      const auto eighth = [&] { return static_cast<T>(static_cast<int>(random.below(65)) - 32) / 8; };
      const Vec3<T> a{eighth(), eighth(), eighth()}, far{eighth(), eighth(), eighth()};
      points.insert(points.end(), {a, {a.x + T(0.125), a.y, a.z}, {a.x, a.y + T(0.125), a.z}, far});
      const std::uint32_t f = 4 * i;
      triangles.insert(triangles.end(), {{f, f + 2, f + 1}, {f, f + 1, f + 3}, {f + 1, f + 2, f + 3}, {f, f + 3, f + 2}});
    }
    Scene<T> plain, split;
    REQUIRE(plain.build({Mesh<T>{points, triangles}}, {true, Threads::all}).ok());
    REQUIRE(split.build({Mesh<T>{points, triangles}}, {true, Threads::all, true}).ok());
    std::array<int, 4> places{};
    int different = 0;
    for (int i = 0; i < 4000; ++i) {
      // From a base's corner to any, or from within a base to its tip.
      const std::size_t needle = 4 * random.below(60);
      const bool is_within = random.one_in(2);
      Vec3<T> a = points[needle], b = points[is_within ? needle + 3 : random.below(points.size())];
      if (is_within) a = {a.x + T(0x1p-5), a.y + T(0x1p-5), a.z};
      const T s = static_cast<T>(random.below(9)) / 8;
      const Vec3<T> p{a.x + s * (b.x - a.x), a.y + s * (b.y - a.y), a.z + s * (b.z - a.z)};
      const Place place = plain.inside(p);
      ++places[static_cast<std::size_t>(place)];
      different += place != split.inside(p);
    }
    CHECK(different == 0);
    CHECK(places[static_cast<std::size_t>(Place::inside)] > 20);
    CHECK(places[static_cast<std::size_t>(Place::outside)] > 20);
    CHECK(places[static_cast<std::size_t>(Place::boundary)] > 20);
  });
}

TEST_CASE("Spatial splits leave fewer triangles to test where they are long and thin") {
  in_both_formats([]<Real T>() {
    const auto uniform = [](Random& random) { return T(random.between(-(1 << 24), 1 << 24)) * T(0x1p-24); };
    Random random(14, "split-work", sizeof(T));
    std::vector<Vec3<T>> points;
    for (int i = 0; i < 5000; ++i) {
      const Vec3<T> a{uniform(random), uniform(random), uniform(random)};
      const Vec3<T> b{a.x + T(0.5) * uniform(random), a.y + T(0.5) * uniform(random), a.z + T(0.5) * uniform(random)};
      points.insert(points.end(), {a, b, {b.x + T(0x1p-10), b.y, b.z}});
    }
    const std::vector<Part<T>> parts{Mesh<T>{points, in_threes(points.size())}};
    Scene<T> plain, split;
    REQUIRE(plain.build(parts).ok());
    REQUIRE(split.build(parts, {false, Threads::all, true}).ok());
    Statistics of_plain, of_split;
    for (int r = 0; r < 500; ++r) {
      const Ray<T> ray{{uniform(random), uniform(random), T(-2)}, {uniform(random), uniform(random), T(2)}};
      CHECK(plain.closest(ray, {}, of_plain) == split.closest(ray, {}, of_split));
    }
    CAPTURE(of_plain.triangle_tests, of_split.triangle_tests);
    CHECK(of_split.triangle_tests * 10 < of_plain.triangle_tests * 8);
    CHECK(of_split.leaves < of_plain.leaves);
    CHECK(of_split.roundings == of_plain.roundings);
  });
}

}  // namespace
}  // namespace graze::test
