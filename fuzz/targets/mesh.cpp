// The reader of meshes: the first byte tells the format, modulo four, the rest is the file. It is refused with a printable
// reason that names it, or it is a mesh: finite points, indices in range, the same again from a file written of it.
#include "fuzz/mesh/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "fuzz/case_text.hpp"

namespace graze::fuzz {
namespace {

const std::string name = "fuzzed";

[[noreturn]] void fail(const std::string& what) {
  std::fprintf(stderr, "# The mesh reader is wrong: %s\n", what.c_str());
  std::abort();
}

void check_error(const std::string& what) {
  const bool is_printable = std::all_of(what.begin(), what.end(), [](char c) { return c >= ' ' && c <= '~'; });
  if (!what.starts_with(name + ":") || !is_printable) fail("an error that names no file or cannot be printed: " + what);
}

std::string as_off(const Mesh& mesh) {
  std::string text = "OFF\n" + std::to_string(mesh.points.size()) + " " + std::to_string(mesh.triangles.size()) + " 0\n";
  const auto number = [](double x) { return format_number(x, NumberForm::shortest); };
  for (const auto& p : mesh.points) text += number(p.x) + " " + number(p.y) + " " + number(p.z) + "\n";
  for (const auto& t : mesh.triangles) {
    text += "3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) + "\n";
  }
  return text;
}

void check_mesh(const Mesh& mesh) {
  const auto is_finite = [](const Vec3<double>& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); };
  if (!std::all_of(mesh.points.begin(), mesh.points.end(), is_finite)) fail("a point that is not finite");
  for (const auto& t : mesh.triangles) {
    if (*std::max_element(t.begin(), t.end()) >= mesh.points.size()) fail("an index out of range");
  }
  for (const OpenEdge& edge : open_edges(mesh)) {
    if (std::max(edge.from, edge.to) >= mesh.points.size()) fail("an open edge of no point");
  }
  const auto again = parse_mesh(as_off(mesh), MeshFormat::off, name);
  const auto* same = std::get_if<Mesh>(&again);
  if (same == nullptr) fail("refuses what was written of it: " + std::get<MeshError>(again).what);
  if (same->points != mesh.points || same->triangles != mesh.triangles) fail("reads another mesh from what was written of it");
}

}  // namespace
}  // namespace graze::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace graze::fuzz;
  if (size == 0) return 0;
  const std::string bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  const auto mesh = parse_mesh(bytes, static_cast<MeshFormat>(data[0] % 4), name);
  if (const auto* error = std::get_if<MeshError>(&mesh)) {
    check_error(error->what);
  } else {
    check_mesh(std::get<Mesh>(mesh));
  }
  return 0;
}
