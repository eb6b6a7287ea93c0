// Mesh files: which format, and what every format must hold.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <optional>

#include "fuzz/mesh/soup.hpp"

namespace graze::fuzz {
namespace {

std::optional<MeshFormat> format_of(const std::string& file) {
  std::string ending = std::filesystem::path(file).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  if (ending == ".off") return MeshFormat::off;
  if (ending == ".obj") return MeshFormat::obj;
  if (ending == ".ply") return MeshFormat::ply;
  if (ending == ".stl") return MeshFormat::stl;
  return std::nullopt;
}

Soup parse(std::string_view bytes, MeshFormat format) {
  Soup soup;
  switch (format) {
    case MeshFormat::off:
      parse_off(bytes, soup);
      break;
    case MeshFormat::obj:
      parse_obj(bytes, soup);
      break;
    case MeshFormat::ply:
      parse_ply(bytes, soup);
      break;
    case MeshFormat::stl:
      parse_stl(bytes, soup);
      break;
  }
  return soup;
}

/// The fans of the polygons; throws MeshError.
std::vector<std::array<std::uint32_t, 3>> triangles_of(const Soup& soup) {
  const std::size_t points = soup.points.size();
  if (points > std::numeric_limits<std::uint32_t>::max()) throw MeshError{" has more than 4,294,967,295 points"};
  if (soup.polygons.empty()) throw MeshError{" holds no faces"};
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::size_t i = 0; i < soup.polygons.size(); ++i) {
    const std::vector<std::int64_t>& polygon = soup.polygons[i];
    if (polygon.size() < 3) {
      throw MeshError{" face " + std::to_string(i) + " has " + std::to_string(polygon.size()) +
                      " corners, three are the least"};
    }
    for (const std::int64_t corner : polygon) {
      if (corner < 0 || static_cast<std::uint64_t>(corner) >= points) {
        throw MeshError{" face " + std::to_string(i) + " names point " + std::to_string(corner) + ", there are " +
                        std::to_string(points) + ", from 0"};
      }
    }
    for (std::size_t k = 2; k < polygon.size(); ++k) {
      triangles.push_back({static_cast<std::uint32_t>(polygon[0]), static_cast<std::uint32_t>(polygon[k - 1]),
                           static_cast<std::uint32_t>(polygon[k])});
    }
  }
  return triangles;
}

}  // namespace

std::variant<Mesh, MeshError> parse_mesh(std::string_view bytes, MeshFormat format, const std::string& file) {
  try {
    Soup soup = parse(bytes, format);
    auto triangles = triangles_of(soup);
    return Mesh{std::filesystem::path(file).filename().string(), std::move(soup.points), std::move(triangles)};
  } catch (const MeshError& error) {
    return MeshError{file + ":" + error.what};
  }
}

std::variant<Mesh, MeshError> read_mesh(const std::string& file) {
  namespace fs = std::filesystem;
  std::error_code code;
  if (!fs::exists(file, code)) return MeshError{file + ": no such file"};
  if (fs::is_directory(file, code)) return MeshError{file + ": is a folder, a mesh file is wanted"};
  const auto format = format_of(file);
  if (!format) return MeshError{file + ": its ending tells no format; .off, .obj, .ply and .stl are known"};
  std::ifstream in(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  if (!in) return MeshError{file + ": cannot be read; check its permissions"};
  return parse_mesh(bytes, *format, file);
}

}  // namespace graze::fuzz
