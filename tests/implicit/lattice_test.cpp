// Every small lattice of points and surfaces, against arithmetic on small integers.
#include "tests/support/lattice.hpp"

#include "fuzz/case_text.hpp"
#include "graze/implicit.hpp"
#include "tests/support/answers.hpp"
#include "tests/support/formats.hpp"

namespace graze::test {
namespace {

Side side_of(int f) {
  return {Status::ok, f < 0 ? Sign::negative : f > 0 ? Sign::positive : Sign::zero};
}

template <Real T, class Query>
void require_side(const Query& query, const Side& found, int f) {
  if (found == side_of(f)) return;
  CAPTURE(found, f);
  INFO(fuzz::format_case(fuzz::Case<T>(query)));
  REQUIRE(found == side_of(f));
}

TEST_CASE("Every point and line of numbers from -3 to 3") {
  in_both_formats([]<Real T>() {
    for (std::uint64_t index = 0; index < 7 * 7 * 7 * 7 * 7; ++index) {
      Digits digits(index);
      const auto next = [&] { return digits.next(7) - 3; };
      const int x = next(), y = next(), a = next(), b = next(), c = next();
      const fuzz::PointLine<T> query{{T(x), T(y)}, {T(a), T(b), T(c)}};
      require_side<T>(query, side(query.point, query.line), a * x + b * y + c);
    }
  });
}

TEST_CASE("Every point and plane of numbers from -2 to 2") {
  in_both_formats([]<Real T>() {
    for (std::uint64_t index = 0; index < 5 * 5 * 5 * 5 * 5 * 5 * 5; ++index) {
      Digits digits(index);
      const auto next = [&] { return digits.next(5) - 2; };
      const int x = next(), y = next(), z = next(), a = next(), b = next(), c = next(), d = next();
      const fuzz::PointPlane<T> query{{T(x), T(y), T(z)}, {T(a), T(b), T(c), T(d)}};
      require_side<T>(query, side(query.point, query.plane), a * x + b * y + c * z + d);
    }
  });
}

TEST_CASE("Every point and sphere on a lattice five wide") {
  in_both_formats([]<Real T>() {
    for (std::uint64_t index = 0; index < 5 * 5 * 5 * 5 * 5 * 5 * 7; ++index) {
      Digits digits(index);
      const Vec3<T> p = digits.point<T>(-2, 5), c = digits.point<T>(-2, 5);
      const int r = digits.next(7);
      const auto square = [](T from, T to) { return static_cast<int>((from - to) * (from - to)); };
      const fuzz::PointSphere<T> query{p, {c, T(r)}};
      require_side<T>(query, side(p, query.sphere), square(p.x, c.x) + square(p.y, c.y) + square(p.z, c.z) - r * r);
    }
  });
}

}  // namespace
}  // namespace graze::test
