// Rays from inside a closed mesh at its own corners, edge midpoints and face centers, from corner to corner and along its
// edges: the rays that kernels lose.
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "fuzz/certify/check.hpp"
#include "fuzz/certify/row.hpp"
#include "fuzz/mesh/mesh.hpp"

namespace graze::fuzz {

enum class Target {
  corner,         ///< from inside
  edge_midpoint,  ///< from inside
  face_center,    ///< from inside
  other_corner,   ///< from each corner to another, which the index draws
  along_edge,     ///< from one end of each edge to the other
};
inline constexpr std::array targets{Target::corner, Target::edge_midpoint, Target::face_center, Target::other_corner,
                                    Target::along_edge};
[[nodiscard]] std::string_view name_of(Target target);

/// A mesh in one precision, an origin inside it, and for each target the triangles around it.
template <Real T>
class MeshRays {
 public:
  /// The origin is drawn by the seed and confirmed inside by exact crossing parity; where none is found in 64 draws, there are
  /// no rays.
  MeshRays(const Mesh& mesh, std::uint64_t seed);

  [[nodiscard]] std::size_t count(Target target) const;
  /// From its origin toward the target, the direction rounded to T as any program would; zero where both are the same point.
  [[nodiscard]] Ray<T> ray(Target target, std::size_t index) const;
  /// The triangles that hold the target; from corner to corner also those that hold the origin. None
  /// where both ends of the ray are the same point.
  [[nodiscard]] std::vector<std::uint32_t> fan(Target target, std::size_t index) const;
  [[nodiscard]] std::size_t size() const { return triangles_.size(); }
  [[nodiscard]] const Triangle<T>& triangle(std::size_t i) const { return triangles_[i]; }

 private:
  struct Edge {
    std::uint32_t from, to;
    std::uint32_t faces[2];
    std::uint32_t face_count;
  };
  struct Ends {
    std::uint32_t from, to;
  };
  /// The points of a ray from corner to corner.
  [[nodiscard]] Ends ends(Target target, std::size_t index) const;
  [[nodiscard]] std::span<const std::uint32_t> fan_of(std::uint32_t point) const;
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
