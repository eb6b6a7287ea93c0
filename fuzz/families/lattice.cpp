// lattice. The exhaustive small lattices as a stream, each in an order of its own that a seed chooses: all rays and triangles
// on {0,1,2}^3 (13,817,466; four cases of eight), all coplanar rays and triangles on a grid of five by five (9,375,000; three
// of eight), all rays and spheres of radius 0 to 3 on {0,1,2}^3 (75,816; one of eight). With all triangles come all
// permutations of corners and all reflections of axes. After the last case of a list it starts over, and from then on
// everything is scaled by powers of two. No random choice can leave a configuration out here; no case carries a promise.
#include "fuzz/families/finish.hpp"
#include "fuzz/families/registry.hpp"

namespace graze::fuzz::construct {

namespace {

/// Digits of a mixed-radix number, taken from the right.
class Picker {
 public:
  explicit Picker(std::uint64_t number) : rest_(number) {}
  std::uint64_t take(std::uint64_t radix) {
    const std::uint64_t digit = rest_ % radix;
    rest_ /= radix;
    return digit;
  }
  /// Two different digits.
  std::array<std::uint64_t, 2> take_pair(std::uint64_t radix) {
    const std::uint64_t first = take(radix);
    const std::uint64_t second = take(radix - 1);
    return {first, second + (second >= first ? 1 : 0)};
  }

 private:
  std::uint64_t rest_;
};

IntVec cube_point(std::uint64_t n) {
  return {static_cast<Int>(n % 3), static_cast<Int>(n / 3 % 3), static_cast<Int>(n / 9)};
}
IntVec grid_point(std::uint64_t n) {
  return {static_cast<Int>(n % 5), static_cast<Int>(n / 5), 0};
}

constexpr std::uint64_t cube_triangles = 27 * 26 * 27 * 27 * 27;
constexpr std::uint64_t grid_triangles = 25 * 24 * 25 * 25 * 25;
constexpr std::uint64_t cube_spheres = 27 * 26 * 27 * 4;

TriangleDraft triangle_number(std::uint64_t number, std::uint64_t points, IntVec (*point)(std::uint64_t)) {
  Picker picker(number);
  const auto [from, to] = picker.take_pair(points);
  TriangleDraft draft;
  draft.origin = point(from);
  draft.direction = point(to) - point(from);
  for (IntVec& corner : draft.corner) corner = point(picker.take(points));
  return draft;
}

SphereDraft sphere_number(std::uint64_t number) {
  Picker picker(number);
  const auto [from, to] = picker.take_pair(27);
  SphereDraft draft;
  draft.origin = cube_point(from);
  draft.direction = cube_point(to) - cube_point(from);
  draft.center = cube_point(picker.take(27));
  draft.radius = static_cast<Int>(picker.take(4));
  return draft;
}

/// A permutation of 0 ... size - 1 that the stream's seed chooses: n -> a n + b, with a prime to the size.
std::uint64_t permuted(std::uint64_t n, std::uint64_t size, const Random& random) {
  Random choice = random.at(~size);
  std::uint64_t factor = 1 + choice.below(size);
  while (gcd(static_cast<Int>(factor), static_cast<Int>(size)) != 1) ++factor;
  const std::uint64_t shift = choice.below(size);
  return (n * factor + shift) % size;
}

struct LatticeFamily {
  static constexpr std::string_view name = "lattice";
  static constexpr std::string_view attacks = "every configuration of small lattices";
  static constexpr Note note{"any: every configuration of small integers is there", "whatever case analysis forgot",
                             "mikedh/trimesh issue 331: an origin on the mesh hits it now and then"};
  template <Real T>
  static LabelledCase<T> make(Random& random, std::uint64_t index) {
    const std::uint64_t round = index / 8;
    const std::uint64_t slot = index % 8;
    std::uint64_t number = 0, size = 0;
    Draft draft;
    if (slot < 4) {
      number = 4 * round + slot;
      size = cube_triangles;
      draft = triangle_number(permuted(number % size, size, random), 27, cube_point);
    } else if (slot < 7) {
      number = 3 * round + slot - 4;
      size = grid_triangles;
      draft = triangle_number(permuted(number % size, size, random), 25, grid_point);
    } else {
      number = round;
      size = cube_spheres;
      draft = sphere_number(permuted(number % size, size, random));
    }
    Plan plan;
    plan.range = Range::never;
    if (number >= size) return finish<T>(draft, random, plan);
    return unscaled<T>(draft);
  }

 private:
  template <Real T>
  static Vec3<T> point(const IntVec& v) {
    return {static_cast<T>(v.x), static_cast<T>(v.y), static_cast<T>(v.z)};
  }
  /// The lattice as it stands: no symmetry and no scale, so that the first pass is complete.
  template <Real T>
  static LabelledCase<T> unscaled(const Draft& draft) {
    LabelledCase<T> result;
    if (const auto* sphere = std::get_if<SphereDraft>(&draft)) {
      RaySphere<T> made;
      made.ray.origin = point<T>(sphere->origin);
      made.ray.direction = point<T>(sphere->direction);
      made.sphere = {point<T>(sphere->center), static_cast<T>(sphere->radius)};
      result.input = made;
    } else {
      const auto& triangle = std::get<TriangleDraft>(draft);
      RayTriangle<T> made;
      made.ray.origin = point<T>(triangle.origin);
      made.ray.direction = point<T>(triangle.direction);
      made.triangle = {point<T>(triangle.corner[0]), point<T>(triangle.corner[1]), point<T>(triangle.corner[2])};
      result.input = made;
    }
    return result;
  }
};

}  // namespace

Family lattice_family() {
  return family_of<LatticeFamily>();
}

}  // namespace graze::fuzz::construct
