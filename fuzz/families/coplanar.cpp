// coplanar. Ray and triangle live on a two-dimensional integer grid that two lattice vectors lay into space: the ray crosses
// the triangle, touches a corner, runs along an edge (toward it, from a corner, from on it, away from it), passes a grid step
// beside an edge, or starts inside. On the grid the ray is clipped by the three edges in small integers, which promises the
// kind and both ends. Four collinear grid points come up all the time. What breaks: the parallel test, and clipping at corners.
#include "fuzz/families/constructions.hpp"
#include "fuzz/families/drafts.hpp"
#include "fuzz/families/finish.hpp"
#include "fuzz/families/registry.hpp"

namespace graze::fuzz::construct {

namespace {

struct GridVec {
  Int x = 0, y = 0;
};
GridVec operator+(const GridVec& p, const GridVec& q) {
  return {p.x + q.x, p.y + q.y};
}
GridVec operator-(const GridVec& p, const GridVec& q) {
  return {p.x - q.x, p.y - q.y};
}
GridVec operator*(Int s, const GridVec& p) {
  return {s * p.x, s * p.y};
}
Int cross(const GridVec& p, const GridVec& q) {
  return p.x * q.y - p.y * q.x;
}

struct Grid {
  std::array<GridVec, 3> corner;
  GridVec origin, direction;
};

GridVec choose_grid_vector(Random& random, int bits) {
  GridVec v;
  v.x = choose_integer(random, bits);
  v.y = choose_integer(random, bits);
  return v;
}

/// A ray that has to do with the triangle.
void choose_ray(Grid& grid, Random& random, int bits) {
  const std::size_t k = random.below(3);
  const GridVec a = grid.corner[k];
  const GridVec ab = grid.corner[(k + 1) % 3] - a;
  const GridVec ac = grid.corner[(k + 2) % 3] - a;
  const Int along = random.between(-3, 3);
  switch (random.below(6)) {
    case 0: {  // along an edge's line, either way
      const Int facing = random.sign();
      grid.direction = facing * ab;
      grid.origin = a + along * ab;
      break;
    }
    case 1: {  // along it, from a grid point of its line that need not be a corner
      const Int common = gcd(ab.x, ab.y);
      const GridVec unit{ab.x / common, ab.y / common};
      const Int start = choose_integer(random, 3);
      grid.direction = random.sign() * unit;
      grid.origin = a + start * unit;
      break;
    }
    case 2: {  // touching a corner: across the angle at it
      const Int p = random.between(1, 3);
      const Int q = random.between(1, 3);
      grid.direction = p * ab - q * ac;
      grid.origin = a - along * grid.direction;
      break;
    }
    case 3: {  // beside an edge, parallel
      GridVec step;
      step.x = random.between(-1, 1);
      step.y = random.between(-1, 1);
      grid.direction = random.sign() * ab;
      grid.origin = a + step - along * grid.direction;
      break;
    }
    case 4: {  // from anywhere through a corner
      grid.origin = choose_grid_vector(random, bits);
      grid.direction = a - grid.origin;
      break;
    }
    default: {
      grid.origin = choose_grid_vector(random, bits);
      grid.direction = choose_grid_vector(random, bits);
      break;
    }
  }
  if (grid.direction.x == 0 && grid.direction.y == 0) grid.direction = ab;
}

/// num / den; den > 0.
bool is_less(const Mark& p, const Mark& q) {
  return p.num * q.den < q.num * p.den;
}

/// Where the whole line runs inside: both ends, or a miss. The triangle has area.
Promise<TriangleKind> clip(const Grid& grid) {
  const Int turn = sign_of(cross(grid.corner[1] - grid.corner[0], grid.corner[2] - grid.corner[0]));
  std::optional<Mark> enter, leave;
  for (std::size_t k = 0; k < 3; ++k) {
    const GridVec edge = grid.corner[(k + 1) % 3] - grid.corner[k];
    const Int height = turn * cross(edge, grid.origin - grid.corner[k]);
    const Int slope = turn * cross(edge, grid.direction);  // inside where height + t slope >= 0
    if (slope == 0) {
      if (height < 0) return {TriangleKind::miss, {}};
      continue;
    }
    const Mark at = make_mark(-height, slope);
    std::optional<Mark>& end = slope > 0 ? enter : leave;
    if (!end || (slope > 0 ? is_less(*end, at) : is_less(at, *end))) end = at;
  }
  if (is_less(*leave, *enter)) return {TriangleKind::miss, {}};
  return {TriangleKind::coplanar, two_marks(*enter, *leave)};
}

Grid choose_grid(Random& random, int bits) {
  Grid grid;
  do {
    for (GridVec& corner : grid.corner) corner = choose_grid_vector(random, bits);
  } while (cross(grid.corner[1] - grid.corner[0], grid.corner[2] - grid.corner[0]) == 0);
  choose_ray(grid, random, bits);
  return grid;
}

}  // namespace

TriangleDraft coplanar_draft(Random& random, int digits) {
  const int grid_bits = random.one_in(4) ? random.between(2, digits / 4) : random.between(1, 3);
  const Grid grid = choose_grid(random, grid_bits);
  const int vector_bits = choose_bits(random, 1, digits - 8 - grid_bits);
  const IntVec g1 = choose_vector(random, vector_bits);
  IntVec g2 = choose_vector(random, vector_bits);
  if (is_zero(cross(g1, g2))) g2 = g1.x != 0 ? IntVec{0, 1, 0} : IntVec{1, 0, 0};
  const auto in_space = [&](const GridVec& p) { return p.x * g1 + p.y * g2; };

  TriangleDraft draft;
  draft.origin = in_space(grid.origin);
  draft.direction = in_space(grid.direction);
  for (std::size_t k = 0; k < 3; ++k) draft.corner[k] = in_space(grid.corner[k]);
  draft.promise = clip(grid);
  return draft;
}

namespace {
struct Coplanar {
  static constexpr std::string_view name = "coplanar";
  static constexpr std::string_view attacks = "the ray in the triangle's plane: crossing, touching, along an edge, beside it";
  static constexpr Note note{"parallel taken for no intersection",
                             "a ray in a wall's plane misses the wall; a cell walk gets lost",
                             "arborx/ArborX pull request 517: a ray in the triangle's plane is assumed to miss"};
  template <Real T>
  static LabelledCase<T> make(Random& random, std::uint64_t index) {
    Plan plan;
    plan.mixed_axes = index % 16 >= 12;
    return finish<T>(coplanar_draft(random, digits<T>), random, index, plan);
  }
};
}  // namespace

Family coplanar_family() {
  return family_of<Coplanar>();
}

}  // namespace graze::fuzz::construct
