// Numbers told by their bits, against what the language says of them in the default environment.
#include "graze/numeric/bits.hpp"

#include <cmath>

#include "graze/numeric/filter.hpp"
#include "tests/catch.hpp"
#include "tests/support/bit_patterns.hpp"
#include "tests/support/formats.hpp"

namespace graze::test {
namespace {

using namespace numeric;

TEST_CASE("Every bit pattern is classed as the language classes it") {
  int wrong = 0;
  const auto check = [&]<Real T>(T x) {
    wrong += is_finite(x) != std::isfinite(x);
    wrong += numeric::is_zero(x) != (x == T(0));
    wrong += is_negative(x) != (x < T(0));
    wrong += magnitude_bits(x) != bits_of(std::fabs(x));
  };
  each_pattern(check);
  CHECK(wrong == 0);
}

TEST_CASE("A vector is finite if all of it is, zero if all of it is") {
  in_both_formats([]<Real T>() {
    const T infinity = std::numeric_limits<T>::infinity(), nan = std::numeric_limits<T>::quiet_NaN();
    CHECK(is_finite(Vec3<T>{1, 2, 3}));
    CHECK(numeric::is_zero(Vec3<T>{0, T(-0.0), 0}));
    for (const T bad : {infinity, -infinity, nan}) {
      CHECK(!is_finite(Vec2<T>{bad, 0}));
      CHECK(!is_finite(Vec2<T>{0, bad}));
      for (const Vec3<T>& v : {Vec3<T>{bad, 0, 0}, Vec3<T>{0, bad, 0}, Vec3<T>{0, 0, bad}}) {
        CHECK(!is_finite(v));
        CHECK(!numeric::is_zero(v));
      }
    }
    const T least = std::numeric_limits<T>::denorm_min();
    for (const Vec3<T>& v : {Vec3<T>{least, 0, 0}, Vec3<T>{0, least, 0}, Vec3<T>{0, 0, -least}}) CHECK(!numeric::is_zero(v));
  });
}

TEST_CASE("Keys are ordered as the numbers are") {
  // Up through the positive patterns: each is above the one before it, and the negative ones mirror them.
  int wrong = 0;
  std::int64_t last = -1;
  each_float_pattern([&](float x) {
    if (std::signbit(x) || std::isnan(x)) return;
    wrong += order_key(x) <= last || order_key(-x) != -order_key(x);
    last = order_key(x);
  });
  CHECK(wrong == 0);
  fuzz::Random random(1, "keys", 0);
  for (int i = 0; i < 100000; ++i) {
    const auto a = random_finite<double>(random), b = random_finite<double>(random);
    wrong += (order_key(a) < order_key(b)) != (a < b);
  }
  CHECK(wrong == 0);
  CHECK(order_key(0.0) == order_key(-0.0));
  CHECK(order_key(0.0) < order_key(std::numeric_limits<double>::denorm_min()));
}

TEST_CASE("The default range, and the ranges that a filter takes") {
  in_each_filter([]<class W, Real T>() {
    const T infinity = std::numeric_limits<T>::infinity(), nan = std::numeric_limits<T>::quiet_NaN();
    const T least = std::numeric_limits<T>::denorm_min(), low = static_cast<T>(Ordinary<W, T>::low);
    const T high = static_cast<T>(Ordinary<W, T>::bound_high), above = std::nextafter(high, infinity);
    const auto ray = [](T t_min, T t_max) { return Ray<T>{{}, {1, 0, 0}, t_min, t_max}; };
    CHECK(is_default_range(Ray<T>{}));
    CHECK(is_default_range(ray(T(-0.0), infinity)));
    for (const T other : {least, -least, T(1), nan}) CHECK(!is_default_range(ray(other, infinity)));
    for (const T other : {-infinity, nan, T(1), std::numeric_limits<T>::max()}) CHECK(!is_default_range(ray(0, other)));

    CHECK(is_ordinary_range<W>(ray(0, infinity)));
    CHECK(is_ordinary_range<W>(ray(T(-0.0), T(0.0))));
    CHECK(is_ordinary_range<W>(ray(T(0.0), T(-0.0))));
    CHECK(is_ordinary_range<W>(ray(-1, 1)));
    CHECK(is_ordinary_range<W>(ray(low, high)));
    CHECK(!is_ordinary_range<W>(ray(2, 1)));
    for (const T bad : {least, std::nextafter(low, T(0)), above, nan, -infinity, infinity}) {
      CHECK(!is_ordinary_range<W>(ray(bad, infinity)));
      CHECK(!is_ordinary_range<W>(ray(-std::fabs(bad), std::fabs(bad) < 2 ? T(2) : infinity)));
    }
    for (const T bad : {least, std::nextafter(low, T(0)), above, nan, -infinity}) {
      CHECK(!is_ordinary_range<W>(ray(-1, bad)));
    }
  });
}

}  // namespace
}  // namespace graze::test
