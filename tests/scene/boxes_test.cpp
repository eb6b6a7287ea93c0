// The box test against exact rational arithmetic: what the exact ray meets is never rejected.
#include <gmpxx.h>

#include <array>
#include <cmath>

#include "fuzz/random.hpp"
#include "scene/box_ray.hpp"
#include "scene/kernels.hpp"
#include "tests/catch.hpp"
#include "tests/scene/each_target.hpp"
#include "tests/support/formats.hpp"
#include "tests/support/in_mode.hpp"
#include "tests/support/times_power.hpp"

namespace graze::test {
namespace {

using fuzz::Random;
using scene::Box, scene::BoxRay, scene::Node, scene::Space;

/// The least t at which the exact ray is in the box; false where there is none.
template <Real T>
bool meets_exactly(const Space& space, const Box& box, const Ray<T>& ray, mpq_class& entry) {
  entry = static_cast<double>(ray.t_min);
  mpq_class exit;
  bool has_exit = std::isfinite(ray.t_max);
  if (has_exit) exit = static_cast<double>(ray.t_max);
  const std::array<T, 3> e{ray.origin.x, ray.origin.y, ray.origin.z}, d{ray.direction.x, ray.direction.y, ray.direction.z};
  for (int k = 0; k < 3; ++k) {
    const mpq_class unit = times_power(1, -space.exponent);
    const mpq_class low =
        4 * mpq_class(space.quarter_origin[k]) + unit * static_cast<double>(box.low[k]) - static_cast<double>(e[k]);
    const mpq_class high =
        4 * mpq_class(space.quarter_origin[k]) + unit * static_cast<double>(box.high[k]) - static_cast<double>(e[k]);
    if (d[k] == 0) {
      if (sgn(low) > 0 || sgn(high) < 0) return false;
      continue;
    }
    const mpq_class slope = static_cast<double>(d[k]);
    const mpq_class first = (d[k] > 0 ? low : high) / slope, last = (d[k] > 0 ? high : low) / slope;
    if (first > entry) entry = first;
    if (!has_exit || last < exit) exit = last;
    has_exit = true;
  }
  return !has_exit || entry <= exit;
}

template <Real T>
BoxRay target_box_ray(const Space& space, const Box& root, const Ray<T>& ray) {
  return scene::kernels().template batches<T>().box_ray(space, root, ray);
}

/// Whether the target has the ray as box_ray has it.
template <Real T>
bool has_same_box_ray(const Space& space, const Box& root, const Ray<T>& ray) {
  const BoxRay one = target_box_ray(space, root, ray), other = scene::box_ray(space, root, ray);
  const auto same = [](auto a, auto b) { return numeric::bits_of(a) == numeric::bits_of(b); };
  bool is_same = same(one.high, other.high) && same(one.reach, other.reach) && same(one.reach_offset, other.reach_offset) &&
                 one.is_blind == other.is_blind;
  for (int k = 0; k < 3; ++k) {
    is_same &= same(one.reciprocal[k], other.reciprocal[k]) && same(one.far_reciprocal[k], other.far_reciprocal[k]) &&
               same(one.near_offset[k], other.near_offset[k]) && same(one.far_offset[k], other.far_offset[k]) &&
               one.near_row[k] == other.near_row[k] && one.far_row[k] == other.far_row[k];
  }
  return is_same;
}

template <Real T>
bool meets(const Space& space, const Box& root, const Box& box, const Ray<T>& ray, double end) {
  Node node;
  for (int i = 0; i < scene::width; ++i) node.set(i, Box::empty(), scene::Child::nothing());
  node.set(5, box, scene::Child::node(1));
  BoxRay box_ray = target_box_ray(space, root, ray);
  box_ray.end_at(end);
  float entry[scene::width];
  const unsigned met = scene::kernels().meet_boxes(box_ray, node, entry);
  return (met >> 5 & 1) != 0 && entry[5] <= box_ray.high;
}

/// Not below x.
double above(const mpq_class& x) {
  const double d = x.get_d();  // toward zero
  if (std::isinf(d)) return d;
  const double up = mpq_class(d) >= x ? d : std::nextafter(d, std::numeric_limits<double>::infinity());
  // As the tracer's ends are: zero or normal.
  return std::fabs(up) >= 0x1p-1022 ? up : up > 0 ? 0x1p-1022 : 0;
}

float choose_coordinate(Random& random) {
  switch (random.below(6)) {
    case 0:
      return 0;
    case 1:
      return static_cast<float>(random.between(-8, 8)) / 8;
    case 2:
      return static_cast<float>(std::ldexp(random.sign(), random.between(-126, 0)));
    default:
      return static_cast<float>(random.between(-(1 << 24), 1 << 24)) * 0x1p-24F;
  }
}

Box choose_box(Random& random) {
  Box box;
  const int kind = random.between(0, 3);
  for (int k = 0; k < 3; ++k) {
    const float one = choose_coordinate(random);
    float other = kind == 0 ? one : choose_coordinate(random);
    if (kind == 1) other = one + static_cast<float>(std::ldexp(random.between(0, 3), random.between(-24, -10)));
    box.low[k] = std::min(one, other);
    box.high[k] = std::max(one, other);
  }
  return box;
}

/// A number of the format near x, or a few units from it.
template <Real T>
T near(const mpq_class& x, Random& random) {
  T t = static_cast<T>(x.get_d());
  if (!std::isfinite(t)) t = std::numeric_limits<T>::max();
  for (int n = random.one_in(3) ? random.between(-2, 2) : 0; n != 0; n += n < 0 ? 1 : -1) {
    t = std::nextafter(t, n < 0 ? T(-1e30) : T(1e30));
  }
  return std::isfinite(t) ? t : T(0);
}

/// A ray through or past a point of the box's surface, mostly a corner.
template <Real T>
Ray<T> choose_ray(const Space& space, const Box& box, Random& random) {
  std::array<T, 3> e{}, d{};
  const int distance = random.one_in(8) ? 1 << random.between(0, 30) : random.between(-2, 5);
  for (int k = 0; k < 3; ++k) {
    const float p = random.one_in(2) ? box.low[k] : random.one_in(4) ? (box.low[k] + box.high[k]) / 2 : box.high[k];
    const mpq_class target = 4 * mpq_class(space.quarter_origin[k]) + times_power(1, -space.exponent) * static_cast<double>(p);
    // So many directions' lengths of 1 / 2^j the target is away.
    const mpq_class step = random.one_in(5)
                               ? mpq_class(0)
                               : mpq_class(times_power(1, random.between(-3, 3) - space.exponent) * random.between(-9, 9));
    d[k] = near<T>(step, random);
    if (random.one_in(6)) d[k] = 0;
    if (random.one_in(12)) d[k] = static_cast<T>(random.sign()) * std::numeric_limits<T>::denorm_min();
    e[k] = near<T>(target - distance * mpq_class(static_cast<double>(d[k])), random);
  }
  if (random.one_in(5)) {
    // From the space's origin, where offsets are zero and only relative errors are left.
    for (int k = 0; k < 3; ++k) {
      e[k] = static_cast<T>(4 * space.quarter_origin[k]);
      d[k] = near<T>(times_power(1, -space.exponent) * static_cast<double>(box.low[k]) * random.between(1, 3), random);
    }
  }
  Ray<T> ray{{e[0], e[1], e[2]}, {d[0], d[1], d[2]}};
  if (d[0] == 0 && d[1] == 0 && d[2] == 0) ray.direction.y = std::numeric_limits<T>::max();
  if (random.one_in(3)) ray.t_min = static_cast<T>(random.between(-5, 5));
  if (random.one_in(4)) ray.t_min = std::numeric_limits<T>::lowest();
  if (random.one_in(8)) ray.t_max = std::max(ray.t_min, static_cast<T>(random.between(-4, 6)));
  return ray;
}

template <Real T>
Space choose_space(Random& random) {
  // Scene coordinates are about 2^size.
  const int size = random.one_in(2) ? random.between(-3, 3)
                                    : random.between(std::numeric_limits<T>::min_exponent - (sizeof(T) == 4 ? 20 : 0),
                                                     std::numeric_limits<T>::max_exponent - 3);
  std::array<double, 3> origin{};
  for (double& o : origin) {
    o = random.one_in(2) ? 0 : static_cast<double>(static_cast<T>(std::ldexp(random.between(-100, 100) / 128.0, size)));
  }
  return Space::about<T>(origin, std::max(std::min(-size, 898), -1024));
}

TEST_CASE("No box is rejected that the exact ray meets, on any target") {
  const EachTarget targets;
  in_both_formats([&]<Real T>() {
    constexpr std::uint64_t seed = 1;
    const Random stream(seed, "boxes", sizeof(T));
    int met = 0, missed = 0, rejected = 0;
    for (std::uint64_t i = 0; i < 50'000; ++i) {
      Random random = stream.at(i);
      const Space space = choose_space<T>(random);
      const Box box = choose_box(random);
      Box root = box;
      if (random.one_in(2)) root.include({{-1, -1, -1}, {1, 1, 1}});
      const Ray<T> ray = choose_ray<T>(space, box, random);
      targets.choose(i);
      mpq_class entry;
      const bool is_met = meets_exactly(space, box, ray, entry);
      const double end = is_met && random.one_in(2) ? above(entry) : std::numeric_limits<double>::infinity();
      ++(is_met ? met : missed);
      rejected += !is_met && !meets(space, root, box, ray, end);
      for (const Environment& environment : environments) {
        const bool is_same = in_mode(environment, has_same_box_ray<T>, space, root, ray);
        if (is_same && (!is_met || in_mode(environment, meets<T>, space, root, box, ray, end))) continue;
        INFO("seed " << seed << ", case " << i);
        CAPTURE(environment, is_same, end, entry.get_d(), space.exponent, ray.t_min, ray.t_max);
        CAPTURE(ray.origin.x, ray.origin.y, ray.origin.z, ray.direction.x, ray.direction.y, ray.direction.z);
        CAPTURE(box.low[0], box.low[1], box.low[2], box.high[0], box.high[1], box.high[2]);
        REQUIRE(false);
      }
    }
    CAPTURE(met, missed, rejected);
    CHECK(met > 2000);
    CHECK(rejected > missed / 4);
  });
}

TEST_CASE("A shape lies in its box") {
  in_both_formats([]<Real T>() {
    const Random stream(1, "shape-boxes", sizeof(T));
    for (std::uint64_t i = 0; i < 4000; ++i) {
      Random random = stream.at(i);
      const Space space = choose_space<T>(random);
      const mpq_class unit = times_power(1, -space.exponent);
      std::array<T, 4> x{};
      for (T& c : x) c = near<T>(unit * static_cast<double>(choose_coordinate(random)), random);
      const T radius = std::fabs(x[3]);
      const auto coordinate = [&](int k) {
        return mpq_class((mpq_class(static_cast<double>(x[k])) - 4 * mpq_class(space.quarter_origin[k])) / unit);
      };
      for (const Environment& environment : environments) {
        const Box point = in_mode(
            environment, +[](const Space& s, const Triangle<T>& t) { return scene::box_of(s, t); }, space,
            Triangle<T>{{x[0], x[1], x[2]}, {x[0], x[1], x[2]}, {x[0], x[1], x[2]}});
        const Box ball = in_mode(
            environment, +[](const Space& s, const Sphere<T>& t) { return scene::box_of(s, t); }, space,
            Sphere<T>{{x[0], x[1], x[2]}, radius});
        for (int k = 0; k < 3; ++k) {
          const mpq_class v = coordinate(k), r = mpq_class(static_cast<double>(radius)) / unit;
          const bool holds_point = v >= static_cast<double>(point.low[k]) && v <= static_cast<double>(point.high[k]);
          const bool holds_ball = v - r >= static_cast<double>(ball.low[k]) && v + r <= static_cast<double>(ball.high[k]);
          const bool is_normal = std::fabs(point.low[k]) >= 0x1p-126F && std::fabs(ball.high[k]) >= 0x1p-126F;
          if (holds_point && holds_ball && is_normal) continue;
          INFO("case " << i << ", " << environment);
          REQUIRE(holds_point);
          REQUIRE(holds_ball);
          REQUIRE(is_normal);
        }
      }
    }
  });
}

}  // namespace
}  // namespace graze::test
