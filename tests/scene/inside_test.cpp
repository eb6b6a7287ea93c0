// Inside, outside, on: closed surfaces whose every edge and corner lies on the ways out.
#include <gmpxx.h>

#include <array>
#include <cmath>
#include <set>

#include "fuzz/mesh/mesh.hpp"
#include "fuzz/random.hpp"
#include "graze/scene.hpp"
#include "tests/catch.hpp"
#include "tests/support/formats.hpp"
#include "tests/support/in_mode.hpp"

namespace graze::test {
namespace {

using fuzz::Random;

constexpr int side = 4;

/// Which unit cubes of a block are filled.
class Cubes {
 public:
  explicit Cubes(Random& random) {
    for (bool& b : filled_) b = random.one_in(2);
  }
  [[nodiscard]] bool at(int x, int y, int z) const {
    const bool is_within = x >= 0 && y >= 0 && z >= 0 && x < side && y < side && z < side;
    return is_within && filled_[(x * side + y) * side + z];
  }

  /// The faces between filled and empty cubes, seen from the empty side counterclockwise, each two triangles.
  template <Real T>
  [[nodiscard]] Mesh<T> surface(const Vec3<T>& shift, T unit) const {
    std::vector<Vec3<T>> points;
    std::vector<Corners> triangles;
    for (int x = -1; x < side; ++x) {
      for (int y = -1; y < side; ++y) {
        for (int z = -1; z < side; ++z) {
          for (int axis = 0; axis < 3; ++axis) {
            const bool here = at(x, y, z), next = at(x + (axis == 0), y + (axis == 1), z + (axis == 2));
            if (here == next) continue;
            const auto corner = [&](int u, int v) {
              std::array<int, 3> p{x, y, z};
              p[axis] += 1;
              p[(axis + 1) % 3] += u;
              p[(axis + 2) % 3] += v;
              points.push_back({shift.x + unit * T(p[0]), shift.y + unit * T(p[1]), shift.z + unit * T(p[2])});
            };
            const auto first = static_cast<std::uint32_t>(points.size());
            corner(0, 0);
            corner(1, 0);
            corner(1, 1);
            corner(0, 1);
            if (here) {
              triangles.insert(triangles.end(), {{first, first + 1, first + 2}, {first, first + 2, first + 3}});
            } else {
              triangles.insert(triangles.end(), {{first, first + 2, first + 1}, {first, first + 3, first + 2}});
            }
          }
        }
      }
    }
    return {std::move(points), std::move(triangles)};
  }

  /// Of the point (x, y, z) / 2. The cubes about a point are joined by faces through it: where they differ it is on one.
  [[nodiscard]] Place place(int x, int y, int z) const {
    int filled = 0, all = 0;
    const auto low = [](int i) { return (i & 1) != 0 ? (i - 1) / 2 : i / 2 - 1; };
    for (int i = low(x); i <= x / 2 - (x < 0 && (x & 1) != 0); ++i) {
      for (int j = low(y); j <= y / 2 - (y < 0 && (y & 1) != 0); ++j) {
        for (int k = low(z); k <= z / 2 - (z < 0 && (z & 1) != 0); ++k) {
          ++all;
          filled += at(i, j, k);
        }
      }
    }
    return filled == 0 ? Place::outside : filled == all ? Place::inside : Place::boundary;
  }

 private:
  std::array<bool, side * side * side> filled_{};
};

template <Real T>
Place place_in(const Scene<T>& scene, const Vec3<T>& point) {
  return scene.inside(point);
}

TEST_CASE("Every half-lattice point of blocks of cubes is placed rightly, wherever they lie and however large they are") {
  in_both_formats([]<Real T>() {
    constexpr std::uint64_t seed = 1;
    const Random stream(seed, "cubes", sizeof(T));
    std::array<int, 4> met{};
    for (std::uint64_t i = 0; i < 12; ++i) {
      INFO("seed " << seed << ", block " << i);
      Random random = stream.at(i);
      const Cubes cubes(random);
      const T unit = i < 4 ? T(1)
                           : static_cast<T>(std::ldexp(1.0, random.between(std::numeric_limits<T>::min_exponent - 10,
                                                                           std::numeric_limits<T>::max_exponent - 12)));
      const int reach = i % 2 == 0 ? 0 : 1000;
      const Vec3<T> shift{unit * T(random.between(-reach, reach)), unit * T(random.between(-reach, reach)), unit * T(reach)};
      Scene<T> scene;
      const BuildStatus status = scene.build({cubes.surface<T>(shift, unit)}, {true, Threads::all});
      REQUIRE(status == BuildStatus{});
      for (int x = -1; x <= 2 * side + 1; ++x) {
        for (int y = -1; y <= 2 * side + 1; ++y) {
          for (int z = -1; z <= 2 * side + 1; ++z) {
            const Vec3<T> point{shift.x + unit * T(x) / 2, shift.y + unit * T(y) / 2, shift.z + unit * T(z) / 2};
            const Place truth = cubes.place(x, y, z);
            ++met[static_cast<std::size_t>(truth)];
            const Environment environment = environments[static_cast<std::size_t>(x + y + z + 3) % environments.size()];
            const bool is_right = scene.inside(point) == truth && in_mode(environment, place_in<T>, scene, point) == truth;
            if (is_right) continue;
            CAPTURE(x, y, z, unit, environment, static_cast<int>(truth), static_cast<int>(scene.inside(point)));
            REQUIRE(is_right);
          }
        }
      }
    }
    for (const Place place : {Place::inside, Place::outside, Place::boundary})
      CHECK(met[static_cast<std::size_t>(place)] > 500);
    CHECK(met[0] == 0);
  });
}

TEST_CASE("An ulp off the surface is off it") {
  in_both_formats([]<Real T>() {
    // The octahedron |x| + |y| + |z| = 1.
    const std::vector<Vec3<T>> points{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    const std::vector<Corners> triangles{{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                         {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    Scene<T> scene;
    REQUIRE(scene.build({Mesh<T>{points, triangles}}, {true, Threads::all}).ok());
    const Random stream(3, "octahedron", sizeof(T));
    std::array<int, 4> met{};
    for (std::uint64_t i = 0; i < 5000; ++i) {
      Random random = stream.at(i);
      const int bits = random.between(1, sizeof(T) == 4 ? 20 : 48);
      const auto whole = std::uint64_t(1) << bits;
      const std::uint64_t x = random.below(whole + 1), y = random.below(whole + 1 - x);
      const auto scaled = [&](std::uint64_t n) {
        return static_cast<T>(std::ldexp(static_cast<double>(n), -bits)) * T(random.sign());
      };
      Vec3<T> p;
      p.x = scaled(x);
      p.y = scaled(y);
      p.z = scaled(whole - x - y);
      T* const moved[] = {&p.x, &p.y, &p.z};
      if (random.one_in(2)) {
        T& c = *moved[random.below(3)];
        c = std::nextafter(c, random.one_in(2) ? T(2) : T(-2));
      }
      const mpq_class sum = abs(mpq_class(static_cast<double>(p.x))) + abs(mpq_class(static_cast<double>(p.y))) +
                            abs(mpq_class(static_cast<double>(p.z)));
      const Place truth = sum == 1 ? Place::boundary : sum < 1 ? Place::inside : Place::outside;
      ++met[static_cast<std::size_t>(truth)];
      if (scene.inside(p) == truth) continue;
      CAPTURE(i, p.x, p.y, p.z, static_cast<int>(truth));
      REQUIRE(scene.inside(p) == truth);
    }
    for (const Place place : {Place::inside, Place::outside, Place::boundary})
      CHECK(met[static_cast<std::size_t>(place)] > 500);
  });
}

TEST_CASE("A mesh's corners are on it, its center inside, and where two shells overlap even-odd says outside") {
  const fuzz::Mesh sphere = fuzz::icosphere(3);
  std::vector<Vec3<double>> moved = sphere.points;
  for (Vec3<double>& p : moved) p.x += 0.5;
  Scene<double> one, two;
  REQUIRE(one.build({Mesh<double>{sphere.points, sphere.triangles}}, {true, Threads::all}).ok());
  REQUIRE(
      two.build({Mesh<double>{sphere.points, sphere.triangles}, Mesh<double>{moved, sphere.triangles}}, {true, Threads::all})
          .ok());
  for (const Vec3<double>& p : sphere.points) {
    CHECK(one.inside(p) == Place::boundary);
    CHECK(one.inside({0.98 * p.x, 0.98 * p.y, 0.98 * p.z}) == Place::inside);
    CHECK(one.inside({1.02 * p.x, 1.02 * p.y, 1.02 * p.z}) == Place::outside);
  }
  CHECK(two.inside({0.25, 0, 0}) == Place::outside);
  CHECK(two.inside({-0.6, 0, 0}) == Place::inside);
  CHECK(two.inside({1.3, 0.1, 0}) == Place::inside);
  CHECK(two.inside({3, 0, 0}) == Place::outside);
}

TEST_CASE("Spheres are surfaces too, and points that are not finite are nowhere") {
  Scene<float> scene;
  REQUIRE(scene
              .build({Spheres<float>{std::vector<Sphere<float>>{{{0, 0, 0}, 5}, {{1, 0, 0}, 1}, {{0, 3, 0}, 0}}}},
                     {true, Threads::all})
              .ok());
  CHECK(scene.inside({3, 4, 0}) == Place::boundary);
  CHECK(scene.inside({0, 0, 0}) == Place::boundary);
  CHECK(scene.inside({1, 0, 0}) == Place::outside);
  CHECK(scene.inside({-1, 0, 0}) == Place::inside);
  CHECK(scene.inside({0, 3, 0}) == Place::boundary);
  CHECK(scene.inside({0, 6, 0}) == Place::outside);
  CHECK(scene.inside({0, INFINITY, 0}) == Place::unknown);
  Scene<float> open;
  REQUIRE(open.build({Spheres<float>{std::vector<Sphere<float>>{{{0, 0, 0}, 5}}}}).ok());
  CHECK(open.inside({0, 0, 0}) == Place::unknown);
}

}  // namespace
}  // namespace graze::test
