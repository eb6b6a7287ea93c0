#include "fuzz/scene/draft.hpp"

#include <array>
#include <cmath>
#include <limits>

#include "graze/numeric/bits.hpp"

namespace graze::fuzz {
namespace {

/// In [-1, 1), with all bits.
template <Real T>
T choose_number(Random& random) {
  const auto bits = static_cast<std::int64_t>(random.bits() >> 11) - (std::int64_t(1) << 52);
  return static_cast<T>(static_cast<double>(bits) * 0x1p-52);
}

template <Real T>
Vec3<T> choose_point(Random& random) {
  const T x = choose_number<T>(random);
  const T y = choose_number<T>(random);
  const T z = choose_number<T>(random);
  return {x, y, z};
}

template <Real T>
Vec3<T> choose_lattice_point(Random& random, int side) {
  const int x = random.between(-side, side);
  const int y = random.between(-side, side);
  const int z = random.between(-side, side);
  return {T(x), T(y), T(z)};
}

template <Real T>
class Drafter {
 public:
  Drafter(Random& random, SceneDraft<T>& scene) : random_(random), scene_(scene) {}

  void triangle(const Vec3<T>& a, const Vec3<T>& b, const Vec3<T>& c) {
    const auto first = static_cast<std::uint32_t>(points_.size());
    points_.insert(points_.end(), {a, b, c});
    triangles_.push_back({first, first + 1, first + 2});
  }
  void sphere(const Vec3<T>& center, T radius) { spheres_.push_back({center, radius}); }

  /// Ends the part that is being drafted.
  void end() {
    const std::uint32_t mask = random_.one_in(3) ? 1 : random_.one_in(2) ? 2 : ~std::uint32_t(0);
    const auto unit = static_cast<T>(scene_.unit);
    const auto scale = [&](Vec3<T>& v) { v = {v.x * unit, v.y * unit, v.z * unit}; };
    for (Vec3<T>& p : points_) scale(p);
    for (const Corners& t : triangles_) {
      scene_.primitives.push_back({Shape::triangle, {points_[t[0]], points_[t[1]], points_[t[2]]}, {}, mask});
    }
    if (!triangles_.empty()) scene_.parts.push_back(Mesh<T>{std::move(points_), std::move(triangles_), mask});
    for (Sphere<T>& s : spheres_) {
      scale(s.center);
      s.radius *= unit;
      scene_.primitives.push_back({Shape::sphere, {}, s, mask});
    }
    if (!spheres_.empty()) scene_.parts.push_back(Spheres<T>{std::move(spheres_), mask});
    points_ = {};
    triangles_ = {};
    spheres_ = {};
  }

  void random(int n) {
    const T size = random_.one_in(2) ? T(1) : T(0.125);
    for (int i = 0; i < n; ++i) {
      const Vec3<T> a = choose_point<T>(random_);
      const Vec3<T> d = choose_point<T>(random_);
      const Vec3<T> e = choose_point<T>(random_);
      triangle(a, {a.x + size * d.x, a.y + size * d.y, a.z + size * d.z},
               {a.x + size * e.x, a.y + size * e.y, a.z + size * e.z});
    }
  }

  void lattice(int n, int side) {
    for (int i = 0; i < n; ++i) {
      const Vec3<T> a = choose_lattice_point<T>(random_, side);
      const Vec3<T> b = choose_lattice_point<T>(random_, side);
      const Vec3<T> c = choose_lattice_point<T>(random_, side);
      triangle(a, b, c);
    }
  }

  /// About one corner, each long and thin, some by an ulp.
  void slivers(int n) {
    const Vec3<T> apex = choose_point<T>(random_);
    Vec3<T> rim = choose_point<T>(random_);
    for (int i = 0; i < n; ++i) {
      Vec3<T> next = rim;
      const T step = static_cast<T>(std::ldexp(1.0, -random_.between(4, sizeof(T) == 4 ? 22 : 50)));
      const Vec3<T> d = choose_point<T>(random_);
      next = {rim.x + step * d.x, rim.y + step * d.y, rim.z + step * d.z};
      if (random_.one_in(4)) next.x = std::nextafter(rim.x, T(2));
      triangle(apex, rim, next);
      rim = next;
    }
  }

  /// Concentric, touching from inside and outside, on a lattice, and points.
  void spheres(int n) {
    Vec3<T> center = choose_lattice_point<T>(random_, 4);
    for (int i = 0; i < n; ++i) {
      const int radius = random_.between(0, 4);
      sphere(center, T(radius));
      if (random_.one_in(2)) continue;
      center = choose_lattice_point<T>(random_, 4);
    }
  }

 private:
  Random& random_;
  SceneDraft<T>& scene_;
  std::vector<Vec3<T>> points_;
  std::vector<Corners> triangles_;
  std::vector<Sphere<T>> spheres_;
};

/// The exponents of two by which small integers may be multiplied without leaving the format.
template <Real T>
int choose_exponent(Random& random) {
  using Limits = std::numeric_limits<T>;
  switch (random.below(4)) {
    case 0:
      return Limits::max_exponent - 8;
    case 1:
      return numeric::FormatOf<T>::least_exponent;
    case 2:
      return Limits::min_exponent;
    default:
      return random.between(numeric::FormatOf<T>::least_exponent, Limits::max_exponent - 8);
  }
}

}  // namespace

template <Real T>
SceneDraft<T> draft_scene(Random& random) {
  SceneDraft<T> scene;
  Drafter<T> drafter(random, scene);
  const int n = random.one_in(8) ? random.between(60, 150) : random.between(2, 20);
  const int half = n / 2;
  switch (random.below(11)) {
    case 0:
      scene.family = "random";
      drafter.random(n);
      break;
    case 1:
      scene.family = "lattice";
      drafter.lattice(n, random.between(1, 3));
      break;
    case 2:
      scene.family = "slivers";
      drafter.slivers(n);
      break;
    case 3:
      scene.family = "spheres";
      drafter.spheres(n);
      break;
    case 4:
      scene.family = "mixed";
      drafter.lattice(half, 3);
      drafter.end();
      drafter.spheres(n - half);
      drafter.end();
      drafter.lattice(half, 3);
      break;
    case 5: {
      scene.family = "extremes";
      scene.unit = std::ldexp(1.0, choose_exponent<T>(random));
      drafter.lattice(half, 3);
      drafter.end();
      drafter.spheres(n - half);
      break;
    }
    case 6:
      scene.family = "spread";
      for (int i = 0; i < n; ++i) {
        // The whole range of exponents, or sizes a million apart.
        const int reach = random.one_in(2) ? 20 : std::numeric_limits<T>::max_exponent - 8;
        scene.unit = std::ldexp(1.0, random.between(-reach, reach));
        if (random.one_in(3)) {
          drafter.spheres(1);
        } else {
          drafter.lattice(1, 2);
        }
        drafter.end();
      }
      scene.unit = 1;
      break;
    case 7: {
      scene.family = "far";
      const T distance = static_cast<T>(std::ldexp(1.0, random.between(10, sizeof(T) == 4 ? 20 : 44)));
      for (int i = 0; i < n; ++i) {
        Vec3<T> a = choose_lattice_point<T>(random, 3);
        Vec3<T> b = choose_lattice_point<T>(random, 3);
        Vec3<T> c = choose_lattice_point<T>(random, 3);
        for (Vec3<T>* p : {&a, &b, &c}) *p = {p->x + distance, p->y - distance, p->z};
        drafter.triangle(a, b, c);
      }
      break;
    }
    case 8: {
      scene.family = "same";
      const Vec3<T> a = choose_lattice_point<T>(random, 2);
      const Vec3<T> b = choose_lattice_point<T>(random, 2);
      const Vec3<T> c = choose_lattice_point<T>(random, 2);
      for (int i = 0; i < n; ++i) drafter.triangle(a, b, c);
      break;
    }
    case 9:
      scene.family = "degenerate";
      for (int i = 0; i < n; ++i) {
        const Vec3<T> a = choose_lattice_point<T>(random, 2);
        const Vec3<T> b = choose_lattice_point<T>(random, 2);
        drafter.triangle(a, b, random.one_in(3) ? a : Vec3<T>{2 * b.x - a.x, 2 * b.y - a.y, 2 * b.z - a.z});
      }
      break;
    default:
      scene.family = "few";
      if (random.one_in(2)) drafter.lattice(random.between(0, 1), 2);
      if (random.one_in(2)) drafter.spheres(random.between(0, 1));
      break;
  }
  drafter.end();
  return scene;
}

namespace {

/// A corner, the midpoint of an edge, a point of an edge's line, the middle; of a sphere the center or a point to graze it.
template <Real T>
Vec3<T> choose_target(const SceneDraft<T>& scene, Random& random) {
  if (scene.primitives.empty() || random.one_in(16)) return choose_point<T>(random);
  const auto& primitive = scene.primitives[random.below(scene.primitives.size())];
  if (primitive.shape == Shape::sphere) {
    const auto& [c, r] = primitive.sphere;
    switch (random.below(5)) {
      case 0:
        return c;
      case 1:
        return {c.x + r, c.y, c.z};
      case 2:
        return {c.x, c.y - r, c.z};
      default:
        return {c.x, c.y, c.z + r};
    }
  }
  const auto& [a, b, c] = primitive.triangle;
  switch (random.below(6)) {
    case 0:
      return a;
    case 1:
      return b;
    case 2:
      return c;
    case 3:
      return {a.x / 2 + b.x / 2, a.y / 2 + b.y / 2, a.z / 2 + b.z / 2};
    case 4:
      return {b.x + (b.x - c.x), b.y + (b.y - c.y), b.z + (b.z - c.z)};
    default:
      return {a.x / 2 + (b.x / 4 + c.x / 4), a.y / 2 + (b.y / 4 + c.y / 4), a.z / 2 + (b.z / 4 + c.z / 4)};
  }
}

template <Real T>
Vec3<T> choose_origin(const SceneDraft<T>& scene, Random& random) {
  const auto unit = static_cast<T>(scene.unit);
  Vec3<T> p;
  switch (random.below(4)) {
    case 0:
      return choose_target(scene, random);
    case 1:
      p = choose_lattice_point<T>(random, 6);
      break;
    case 2:
      p = choose_lattice_point<T>(random, 100);
      break;
    default:
      p = choose_point<T>(random);
      break;
  }
  return {p.x * unit, p.y * unit, p.z * unit};
}

template <Real T>
T limited(T x) {
  return std::isfinite(x) ? x : T(1);
}

}  // namespace

template <Real T>
Ray<T> draft_ray(const SceneDraft<T>& scene, Random& random) {
  Ray<T> ray;
  const Vec3<T> origin = choose_origin(scene, random);
  ray.origin = {limited(origin.x), limited(origin.y), limited(origin.z)};
  const Vec3<T> target = choose_target(scene, random);
  const Vec3<T>& e = ray.origin;
  ray.direction = {limited(target.x - e.x), limited(target.y - e.y), limited(target.z - e.z)};
  switch (random.below(8)) {
    case 0:
      ray.direction.x = 0;
      break;
    case 1:
      ray.direction = {0, ray.direction.y, 0};
      break;
    case 2: {
      // Another length, over the whole range, as far as the direction stays what it is.
      const T factor = static_cast<T>(std::ldexp(1.0, random.between(-40, 40)));
      const Vec3<T> d{ray.direction.x * factor, ray.direction.y * factor, ray.direction.z * factor};
      if (numeric::is_finite(d)) ray.direction = d;
      break;
    }
    case 3:
      ray.direction.z = random.one_in(2) ? std::numeric_limits<T>::denorm_min() : -std::numeric_limits<T>::min();
      break;
    default:
      break;
  }
  if (numeric::is_zero(ray.direction)) ray.direction.x = static_cast<T>(random.sign());
  constexpr T infinity = std::numeric_limits<T>::infinity();
  static constexpr std::array<std::array<T, 2>, 8> ranges{{{-4, infinity},
                                                           {0, 1},
                                                           {1, infinity},
                                                           {1, 1},
                                                           {T(0.5), 2},
                                                           {-1, T(0.5)},
                                                           {std::numeric_limits<T>::lowest(), infinity},
                                                           {0, 0}}};
  if (random.one_in(3)) {
    const auto& [t_min, t_max] = ranges[random.below(ranges.size())];
    ray.t_min = t_min;
    ray.t_max = t_max;
  }
  return ray;
}

template <Real T>
QueryOptions draft_options(const SceneDraft<T>& scene, Random& random) {
  QueryOptions options;
  if (!random.one_in(4)) return options;
  options.ignore_coplanar = random.one_in(2);
  options.cull_back_faces = random.one_in(2);
  if (random.one_in(2)) options.leave_out = static_cast<std::uint32_t>(random.below(scene.primitives.size() + 1));
  if (random.one_in(2)) options.mask = static_cast<std::uint32_t>(random.below(4));
  return options;
}

template SceneDraft<float> draft_scene(Random&);
template SceneDraft<double> draft_scene(Random&);
template Ray<float> draft_ray(const SceneDraft<float>&, Random&);
template Ray<double> draft_ray(const SceneDraft<double>&, Random&);
template QueryOptions draft_options(const SceneDraft<float>&, Random&);
template QueryOptions draft_options(const SceneDraft<double>&, Random&);

}  // namespace graze::fuzz
