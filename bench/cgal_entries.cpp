#include "bench/cgal_entries.hpp"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Sphere_3.h>

#include <memory>

#include "fuzz/subjects/cgal_epick.hpp"

namespace graze::bench {
namespace {

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;

template <class K>
typename K::Point_3 point(const Vec3<double>& v) {
  return {v.x, v.y, v.z};
}
template <class K>
typename K::Vector_3 vector(const Vec3<double>& v) {
  return {v.x, v.y, v.z};
}

template <class K>
typename K::Triangle_3 shape(const fuzz::RayTriangle<double>& q) {
  return {point<K>(q.triangle.a), point<K>(q.triangle.b), point<K>(q.triangle.c)};
}
/// The squared radius is rounded in EPICK: the peer's own limit.
template <class K>
typename K::Sphere_3 shape(const fuzz::RaySphere<double>& q) {
  const typename K::FT r(q.sphere.radius);
  return {point<K>(q.sphere.center), r * r};
}
template <class K, class Query>
typename K::Ray_3 ray(const Query& q) {
  return {point<K>(q.ray.origin), vector<K>(q.ray.direction)};
}

/// What CGAL refuses is a miss: degenerate triangles, and rays whose second point is rounded to the first.
template <class Ray, class Shape>
bool meets(const Ray& r, const Shape& s) {
  if (r.is_degenerate()) return false;
  if constexpr (requires { s.vertex(0); }) {
    if (s.is_degenerate()) return false;
  }
  return CGAL::do_intersect(r, s);
}

/// The inputs are CGAL's before the clock starts; EPECK keeps what it has once computed exactly, so its later passes have that
/// for free.
template <class K, class Query>
Entry<Query> decisions(const char* name, const char* label, const char* about, std::size_t stride) {
  Entry<Query> entry{name, label, about, false, {{fuzz::Deviation::degenerate_is_miss}}, stride, {}, {}, {}};
  entry.prepare = [](std::span<const Query> queries) -> Pass {
    struct Inputs {
      std::vector<typename K::Ray_3> rays;
      std::vector<decltype(shape<K>(Query{}))> shapes;
    };
    const auto inputs = std::make_shared<Inputs>();
    for (const Query& q : queries) {
      inputs->rays.push_back(ray<K>(q));
      inputs->shapes.push_back(shape<K>(q));
    }
    return [inputs] {
      std::size_t n = 0;
      for (std::size_t i = 0; i < inputs->rays.size(); ++i) n += meets(inputs->rays[i], inputs->shapes[i]) ? 1 : 0;
      return n;
    };
  };
  entry.decisions = [](std::span<const Query> queries) {
    std::vector<bool> out;
    for (const Query& q : queries) out.push_back(meets(ray<K>(q), shape<K>(q)));
    return out;
  };
  return entry;
}

template <class Query>
void add_decisions(std::vector<Entry<Query>>& entries) {
  entries.push_back(decisions<Epick, Query>("cgal-epick-hits", "EPICK", "CGAL's do_intersect with exact predicates", 4));
  // Slow where its filter fails.
  entries.push_back(decisions<Epeck, Query>("cgal-epeck-hits", "EPECK", "CGAL's do_intersect with exact constructions", 64));
}

/// do_intersect, and then t, u, v as quotients of determinants in EPECK's lazy numbers, read by to_double.
TriangleHit<double> intersect_exactly(const fuzz::RayTriangle<double>& q) {
  TriangleHit<double> hit;
  const Epeck::Ray_3 r = ray<Epeck>(q);
  const Epeck::Triangle_3 s = shape<Epeck>(q);
  if (!meets(r, s)) return hit;
  const Epeck::Vector_3 d = vector<Epeck>(q.ray.direction), e1 = s.vertex(1) - s.vertex(0), e2 = s.vertex(2) - s.vertex(0),
                        from_a = r.source() - s.vertex(0);
  const Epeck::Vector_3 p = CGAL::cross_product(d, e2), c = CGAL::cross_product(from_a, e1);
  const Epeck::FT determinant = e1 * p;
  if (CGAL::is_zero(determinant)) return hit;
  hit.kind = TriangleKind::face;
  hit.facing = CGAL::is_positive(determinant) ? Facing::front : Facing::back;
  hit.t = hit.t_end = CGAL::to_double((e2 * c) / determinant);
  hit.u = CGAL::to_double((from_a * p) / determinant);
  hit.v = CGAL::to_double((d * c) / determinant);
  return hit;
}

}  // namespace

void add_cgal_entries(std::vector<Entry<fuzz::RaySphere<double>>>& entries) {
  add_decisions(entries);
}

void add_cgal_entries(std::vector<Entry<fuzz::RayTriangle<double>>>& entries) {
  using Query = fuzz::RayTriangle<double>;
  using Epick_formula = fuzz::cgal_epick::Formula;
  add_decisions(entries);
  entries.push_back(numbers_entry<Query>("cgal-epick", "EPICK", std::string(Epick_formula::about), Epick_formula::deviations,
                                         [](const Query& q) { return fuzz::cgal_epick::intersect(q.ray, q.triangle); }));
  entries.back().stride = 4;
  using fuzz::Deviation;
  entries.push_back(numbers_entry<Query>("cgal-epeck", "EPECK",
                                         "CGAL's do_intersect, then t, u, v in EPECK's exact numbers, read by to_double",
                                         {{Deviation::coplanar_is_miss, Deviation::degenerate_is_miss,
                                           Deviation::edges_are_faces, Deviation::no_facing, Deviation::invalid_unhandled}},
                                         [](const Query& q) { return intersect_exactly(q); }));
  entries.back().stride = 64;
}

}  // namespace graze::bench
