// Rays from inside a closed mesh at its own corners, edge midpoints and face centers: the rays that kernels lose.
#pragma once

#include <string_view>
#include <vector>

#include "fuzz/certify/check.hpp"
#include "fuzz/certify/row.hpp"
#include "fuzz/mesh/mesh.hpp"

namespace graze::fuzz {

enum class Target { corner, edge_midpoint, face_center };
[[nodiscard]] std::string_view name_of(Target target);

/// A mesh in one precision, an origin inside it, and for each target the triangles around it.
template <Real T>
class MeshRays {
 public:
  /// The origin is drawn by the seed and confirmed inside by exact crossing parity; where none is found in 64 draws, there are
  /// no rays.
  MeshRays(const Mesh& mesh, std::uint64_t seed);

  [[nodiscard]] std::size_t count(Target target) const;
  /// From the origin toward the target, the direction rounded to T as any program would.
  [[nodiscard]] Ray<T> ray(Target target, std::size_t index) const;
  /// The triangles that hold the target.
  [[nodiscard]] std::span<const std::uint32_t> fan(Target target, std::size_t index) const;
  [[nodiscard]] std::size_t size() const { return triangles_.size(); }
  [[nodiscard]] const Triangle<T>& triangle(std::size_t i) const { return triangles_[i]; }

 private:
  struct Edge {
    std::uint32_t from, to;
    std::uint32_t faces[2];
    std::uint32_t face_count;
  };
  [[nodiscard]] bool draw_origin(std::uint64_t seed, std::uint64_t attempt);
  [[nodiscard]] bool is_inside(const Vec3<T>& point, std::uint64_t seed) const;

  std::vector<Vec3<T>> points_;
  std::vector<Triangle<T>> triangles_;
  std::vector<std::uint32_t> corners_;          ///< points that are corners of some triangle
  std::vector<std::uint32_t> fan_start_, fan_;  ///< by point: the triangles around it
  std::vector<std::uint32_t> faces_;            ///< 0, 1, 2, ...
  std::vector<Edge> edges_;
  Vec3<T> origin_{};
};

/// Judges each ray of the range against every triangle around its target, asking the subject for all at once. A ray is lost
/// where the exact answer meets one of them and the subject none; where the rounded ray passes beside them all, the whole mesh
/// is asked.
template <Real T>
void judge_mesh_rays(const MeshRays<T>& rays, Target target, Range range, const Judges& judges, Part& part);

}  // namespace graze::fuzz
