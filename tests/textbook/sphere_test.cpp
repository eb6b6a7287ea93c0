// The three forms of the quadratic: where they agree, and where each is known to fail.
#include "graze/textbook/sphere.hpp"

#include <cmath>
#include <limits>

#include "tests/catch.hpp"

using graze::OriginSide;
using graze::Ray;
using graze::Real;
using graze::Root;
using graze::Sphere;
using graze::SphereHit;
using graze::SphereKind;
namespace textbook = graze::textbook;
using textbook::Quadratic;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

// The three forms behind one call.
template <Real T, class Check>
void for_each_form(const Ray<T>& ray, const Sphere<T>& sphere, Check check) {
  {
    INFO("naive");
    check(textbook::naive::intersect(ray, sphere), textbook::naive::hits(ray, sphere));
  }
  {
    INFO("stable");
    check(textbook::stable::intersect(ray, sphere), textbook::stable::hits(ray, sphere));
  }
  {
    INFO("repaired");
    check(textbook::repaired::intersect(ray, sphere), textbook::repaired::hits(ray, sphere));
  }
}

}  // namespace

TEST_CASE("the discriminant tells three cases apart") {
  const Sphere<double> sphere{{5, 0, 0}, 1};
  SECTION("positive: two roots") {
    const Ray<double> ray{{0, 0, 0}, {1, 0, 0}};
    CHECK(textbook::discriminant(textbook::quadratic(ray, sphere)) == 4);
    for_each_form(ray, sphere, [](const SphereHit<double>& hit, bool hits) {
      CHECK(hit.kind == SphereKind::secant);
      CHECK(hit.root == Root::both);
      CHECK(hit.origin == OriginSide::outside);
      CHECK(hit.t[0] == 4);
      CHECK(hit.t[1] == 6);
      CHECK(hits);
    });
  }
  SECTION("zero: a double root") {
    const Ray<double> ray{{0, 1, 0}, {1, 0, 0}};
    CHECK(textbook::discriminant(textbook::quadratic(ray, sphere)) == 0);
    for_each_form(ray, sphere, [](const SphereHit<double>& hit, bool hits) {
      CHECK(hit.kind == SphereKind::tangent);
      CHECK(hit.root == Root::both);
      CHECK(hit.t[0] == 5);
      CHECK(hit.t[1] == 0);
      CHECK(hits);
    });
  }
  SECTION("negative: none") {
    const Ray<double> ray{{0, 2, 0}, {1, 0, 0}};
    CHECK(textbook::discriminant(textbook::quadratic(ray, sphere)) < 0);
    for_each_form(ray, sphere, [](const SphereHit<double>& hit, bool hits) {
      CHECK(hit == SphereHit<double>{.origin = OriginSide::outside});
      CHECK(!hits);
    });
  }
}

TEST_CASE("the range chooses among the roots, both ends included") {
  const Sphere<double> sphere{{5, 0, 0}, 1};
  const auto kind_root = [&](double t_min, double t_max, SphereKind kind, Root root) {
    for_each_form(Ray<double>{{0, 0, 0}, {1, 0, 0}, t_min, t_max}, sphere, [&](const SphereHit<double>& hit, bool hits) {
      CAPTURE(t_min, t_max);
      CHECK(hit.kind == kind);
      CHECK(hit.root == root);
      CHECK(hits == (kind != SphereKind::miss));
      if (root == Root::second) CHECK(hit.t[0] == 6);
    });
  };
  kind_root(4, 6, SphereKind::secant, Root::both);
  kind_root(0, 4, SphereKind::secant, Root::first);
  kind_root(4.5, inf, SphereKind::secant, Root::second);
  kind_root(4.5, 5.5, SphereKind::miss, Root::none);
  kind_root(7, inf, SphereKind::miss, Root::none);
  kind_root(-inf, 3, SphereKind::miss, Root::none);
}

TEST_CASE("roots come ascending whichever way the ray runs") {
  for_each_form(Ray<float>{{0, 0, 0}, {-1, 0, 0}, -10, 10}, Sphere<float>{{5, 0, 0}, 1},
                [](const SphereHit<float>& hit, bool hits) {
                  CHECK(hit.t[0] == -6);
                  CHECK(hit.t[1] == -4);
                  CHECK(hits);
                });
}

TEST_CASE("the origin's side is the sign of C") {
  const Ray<double> ray{{0, 0, 0}, {1, 0, 0}};
  const auto origin = [&](const Sphere<double>& sphere) { return textbook::repaired::intersect(ray, sphere).origin; };
  CHECK(origin({{1, 0, 0}, 2}) == OriginSide::inside);
  CHECK(origin({{1, 0, 0}, 1}) == OriginSide::on);
  CHECK(origin({{1, 5, 0}, 1}) == OriginSide::outside);  // a miss too
}

TEST_CASE("at B = 0 the stable form with sgn(0) = 0 loses the roots, and the repaired one does not") {
  SECTION("as a quadratic: t^2 - 4 = 0") {
    const auto lost = textbook::stable::roots(Quadratic<double>{1, 0, -4});
    CHECK(lost.first == 0);
    CHECK(lost.second == inf);
    const auto kept = textbook::repaired::roots(Quadratic<double>{1, 0, -4});
    CHECK(kept.first == -2);
    CHECK(kept.second == 2);
  }
  SECTION("0 / 0 where C is 0 too") {
    const auto roots = textbook::stable::roots(Quadratic<double>{1, 0, 0});
    CHECK((std::isnan(roots.first) || std::isnan(roots.second)));
  }
  SECTION("as a ray from the center of a sphere") {
    const Ray<double> ray{{1, 2, 3}, {1, 2, 2}};
    const Sphere<double> sphere{{1, 2, 3}, 6};
    const auto lost = textbook::stable::intersect(ray, sphere);
    CHECK(lost.kind == SphereKind::secant);
    CHECK(lost.t[0] == 0);  // the true root in the range is 2
    CHECK(lost.t[1] == inf);
    const auto kept = textbook::repaired::intersect(ray, sphere);
    CHECK(kept.kind == SphereKind::secant);
    CHECK(kept.root == Root::second);
    CHECK(kept.t[0] == 2);
    CHECK(textbook::naive::intersect(ray, sphere) == kept);
  }
  SECTION("a bounded ray turns the lost roots into a lost hit") {
    const Ray<double> ray{{1, 2, 3}, {1, 2, 2}, 1, 10};
    const Sphere<double> sphere{{1, 2, 3}, 6};
    CHECK(textbook::stable::intersect(ray, sphere).kind == SphereKind::miss);
    CHECK(!textbook::stable::hits(ray, sphere));
    CHECK(textbook::repaired::hits(ray, sphere));
    CHECK(textbook::naive::hits(ray, sphere));
  }
}

TEST_CASE("the two statements of the stable form agree, and mixing them halves one root and doubles the other") {
  const Quadratic<double> q{2, -10, 12};  // roots 2 and 3
  const double doubled = -(q.b - std::sqrt(textbook::discriminant(q)));
  const auto roots = textbook::stable::roots(q);
  CHECK(roots.first == 2);
  CHECK(roots.second == 3);
  CHECK(doubled / (2 * q.a) == 3);
  CHECK(2 * q.c / doubled == 2);
  CHECK(doubled / q.a == 6);  // the slip
  CHECK(q.c / doubled == 1);
}

TEST_CASE("the naive form loses digits where the stable one does not") {
  SECTION("as a quadratic: t^2 - 1e8 t + 1 = 0, with a root at 1e-8") {
    const Quadratic<double> q{1, -1e8, 1};
    CHECK(textbook::naive::roots(q).second == 1e8);
    CHECK(std::abs(textbook::naive::roots(q).first - 1e-8) > 0.2e-8);  // a quarter of it is wrong
    CHECK(textbook::stable::roots(q).first == 1e-8);
    CHECK(textbook::repaired::roots(q).first == 1e-8);
  }
  SECTION("as a ray that starts beside a large sphere") {
    // C = 8, exactly: the first root is 4.0000000000000008e-8.
    const Ray<double> ray{{0, 0, 0}, {1, 0, 0}};
    const Sphere<double> sphere{{1e8, 2, 2}, 1e8};
    const double t = 4.0000000000000008e-8;
    CHECK(std::abs(textbook::naive::intersect(ray, sphere).t[0] - t) > 0.1 * t);
    CHECK(std::abs(textbook::stable::intersect(ray, sphere).t[0] - t) < 1e-15 * t);
    CHECK(std::abs(textbook::repaired::intersect(ray, sphere).t[0] - t) < 1e-15 * t);
  }
}

TEST_CASE("A near 0: one root is far away, and the naive form loses the near one") {
  // 2^-60 t^2 + t - 1 = 0 has a root at 1 - 2^-60, which rounds to 1.
  const Quadratic<double> q{std::ldexp(1.0, -60), 1, -1};
  CHECK(textbook::naive::roots(q).second == 0);
  CHECK(textbook::stable::roots(q).second == 1);
  CHECK(textbook::repaired::roots(q).second == 1);
  // A short direction does the same to a ray: |d|^2 underflows to 0, and no form has an answer left.
  const Ray<double> ray{{0, 0, 0}, {std::ldexp(1.0, -540), 0, 0}};
  for_each_form(ray, Sphere<double>{{5, 0, 0}, 1}, [](const SphereHit<double>& hit, bool) {
    CHECK(!(hit.t[0] == std::ldexp(1.0, 542)));  // 4 / |d|
  });
}

TEST_CASE("all forms lose a sphere that is far and small, and see one that is missed") {
  // The ray runs through the center; C = 2^80 - 1 rounds to 2^80, the discriminant to 0.
  const double far = std::ldexp(1.0, 40);
  for_each_form(Ray<double>{{0, 0, 0}, {1, 0, 0}}, Sphere<double>{{far, 0, 0}, 1},
                [](const SphereHit<double>& hit, bool) { CHECK(hit.kind == SphereKind::tangent); });
  // This one passes at the distance 2, twice the radius.
  for_each_form(Ray<double>{{0, 2, 0}, {1, 0, 0}}, Sphere<double>{{far, 0, 0}, 1},
                [](const SphereHit<double>& hit, bool) { CHECK(hit.kind == SphereKind::tangent); });
}

TEST_CASE("sphere: hits says what intersect says, whatever the numbers are") {
  const double numbers[] = {0, -0.0, 1, -2, 1e-200, 1e200, inf, std::numeric_limits<double>::quiet_NaN()};
  for (const double b : numbers) {
    for (const double c : numbers) {
      for (const double r : numbers) {
        for (const double d : numbers) {
          CAPTURE(b, c, r, d);
          for_each_form(Ray<double>{{b, 1, 0}, {d, 1, 0}}, Sphere<double>{{c, 0, 1}, r},
                        [](const SphereHit<double>& hit, bool hits) { CHECK(hits == (hit.kind != SphereKind::miss)); });
        }
      }
    }
  }
}
