// The exact order of hits by their first values, held against the oracle's.
#include "exact/order.hpp"

#include "fuzz/scene/truth.hpp"
#include "tests/catch.hpp"
#include "tests/support/formats.hpp"
#include "tests/support/in_mode.hpp"

namespace graze::test {
namespace {

using fuzz::Random;

/// -1, 0, 1 by the oracle, or nothing where one of them is missed; and by the kernel.
template <Real T, template <class> class One, template <class> class Other>
void require_order(const Ray<T>& ray, const One<T>& one, const Other<T>& other, std::array<int, 3>& met) {
  const auto first_of = [&](const auto& shape, oracle::Exact& t) {
    const auto truth = oracle::gmp_oracle().truth(ray, shape);
    if constexpr (requires { truth.t[0]; }) {
      t = truth.t[0];
      return truth.hit.count() > 0;
    } else {
      t = truth.t;
      return truth.hit.kind != TriangleKind::miss;
    }
  };
  oracle::Exact a, b;
  if (!first_of(one, a) || !first_of(other, b)) return;
  const int truth = fuzz::compare(a, b);
  ++met[truth + 1];
  REQUIRE((exact::compare_first(ray, one, other) > 0) - (exact::compare_first(ray, one, other) < 0) == truth);
  REQUIRE((exact::compare_first(ray, other, one) > 0) - (exact::compare_first(ray, other, one) < 0) == -truth);
  const oracle::Exact zero;
  for (const Environment& environment : {Environment{}, Environment{FloatMode::upward, true}}) {
    const exact::Enclosure t = in_mode(
        environment, +[](const Ray<T>& r, const One<T>& s) { return exact::enclose_first(r, s); }, ray, one);
    const auto compare_with = [&](double x) { return fuzz::compare(a, {mpq_class(x), 0, 0}); };
    if (t.low > -0x1p1023) REQUIRE(compare_with(t.low) >= 0);
    if (t.high < 0x1p1023) REQUIRE(compare_with(t.high) <= 0);
  }
}

TEST_CASE("Hits are ordered exactly") {
  in_both_formats([]<Real T>() {
    constexpr std::uint64_t seed = 2;
    const Random stream(seed, "order", sizeof(T));
    std::array<int, 3> triangles{}, spheres{}, both{};
    for (std::uint64_t i = 0; i < 300; ++i) {
      INFO("seed " << seed << ", scene " << i);
      Random random = stream.at(i);
      const fuzz::SceneDraft<T> draft = fuzz::draft_scene<T>(random);
      for (int r = 0; r < 4; ++r) {
        const Ray<T> ray = fuzz::draft_ray(draft, random);
        for (std::size_t p = 1; p < std::min<std::size_t>(draft.primitives.size(), 16); ++p) {
          const auto &one = draft.primitives[p - 1], &other = draft.primitives[p];
          if (one.shape == Shape::triangle && other.shape == Shape::triangle) {
            require_order(ray, one.triangle, other.triangle, triangles);
          } else if (one.shape == Shape::sphere && other.shape == Shape::sphere) {
            require_order(ray, one.sphere, other.sphere, spheres);
          } else if (one.shape == Shape::sphere) {
            require_order(ray, one.sphere, other.triangle, both);
          } else {
            require_order(ray, one.triangle, other.sphere, both);
          }
        }
      }
    }
    for (const std::array<int, 3>& met : {triangles, spheres}) {
      for (const int n : met) CHECK(n > 20);
    }
    CHECK(both[0] + both[1] + both[2] > 5);
  });
}

/// Two spheres whose first roots are (B1 - sqrt(D1)) / A and (B2 - sqrt(D2)) / A, apart by less than any number of the format
/// tells.
TEST_CASE("Roots that round to one number are told apart") {
  const Ray<double> ray{{0, 0, 0}, {1, 0, 0}};
  // t = 4 - sqrt(r^2 - y^2): y differs by an ulp.
  const double y = 0.5, r = 3;
  const Sphere<double> one{{4, y, 0}, r}, other{{4, std::nextafter(y, 1.0), 0}, r};
  CHECK(exact::compare_first(ray, one, other) < 0);
  CHECK(exact::compare_first(ray, other, one) > 0);
  CHECK(exact::compare_first(ray, one, one) == 0);
  // The square root of 2 against its nearest double: a root against a quotient.
  const Sphere<double> root{{0, 1, 0}, std::sqrt(2.0)};
  const double t = 1;
  const Triangle<double> below{{t - 0x1p-53, -1, -1}, {t - 0x1p-53, 2, -1}, {t - 0x1p-53, 0, 2}};
  const Triangle<double> above{{t + 0x1p-52, -1, -1}, {t + 0x1p-52, 2, -1}, {t + 0x1p-52, 0, 2}};
  // sqrt(2.0) is above the root of 2: the sphere is met behind t = 1, by less than half an ulp.
  CHECK(exact::compare_first(Ray<double>{{0, 0, 0}, {1, 0, 0}, 0.5}, root, below) > 0);
  CHECK(exact::compare_first(Ray<double>{{0, 0, 0}, {1, 0, 0}, 0.5}, root,
                             Triangle<double>{{1, -1, -1}, {1, 2, -1}, {1, 0, 2}}) > 0);
  CHECK(exact::compare_first(Ray<double>{{0, 0, 0}, {1, 0, 0}, 0.5}, above, root) > 0);
}

}  // namespace
}  // namespace graze::test
