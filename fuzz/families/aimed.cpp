// aimed. What users do by hand: random corners and centers with full mantissas, and a direction computed toward a corner, a
// point of an edge or the silhouette. Pure cases aim at a corner whose difference to the origin is exact, so t = 1 and the
// corner is promised. The others round the difference, the point of the edge, or the touching point, so the ray passes within
// an ulp or two of it, on a side that only exact signs tell.
#include <cmath>

#include "fuzz/families/constructions.hpp"
#include "fuzz/families/finish.hpp"
#include "fuzz/families/registry.hpp"

namespace graze::fuzz::construct {

namespace {

/// Toward a corner, or a sphere's center, by an exact difference.
TriangleDraft exact_aim(Random& random, int digits) {
  const int bits = choose_bits(random, 2, digits - 2);
  TriangleDraft draft;
  draft.origin = choose_vector(random, bits);
  for (IntVec& corner : draft.corner) corner = choose_vector(random, bits);
  const int target = random.between(0, 2);
  draft.direction = draft.corner[static_cast<std::size_t>(target)] - draft.origin;
  if (surely_independent(draft.corner[0] - draft.origin, draft.corner[1] - draft.origin, draft.corner[2] - draft.origin)) {
    draft.promise = {vertex(target), one_mark(Mark{1, 1})};
  } else if (is_zero(draft.direction)) {
    draft.direction.x = 1;
  }
  return draft;
}

/// A sphere whose center is on the ray; half of them are points.
SphereDraft exact_center(Random& random, int digits) {
  const int bits = choose_bits(random, 2, digits - 2);
  SphereDraft draft;
  draft.origin = choose_vector(random, bits);
  draft.center = choose_vector(random, bits);
  if (draft.center == draft.origin) draft.center.x += 1;
  draft.direction = draft.center - draft.origin;
  draft.radius = random.one_in(2) ? 0 : choose_natural(random, bits);
  draft.promise = forward_promise(SphereKind::secant);
  if (draft.radius == 0) draft.promise = {SphereKind::tangent, one_mark(Mark{1, 1})};
  return draft;
}

/// A number with a full mantissa, about 2^exponent.
template <Real T>
T choose_real(Random& random, int exponent) {
  const Int mantissa = choose_integer(random, digits<T>);
  bool exact = true;
  return scaled<T>(mantissa, exponent - digits<T>, exact);
}
template <Real T>
Vec3<T> choose_real_vector(Random& random, int exponent) {
  Vec3<T> v;
  v.x = choose_real<T>(random, exponent);
  v.y = choose_real<T>(random, exponent);
  v.z = choose_real<T>(random, exponent);
  return v;
}

template <Real T>
Vec3<T> combined(T s, const Vec3<T>& p, T t, const Vec3<T>& q) {
  return {s * p.x + t * q.x, s * p.y + t * q.y, s * p.z + t * q.z};
}
template <Real T>
T dot(const Vec3<T>& p, const Vec3<T>& q) {
  return p.x * q.x + p.y * q.y + p.z * q.z;
}
template <Real T>
bool is_direction(const Vec3<T>& d) {
  return is_finite(d.x) && is_finite(d.y) && is_finite(d.z) && !(is_zero(d.x) && is_zero(d.y) && is_zero(d.z));
}

/// The difference, at times with a length of its own.
template <Real T>
Vec3<T> direction_to(const Vec3<T>& target, const Vec3<T>& origin, Random& random) {
  Vec3<T> d = combined(T(1), target, T(-1), origin);
  if (random.one_in(3)) {
    const T length = T(1) + choose_real<T>(random, -1);
    d = combined(length, d, T(0), d);
  }
  return is_direction(d) ? d : Vec3<T>{T(1), T(0), T(0)};
}

template <Real T>
Case<T> rounded_triangle(Random& random, int exponent) {
  RayTriangle<T> made;
  const int size = random.one_in(3) ? exponent - random.between(0, digits<T>) : exponent;
  const Vec3<T> at = choose_real_vector<T>(random, exponent);
  made.ray.origin = choose_real_vector<T>(random, exponent);
  for (Vec3<T>* corner : {&made.triangle.a, &made.triangle.b, &made.triangle.c}) {
    const Vec3<T> off = choose_real_vector<T>(random, size);
    *corner = combined(T(1), at, T(1), off);
  }
  const T share = T(0.5) + choose_real<T>(random, -1);
  const Vec3<T> on_edge = combined(share, made.triangle.a, T(1) - share, made.triangle.b);
  const bool is_corner = random.one_in(2);
  made.ray.direction = direction_to(is_corner ? made.triangle.a : on_edge, made.ray.origin, random);
  return made;
}

/// Touching: with L = c - e and w across L, the point L (1 - r^2/L^2) + w r sqrt(L^2 - r^2) / (|L| |w|).
template <Real T>
Case<T> rounded_silhouette(Random& random, int exponent) {
  RaySphere<T> made;
  made.ray.origin = choose_real_vector<T>(random, exponent);
  made.sphere.center = choose_real_vector<T>(random, exponent);
  const Vec3<T> l = combined(T(1), made.sphere.center, T(-1), made.ray.origin);
  const T squared = dot(l, l);
  const T ratio = T(0.5) + choose_real<T>(random, -1);
  const int smaller = random.one_in(2) ? 0 : random.between(0, digits<T>);
  made.sphere.radius = std::sqrt(squared) * ratio / static_cast<T>(std::uint64_t(1) << smaller);
  const T r = made.sphere.radius;
  const Vec3<T> any = choose_real_vector<T>(random, 0);
  const Vec3<T> across{l.y * any.z - l.z * any.y, l.z * any.x - l.x * any.z, l.x * any.y - l.y * any.x};
  const T along = T(1) - r * r / squared;
  const T aside = r * std::sqrt(squared - r * r) / std::sqrt(squared * dot(across, across));
  const Vec3<T> d = combined(along, l, aside, across);
  made.ray.direction = is_direction(d) ? d : Vec3<T>{T(1), T(0), T(0)};
  if (!is_finite(r)) made.sphere.radius = T(1);
  return made;
}

struct Aimed {
  static constexpr std::string_view name = "aimed";
  static constexpr std::string_view attacks = "directions rounded toward corners, edge points and silhouettes";
  static constexpr Note note{"thresholds tuned on random rays",
                             "rays that users aim at corners, edges and silhouettes are lost",
                             "google/vector_math.dart pull request 43: rays along the edge of two triangles hit neither"};
  template <Real T>
  static LabelledCase<T> make(Random& random, std::uint64_t index) {
    const bool is_triangle = is_triangle_index(index);
    if (is_pure_index(index)) {
      if (is_triangle) return finish<T>(exact_aim(random, digits<T>), random, index);
      return finish<T>(exact_center(random, digits<T>), random, index);
    }
    const int extent = random.one_in(4) ? end_exponent<T> / 5 : 8;
    const int exponent = random.between(-extent, extent);
    LabelledCase<T> result;
    result.input = is_triangle ? rounded_triangle<T>(random, exponent) : rounded_silhouette<T>(random, exponent);
    if (index % 4 == 3) nudge(result.input, random);
    return result;
  }
};

}  // namespace

Family aimed_family() {
  return family_of<Aimed>();
}

}  // namespace graze::fuzz::construct
