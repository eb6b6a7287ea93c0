#include "cli/scene_files.hpp"

#include <cmath>

#include "cli/line_source.hpp"
#include "fuzz/case_text.hpp"
#include "fuzz/mesh/mesh.hpp"

namespace graze::cli {
namespace {

/// `cx cy cz r` a line.
template <Real T>
std::string load_spheres(const std::string& file, std::vector<Sphere<T>>& spheres) {
  constexpr fuzz::NumbersText text{"a sphere", "cx cy cz r", false};
  LineSource lines(file);
  while (lines.error().empty() && lines.next()) {
    if (fuzz::is_skipped(lines.line())) continue;
    Sphere<T> s;
    T* const numbers[] = {&s.center.x, &s.center.y, &s.center.z, &s.radius};
    if (const auto error = fuzz::parse_numbers<T>(text, lines.line(), numbers)) return lines.place() + ": " + error->what;
    for (const T* number : numbers) {
      if (!std::isfinite(*number)) return lines.place() + ": a number of the sphere is not finite";
    }
    if (s.radius < 0) return lines.place() + ": the sphere's radius is negative";
    spheres.push_back(s);
  }
  return lines.error();
}

template <Real T>
std::string load_mesh(const std::string& file, Mesh<T>& mesh) {
  auto read = fuzz::read_mesh(file);
  if (const auto* error = std::get_if<fuzz::MeshError>(&read)) return error->what;
  auto& found = std::get<fuzz::Mesh>(read);
  if constexpr (std::same_as<T, double>) {
    mesh.points = std::move(found.points);
  } else {
    std::vector<Vec3<T>> points;
    points.reserve(found.points.size());
    for (std::size_t i = 0; i < found.points.size(); ++i) {
      const Vec3<double>& p = found.points[i];
      points.push_back({static_cast<T>(p.x), static_cast<T>(p.y), static_cast<T>(p.z)});
      const Vec3<T>& q = points.back();
      if (!std::isfinite(q.x) || !std::isfinite(q.y) || !std::isfinite(q.z)) {
        return file + ": point " + std::to_string(i) + " has a coordinate that is too large for float";
      }
    }
    mesh.points = std::move(points);
  }
  mesh.triangles = std::move(found.triangles);
  return {};
}

std::string formatted(double x) {
  return fuzz::format_number(x, fuzz::NumberForm::shortest);
}

/// Why the parts make no scene. What a mesh or a sphere may hold has been told before.
template <Real T>
std::string told(const std::vector<std::string>& files, const std::vector<Part<T>>& parts, const BuildStatus& status) {
  if (status.error == BuildError::too_many) return "graze: more than 2^30 primitives";
  if (status.error == BuildError::out_of_memory) return "graze: there is not enough memory for the scene";
  const auto& mesh = std::get<Mesh<T>>(parts[status.part]);
  const Corners& corners = mesh.triangles[status.element];
  const auto point = [&](std::uint32_t c) {
    const Vec3<T>& p = mesh.points[corners[c % 3]];
    return "(" + formatted(p.x) + " " + formatted(p.y) + " " + formatted(p.z) + ")";
  };
  return files[status.part] + ": is not closed: triangle " + std::to_string(status.element) + " has an edge from " +
         point(status.corner) + " to " + point(status.corner + 1) + " that occurs more often than its reverse";
}

}  // namespace

template <Real T>
std::string load_parts(const std::vector<std::string>& files, std::vector<Part<T>>& parts) {
  for (const std::string& file : files) {
    if (file.ends_with(".spheres")) {
      std::vector<Sphere<T>> spheres;
      if (const std::string wrong = load_spheres(file, spheres); !wrong.empty()) return wrong;
      parts.push_back(Spheres<T>{std::move(spheres)});
    } else {
      Mesh<T> mesh;
      if (const std::string wrong = load_mesh(file, mesh); !wrong.empty()) return wrong;
      parts.push_back(std::move(mesh));
    }
  }
  return {};
}

template <Real T>
std::string load_scene(const std::vector<std::string>& files, bool is_closed, Scene<T>& scene) {
  std::vector<Part<T>> parts;
  if (const std::string wrong = load_parts(files, parts); !wrong.empty()) return wrong;
  const BuildStatus status = scene.build(parts, {is_closed, Threads::all});
  return status.ok() ? std::string() : told(files, parts, status);
}

template <Real T>
std::string view_scene(const std::vector<std::string>& files, const std::vector<Part<T>>& parts, Scene<T>& scene) {
  std::vector<Part<T>> views;
  for (const Part<T>& part : parts) {
    if (const auto* mesh = std::get_if<Mesh<T>>(&part)) {
      views.push_back(Mesh<T>{mesh->points.get(), mesh->triangles.get(), mesh->mask});
    } else {
      const auto& spheres = std::get<Spheres<T>>(part);
      views.push_back(Spheres<T>{spheres.spheres.get(), spheres.mask});
    }
  }
  const BuildStatus status = scene.build(std::move(views));
  return status.ok() ? std::string() : told(files, parts, status);
}

template std::string load_parts(const std::vector<std::string>&, std::vector<Part<float>>&);
template std::string load_parts(const std::vector<std::string>&, std::vector<Part<double>>&);
template std::string view_scene(const std::vector<std::string>&, const std::vector<Part<float>>&, Scene<float>&);
template std::string view_scene(const std::vector<std::string>&, const std::vector<Part<double>>&, Scene<double>&);
template std::string load_scene(const std::vector<std::string>&, bool, Scene<float>&);
template std::string load_scene(const std::vector<std::string>&, bool, Scene<double>&);

}  // namespace graze::cli
