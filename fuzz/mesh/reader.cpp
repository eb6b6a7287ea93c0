// Mesh files through CGAL's readers.
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "fuzz/mesh/mesh.hpp"

namespace graze::fuzz {
namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;

bool is_finite(const Point& p) {
  return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
}

}  // namespace

std::variant<Mesh, MeshError> read_mesh(const std::string& file) {
  namespace fs = std::filesystem;
  std::error_code code;
  if (!fs::exists(file, code)) return MeshError{file + ": no such file"};
  if (fs::is_directory(file, code)) return MeshError{file + ": is a folder, a mesh file is wanted"};
  if (!std::ifstream(file)) return MeshError{file + ": cannot be read; check its permissions"};

  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> polygons;
  bool is_read = false;
  try {
    is_read = CGAL::IO::read_polygon_soup(file, points, polygons);
  } catch (const std::exception&) {
    is_read = false;
  }
  if (!is_read)
    return MeshError{file + ": is not a mesh that can be read; OFF, OBJ, PLY and STL are known, by the file's ending"};
  if (polygons.empty()) return MeshError{file + ": holds no faces"};

  Mesh mesh;
  mesh.name = fs::path(file).filename().string();
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!is_finite(points[i])) return MeshError{file + ": point " + std::to_string(i) + " has a coordinate that is not finite"};
    mesh.points.push_back({points[i].x(), points[i].y(), points[i].z()});
  }
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    const std::vector<std::size_t>& polygon = polygons[i];
    for (const std::size_t corner : polygon) {
      if (corner >= points.size()) {
        return MeshError{file + ": face " + std::to_string(i) + " names point " + std::to_string(corner) + ", there are " +
                         std::to_string(points.size())};
      }
    }
    for (std::size_t k = 2; k < polygon.size(); ++k) {
      mesh.triangles.push_back({static_cast<std::uint32_t>(polygon[0]), static_cast<std::uint32_t>(polygon[k - 1]),
                                static_cast<std::uint32_t>(polygon[k])});
    }
  }
  return mesh;
}

}  // namespace graze::fuzz
