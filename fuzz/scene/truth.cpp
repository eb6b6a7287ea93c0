#include "fuzz/scene/truth.hpp"

#include <algorithm>

#include "fuzz/case_text.hpp"
#include "fuzz/same_bits.hpp"
#include "graze/numeric/bits.hpp"

namespace graze::fuzz {
namespace {

using oracle::Exact;

/// The sign of x + s sqrt(y), y >= 0.
int sign_of_sum(const mpq_class& x, int s, const mpq_class& y) {
  const int a = sgn(x), b = sgn(y) == 0 ? 0 : s;
  if (a == 0 || b == 0 || a == b) return a != 0 ? a : b;
  return a * sgn(mpq_class(x * x - y));
}

template <Real T>
struct Hit {
  SceneHit<T> answer;
  Exact t;
};

template <Real T>
bool same_hit(const SceneHit<T>& a, const SceneHit<T>& b) {
  return a.status == b.status && a.shape == b.shape && a.index == b.index && same_bits(a.triangle, b.triangle) &&
         same_bits(a.sphere, b.sphere);
}

template <Real T>
std::string told(const SceneDraft<T>& scene, const Ray<T>& ray, const SceneHit<T>& hit) {
  if (!hit.is_hit()) return "miss";
  const auto& primitive = scene.primitives[hit.index];
  const std::string index = std::to_string(hit.index) + " ";
  if (hit.shape == Shape::triangle) {
    const Case<T> input = RayTriangle<T>{ray, primitive.triangle};
    return index + format_answer(input, Answer<T>(hit.triangle), Details::yes) + " (" + format_case(input) + ")";
  }
  const Case<T> input = RaySphere<T>{ray, primitive.sphere};
  return index + format_answer(input, Answer<T>(hit.sphere), Details::yes) + " (" + format_case(input) + ")";
}

/// The first difference of two lists of hits.
template <Real T>
std::optional<std::string> difference(const char* what, const SceneDraft<T>& draft, const Ray<T>& ray,
                                      std::span<const SceneHit<T>> found, std::span<const SceneHit<T>> truth) {
  for (std::size_t i = 0; i < std::max(found.size(), truth.size()); ++i) {
    const SceneHit<T> one = i < found.size() ? found[i] : SceneHit<T>{}, other = i < truth.size() ? truth[i] : SceneHit<T>{};
    if (same_hit(one, other)) continue;
    return std::string(what) + ", hit " + std::to_string(i) + ": " + told(draft, ray, one) + "; true is " +
           told(draft, ray, other);
  }
  return {};
}

}  // namespace

int compare(const Exact& one, const Exact& other) {
  const mpq_class e = one.rational - other.rational;
  const int s1 = sgn(one.radicand) == 0 ? 0 : one.root_sign, s2 = sgn(other.radicand) == 0 ? 0 : other.root_sign;
  if (s2 == 0) return sign_of_sum(e, s1, one.radicand);
  if (s1 == 0) return sign_of_sum(e, -s2, other.radicand);
  // P = s1 sqrt(r1) - s2 sqrt(r2).
  const int p = s1 != s2 ? s1 : s1 * sgn(mpq_class(one.radicand - other.radicand));
  if (sgn(e) == 0 || p == 0 || sgn(e) == p) return sgn(e) != 0 ? sgn(e) : p;
  // e^2 - P^2 = (e^2 - r1 - r2) + 2 s1 s2 sqrt(r1 r2).
  return sgn(e) * sign_of_sum(e * e - one.radicand - other.radicand, s1 * s2, 4 * one.radicand * other.radicand);
}

template <Real T>
SceneTruth<T> scene_truth(const SceneDraft<T>& scene, const Ray<T>& ray, const QueryOptions& options) {
  const oracle::Oracle& oracle = oracle::gmp_oracle();
  std::vector<Hit<T>> hits;
  for (std::uint32_t i = 0; i < scene.primitives.size(); ++i) {
    const auto& primitive = scene.primitives[i];
    if (i == options.leave_out || (primitive.mask & options.mask) == 0) continue;
    if (primitive.shape == Shape::triangle) {
      const TriangleHit<T> answer = oracle.answer(ray, primitive.triangle);
      if (answer.kind == TriangleKind::miss || answer.kind == TriangleKind::invalid) continue;
      if (options.ignore_coplanar && answer.kind == TriangleKind::coplanar) continue;
      if (options.cull_back_faces && answer.facing == Facing::back) continue;
      hits.push_back({{Status::ok, Shape::triangle, i, answer, {}}, oracle.truth(ray, primitive.triangle).t});
    } else {
      const SphereHit<T> answer = oracle.answer(ray, primitive.sphere);
      if (answer.count() == 0) continue;
      hits.push_back({{Status::ok, Shape::sphere, i, {}, answer}, oracle.truth(ray, primitive.sphere).t[0]});
    }
  }
  std::sort(hits.begin(), hits.end(), [](const Hit<T>& a, const Hit<T>& b) {
    const int order = compare(a.t, b.t);
    return order != 0 ? order < 0 : a.answer.index < b.answer.index;
  });
  SceneTruth<T> truth;
  for (const Hit<T>& hit : hits) {
    if (compare(hit.t, hits.front().t) == 0) ++truth.ties;
    truth.hits.push_back(hit.answer);
  }
  return truth;
}

template <Real T>
std::optional<std::string> find_scene_fault(const Scene<T>& scene, const SceneDraft<T>& draft, const Ray<T>& ray,
                                            const QueryOptions& options) {
  const SceneTruth<T> truth = scene_truth(draft, ray, options);
  const std::span<const SceneHit<T>> hits(truth.hits);
  const SceneHit<T> closest = scene.closest(ray, options);
  if (auto fault =
          difference("closest", draft, ray, std::span(&closest, closest.is_hit() ? 1 : 0), hits.first(hits.empty() ? 0 : 1))) {
    return fault;
  }
  if (auto fault = difference("all", draft, ray, std::span<const SceneHit<T>>(scene.all(ray, options)), hits)) return fault;
  if (auto fault =
          difference("ties", draft, ray, std::span<const SceneHit<T>>(scene.ties(ray, options)), hits.first(truth.ties))) {
    return fault;
  }
  if (scene.any(ray, options) == hits.empty()) return "any: " + std::to_string(hits.empty()) + " is wrong";
  const std::uint64_t count = scene.count(ray, options);
  if (count != hits.size()) return "count: " + std::to_string(count) + "; true is " + std::to_string(hits.size());
  return {};
}

template <Real T>
Place place_truth(const SceneDraft<T>& scene, const Vec3<T>& point, Random& random) {
  const oracle::Oracle& oracle = oracle::gmp_oracle();
  bool is_inside_spheres = false;
  for (const auto& primitive : scene.primitives) {
    if (primitive.shape == Shape::sphere) {
      const Sign sign = oracle.side(point, primitive.sphere).sign;
      if (sign == Sign::zero) return Place::boundary;
      is_inside_spheres ^= sign == Sign::negative;
    } else {
      // Of the ray nothing but its origin.
      const auto hit = oracle.answer(Ray<T>{point, {1, 0, 0}, 0, 0}, primitive.triangle);
      if (hit.kind != TriangleKind::miss) return Place::boundary;
    }
  }
  const auto odd = [&](const Vec3<T>& direction) -> std::optional<bool> {
    bool is_odd = false;
    for (const auto& primitive : scene.primitives) {
      if (primitive.shape == Shape::sphere) continue;
      const TriangleKind kind = oracle.answer(Ray<T>{point, direction}, primitive.triangle).kind;
      if (kind != TriangleKind::miss && kind != TriangleKind::face) return {};
      is_odd ^= kind == TriangleKind::face;
    }
    return is_odd;
  };
  for (int i = 0; i < 50; ++i) {
    Vec3<T> direction;
    for (T* d : {&direction.x, &direction.y, &direction.z}) *d = static_cast<T>(random.between(-1'000'000, 1'000'000));
    if (numeric::is_zero(direction)) continue;
    if (const auto is_odd = odd(direction)) return *is_odd != is_inside_spheres ? Place::inside : Place::outside;
  }
  return Place::unknown;
}

template SceneTruth<float> scene_truth(const SceneDraft<float>&, const Ray<float>&, const QueryOptions&);
template SceneTruth<double> scene_truth(const SceneDraft<double>&, const Ray<double>&, const QueryOptions&);
template std::optional<std::string> find_scene_fault(const Scene<float>&, const SceneDraft<float>&, const Ray<float>&,
                                                     const QueryOptions&);
template std::optional<std::string> find_scene_fault(const Scene<double>&, const SceneDraft<double>&, const Ray<double>&,
                                                     const QueryOptions&);

template Place place_truth(const SceneDraft<float>&, const Vec3<float>&, Random&);
template Place place_truth(const SceneDraft<double>&, const Vec3<double>&, Random&);

}  // namespace graze::fuzz
