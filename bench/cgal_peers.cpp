#include "bench/cgal_peers.hpp"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Ray_3.h>
#include <CGAL/Sphere_3.h>
#include <CGAL/Triangle_3.h>
#include <CGAL/intersections.h>

#include <memory>

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
typename K::Triangle_3 shape(const Triangle<double>& t) {
  return {point<K>(t.a), point<K>(t.b), point<K>(t.c)};
}

/// The squared radius is rounded in EPICK: the peer's own limit.
template <class K>
typename K::Sphere_3 shape(const Sphere<double>& s) {
  const typename K::FT r(s.radius);
  return {point<K>(s.center), r * r};
}

template <class K>
typename K::Ray_3 ray(const Ray<double>& r) {
  return {point<K>(r.origin), vector<K>(r.direction)};
}

/// The inputs are CGAL's before the clock starts; EPECK keeps what it has once computed exactly, so its later passes have that
/// for free.
template <class K, class Mix>
void add(const char* name, std::size_t stride, std::vector<Contender>& contenders, const Mix& mix) {
  struct Inputs {
    std::vector<typename K::Ray_3> rays;
    std::vector<decltype(shape<K>(mix.shapes.front()))> shapes;
  };
  const auto inputs = std::make_shared<Inputs>();
  for (std::size_t i = 0; i < mix.rays.size(); i += stride) {
    inputs->rays.push_back(ray<K>(mix.rays[i]));
    inputs->shapes.push_back(shape<K>(mix.shapes[i]));
  }
  const auto pass = [inputs] {
    std::size_t n = 0;
    for (std::size_t i = 0; i < inputs->rays.size(); ++i) n += CGAL::do_intersect(inputs->rays[i], inputs->shapes[i]);
    return n;
  };
  contenders.push_back({name, pass, inputs->rays.size()});
}

template <class Mix>
void add_both(std::vector<Contender>& contenders, const Mix& mix) {
  add<Epick>("CGAL EPICK do_intersect", 1, contenders, mix);
  // Slow where its filter fails: every 16th pair is enough for a median.
  add<Epeck>("CGAL EPECK do_intersect", 16, contenders, mix);
}

}  // namespace

void add_cgal_peers(std::vector<Contender>& contenders, const TriangleMix<double>& mix) {
  add_both(contenders, mix);
}
void add_cgal_peers(std::vector<Contender>& contenders, const SphereMix<double>& mix) {
  add_both(contenders, mix);
}

}  // namespace graze::bench
