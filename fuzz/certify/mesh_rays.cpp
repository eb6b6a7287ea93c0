#include "fuzz/certify/mesh_rays.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>

#include "fuzz/certify/input_hash.hpp"
#include "fuzz/random.hpp"

namespace graze::fuzz {
namespace {

template <Real T>
Vec3<T> rounded(const Vec3<double>& p) {
  return {static_cast<T>(p.x), static_cast<T>(p.y), static_cast<T>(p.z)};
}

template <Real T>
Vec3<T> difference(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

/// In [0, 1).
double fraction(Random& random) {
  return static_cast<double>(random.bits() >> 11) * 0x1p-53;
}

}  // namespace

std::string_view name_of(Target target) {
  switch (target) {
    case Target::corner:
      return "corners";
    case Target::edge_midpoint:
      return "edge midpoints";
    case Target::face_center:
      return "face centers";
    case Target::other_corner:
      return "corner to corner";
    case Target::along_edge:
      return "along edges";
  }
  return "unknown";
}

template <Real T>
MeshRays<T>::MeshRays(const Mesh& mesh, std::uint64_t seed) {
  for (const Vec3<double>& p : mesh.points) points_.push_back(rounded<T>(p));
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> edge_of;
  fan_start_.assign(points_.size() + 1, 0);
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
    const auto& t = mesh.triangles[f];
    triangles_.push_back({points_[t[0]], points_[t[1]], points_[t[2]]});
    for (int k = 0; k < 3; ++k) {
      ++fan_start_[t[k] + 1];
      const auto [entry, is_new] = edge_of.try_emplace(std::minmax(t[k], t[(k + 1) % 3]), edges_.size());
      if (is_new) edges_.push_back({entry->first.first, entry->first.second, {}, 0});
      Edge& edge = edges_[entry->second];
      if (edge.face_count < 2) edge.faces[edge.face_count++] = f;
    }
  }
  for (std::uint32_t i = 0; i < points_.size(); ++i) {
    if (fan_start_[i + 1] != 0) corners_.push_back(i);
  }
  std::partial_sum(fan_start_.begin(), fan_start_.end(), fan_start_.begin());
  fan_.resize(3 * triangles_.size());
  std::vector<std::uint32_t> next(fan_start_.begin(), fan_start_.end() - 1);
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
    for (const std::uint32_t corner : mesh.triangles[f]) fan_[next[corner]++] = f;
  }
  faces_.resize(triangles_.size());
  std::iota(faces_.begin(), faces_.end(), 0u);

  for (std::uint64_t attempt = 0; attempt < 64; ++attempt) {
    if (draw_origin(seed, attempt)) return;
  }
  corners_.clear();
  edges_.clear();
  faces_.clear();
}

/// A point below a random face, by up to a tenth of the mesh's extent along the face's inner normal.
template <Real T>
bool MeshRays<T>::draw_origin(std::uint64_t seed, std::uint64_t attempt) {
  Random random(seed, "mesh-origin", attempt);
  const Triangle<T>& t = triangles_[random.below(triangles_.size())];
  const Vec3<T> ab = difference(t.b, t.a), ac = difference(t.c, t.a);
  const Vec3<double> n{double(ab.y) * ac.z - double(ab.z) * ac.y, double(ab.z) * ac.x - double(ab.x) * ac.z,
                       double(ab.x) * ac.y - double(ab.y) * ac.x};
  const double length = std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)});
  if (!(length > 0)) return false;
  const auto [low, high] = std::minmax_element(points_.begin(), points_.end(), [](auto& p, auto& q) { return p.x < q.x; });
  const double depth = (double(high->x) - double(low->x)) * 0.1 * (0.25 + fraction(random)) / length;
  const auto inside = [&](T a, T b, T c, double m) { return static_cast<T>((double(a) + b + c) / 3 - depth * m); };
  origin_ = {inside(t.a.x, t.b.x, t.c.x, n.x), inside(t.a.y, t.b.y, t.c.y, n.y), inside(t.a.z, t.b.z, t.c.z, n.z)};
  return is_inside(origin_, random.bits());
}

/// Crossing parity by the exact oracle along a direction that meets only faces.
template <Real T>
bool MeshRays<T>::is_inside(const Vec3<T>& point, std::uint64_t seed) const {
  for (std::uint64_t attempt = 0; attempt < 16; ++attempt) {
    Random random(seed, "mesh-parity", attempt);
    const double x = fraction(random), y = fraction(random), z = fraction(random);
    const Ray<T> ray{point, rounded<T>({x - 0.5, y - 0.5, z - 0.5})};
    std::size_t crossings = 0;
    bool only_faces = true;
    for (const Triangle<T>& t : triangles_) {
      const TriangleKind kind = oracle::gmp_oracle().answer(ray, t).kind;
      crossings += kind == TriangleKind::face;
      only_faces = only_faces && (kind == TriangleKind::face || kind == TriangleKind::miss);
    }
    if (only_faces) return crossings % 2 == 1;
  }
  return false;
}

template <Real T>
std::size_t MeshRays<T>::count(Target target) const {
  switch (target) {
    case Target::corner:
    case Target::other_corner:
      return corners_.size();
    case Target::edge_midpoint:
    case Target::along_edge:
      return edges_.size();
    case Target::face_center:
      return faces_.size();
  }
  return 0;
}

template <Real T>
auto MeshRays<T>::ends(Target target, std::size_t index) const -> Ends {
  if (target == Target::along_edge) {
    // Either way comes up.
    const Edge& edge = edges_[index];
    return index % 2 == 0 ? Ends{edge.from, edge.to} : Ends{edge.to, edge.from};
  }
  Random random(0, "mesh-pair", index);
  return {corners_[index], corners_[random.below(corners_.size())]};
}

template <Real T>
Ray<T> MeshRays<T>::ray(Target target, std::size_t index) const {
  Vec3<T> goal;
  if (target == Target::other_corner || target == Target::along_edge) {
    const Ends e = ends(target, index);
    return {points_[e.from], difference(points_[e.to], points_[e.from])};
  }
  if (target == Target::corner) {
    goal = points_[corners_[index]];
  } else if (target == Target::edge_midpoint) {
    const Vec3<T>&p = points_[edges_[index].from], &q = points_[edges_[index].to];
    goal = {(p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2};
  } else {
    const Triangle<T>& t = triangles_[index];
    goal = {(t.a.x + t.b.x + t.c.x) / 3, (t.a.y + t.b.y + t.c.y) / 3, (t.a.z + t.b.z + t.c.z) / 3};
  }
  return {origin_, difference(goal, origin_)};
}

template <Real T>
std::span<const std::uint32_t> MeshRays<T>::fan_of(std::uint32_t point) const {
  return {&fan_[fan_start_[point]], fan_start_[point + 1] - fan_start_[point]};
}

template <Real T>
std::vector<std::uint32_t> MeshRays<T>::fan(Target target, std::size_t index) const {
  std::vector<std::uint32_t> faces;
  const auto add = [&](std::span<const std::uint32_t> more) {
    for (const std::uint32_t face : more) faces.push_back(face);
  };
  const bool is_from_corner = target == Target::other_corner || target == Target::along_edge;
  const Ends e = is_from_corner ? ends(target, index) : Ends{0, 0};
  if (is_from_corner && points_[e.from] == points_[e.to]) return {};
  if (target == Target::corner) {
    add(fan_of(corners_[index]));
  } else if (target == Target::edge_midpoint || target == Target::along_edge) {
    add({edges_[index].faces, edges_[index].face_count});
  } else if (target == Target::face_center) {
    add({&faces_[index], 1});
  } else {
    add(fan_of(e.from));
    add(fan_of(e.to));
    // Neighbours have faces in common.
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  }
  return faces;
}

namespace {

template <Real T>
bool tells_hit(const Reply<T>& reply) {
  return reply && is_hit(*reply);
}

/// The triangle from `first` on, of `count`, that the subject finds hit.
template <Real T>
std::optional<std::size_t> find_hit(const MeshRays<T>& rays, const Ray<T>& ray, const Subject& subject, std::size_t first,
                                    std::size_t count) {
  std::vector<Case<T>> inputs;
  for (std::size_t f = first; f < first + count; ++f) inputs.push_back(RayTriangle<T>{ray, rays.triangle(f)});
  std::vector<Reply<T>> found(count);
  subject.answer(std::span<const Case<T>>(inputs), std::span(found));
  const auto hit = std::find_if(found.begin(), found.end(), [](const Reply<T>& reply) { return tells_hit(reply); });
  if (hit == found.end()) return std::nullopt;
  return first + static_cast<std::size_t>(hit - found.begin());
}

/// Whether the subject finds a hit anywhere in the mesh. `likely` is asked first: another mode's hit; and is set to this one's.
template <Real T>
bool meets_any(const MeshRays<T>& rays, const Ray<T>& ray, const Subject& subject, std::optional<std::size_t>& likely) {
  constexpr std::size_t at_once = 4096;
  if (likely && find_hit(rays, ray, subject, *likely, 1)) return true;
  for (std::size_t first = 0; first < rays.size(); first += at_once) {
    likely = find_hit(rays, ray, subject, first, std::min(at_once, rays.size() - first));
    if (likely) return true;
  }
  return false;
}

/// Judges the ray by the replies for the triangles around its target: those from `first` on.
template <Real T>
void judge_mesh_ray(const MeshRays<T>& rays, Target target, std::size_t index, const std::vector<Case<T>>& inputs,
                    const Replies<T>& replies, std::size_t first, const Judges& judges, Part& part) {
  const std::size_t count = rays.fan(target, index).size();
  if (count == 0) return;
  for (std::size_t i = first; i < first + count; ++i) part.input_hash += input_hash(inputs[i], index);
  bool truth_hits = false;
  const auto is_offered = [&](const std::vector<Reply<T>>& of_mode) {
    return of_mode[first] || !of_mode[first].failure().empty();
  };
  if (std::none_of(replies.begin(), replies.end(), is_offered)) return;
  for (std::size_t i = first; i < first + count; ++i) {
    truth_hits |= is_hit(check(judges, inputs[i], replies, i, index, part.tally));
  }
  std::optional<std::size_t> likely;
  for (std::size_t m = 0; m < replies.size(); ++m) {
    ++part.rays;
    const auto from = replies[m].begin() + static_cast<std::ptrdiff_t>(first);
    if (std::any_of(from, from + static_cast<std::ptrdiff_t>(count), [](const auto& reply) { return tells_hit(reply); }))
      continue;
    if (truth_hits || !meets_any(rays, rays.ray(target, index), *judges.subjects[m], likely)) ++part.lost_rays;
  }
}

}  // namespace

template <Real T>
void judge_mesh_rays(const MeshRays<T>& rays, Target target, Range range, const Judges& judges, Part& part) {
  std::vector<Case<T>> inputs;
  for (std::uint64_t i = range.from; i < range.to; ++i) {
    for (const std::uint32_t f : rays.fan(target, i)) inputs.push_back(RayTriangle<T>{rays.ray(target, i), rays.triangle(f)});
  }
  const Replies<T> replies = ask(judges, inputs);
  std::size_t first = 0;
  for (std::uint64_t i = range.from; i < range.to; first += rays.fan(target, i++).size()) {
    judge_mesh_ray(rays, target, i, inputs, replies, first, judges, part);
  }
}

template class MeshRays<float>;
template class MeshRays<double>;
template void judge_mesh_rays(const MeshRays<float>&, Target, Range, const Judges&, Part&);
template void judge_mesh_rays(const MeshRays<double>&, Target, Range, const Judges&, Part&);

}  // namespace graze::fuzz
