// Triangle meshes as the checker needs them: points, triangles, and where they came from.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "graze/types.hpp"

namespace graze::fuzz {

struct Mesh {
  std::string name;  ///< the file's name without folders, or the generator's
  std::vector<Vec3<double>> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// What is wrong with a file: a sentence that names it, and the element where there is one.
struct MeshError {
  std::string what;
};

enum class MeshFormat { off, obj, ply, stl };

/// Reads a mesh from the bytes of a file; `file` is for its name and for messages. A polygon is a fan of triangles from its
/// first corner; of what else the formats know (normals, colors, textures) nothing is kept. Refused, with line or element:
/// numbers that are not finite, indices out of range, faces of less than three corners, and files that end too early. Takes
/// time and memory in proportion to the bytes, whatever they claim.
[[nodiscard]] std::variant<Mesh, MeshError> parse_mesh(std::string_view bytes, MeshFormat format, const std::string& file);

/// The same from a file, in the format that its ending tells: .off, .obj, .ply, .stl.
[[nodiscard]] std::variant<Mesh, MeshError> read_mesh(const std::string& file);

/// A directed edge without its reverse, as indices of points; none where the mesh is closed: every directed edge occurs as
/// often as its reverse. Points are the same where their coordinates are.
struct OpenEdge {
  std::uint32_t from, to;
};
[[nodiscard]] std::vector<OpenEdge> open_edges(const Mesh& mesh);

/// An icosahedron refined `levels` times, its points on the unit sphere: closed, 20 * 4^levels triangles.
[[nodiscard]] Mesh icosphere(int levels);

/// The icosphere with each point moved along its radius by a fixed wave: closed, not convex.
[[nodiscard]] Mesh wavy_sphere(int levels);

}  // namespace graze::fuzz
