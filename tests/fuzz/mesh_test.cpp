// Mesh files: the same tetrahedron from every format, and every refusal with its place.
#include "fuzz/mesh/mesh.hpp"

#include <bit>
#include <cstring>
#include <limits>

#include "tests/catch.hpp"

using namespace graze;
using namespace graze::fuzz;

namespace {

const std::vector<Vec3<double>> points{{0, 0, 0}, {1.5, 0, 0}, {0, 0.25, 0}, {0, 0, -2}};
const std::vector<std::array<std::uint32_t, 3>> triangles{{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
const std::string corners = "0 0 0\n1.5 0 0\n0 .25 0\n0 0 -2e0\n";
const std::string faces = "3 0 1 2\n3 0 3 1\n3 0 2 3\n3 1 3 2\n";

void check_tetrahedron(const std::string& bytes, MeshFormat format) {
  const auto read = parse_mesh(bytes, format, "folder/a.mesh");
  if (const auto* error = std::get_if<MeshError>(&read)) FAIL(error->what);
  const Mesh& mesh = std::get<Mesh>(read);
  CHECK(mesh.name == "a.mesh");
  CHECK(mesh.points == points);
  CHECK(mesh.triangles == triangles);
  CHECK(open_edges(mesh).empty());
}

std::string error(const std::string& bytes, MeshFormat format) {
  const auto read = parse_mesh(bytes, format, "f");
  return std::holds_alternative<Mesh>(read) ? "" : std::get<MeshError>(read).what;
}

template <class Number>
void append(std::string& bytes, Number x, std::endian order = std::endian::little) {
  char raw[sizeof x];
  std::memcpy(raw, &x, sizeof x);
  for (std::size_t i = 0; i < sizeof x; ++i) bytes += raw[order == std::endian::native ? i : sizeof x - 1 - i];
}

const std::string ply_elements =
    "comment element vertex 7\nelement vertex 4\nproperty float x\nproperty float y\nproperty uchar red\nproperty double z\n"
    "element strip 1\nproperty list ushort char steps\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n";

std::string binary_ply(std::endian order) {
  std::string bytes = "ply\nformat binary_" + std::string(order == std::endian::little ? "little" : "big") + "_endian 1.0\n";
  bytes += ply_elements;
  for (const auto& p : points) {
    append(bytes, static_cast<float>(p.x), order);
    append(bytes, static_cast<float>(p.y), order);
    append(bytes, std::uint8_t{200}, order);
    append(bytes, p.z, order);
  }
  append(bytes, std::uint16_t{2}, order);
  bytes += "ab";
  for (const auto& t : triangles) {
    append(bytes, std::uint8_t{3}, order);
    for (const std::uint32_t i : t) append(bytes, i, order);
  }
  return bytes;
}

std::string binary_stl(const std::vector<std::array<Vec3<double>, 3>>& facets, std::string header = "") {
  header.resize(80, ' ');
  append(header, static_cast<std::uint32_t>(facets.size()));
  for (const auto& facet : facets) {
    for (int k = 0; k < 3; ++k) append(header, 0.0F);
    for (const auto& p : facet) {
      for (const double x : {p.x, p.y, p.z}) append(header, static_cast<float>(x));
    }
    append(header, std::uint16_t{0});
  }
  return header;
}

std::vector<std::array<Vec3<double>, 3>> facets() {
  std::vector<std::array<Vec3<double>, 3>> list;
  for (const auto& t : triangles) list.push_back({points[t[0]], points[t[1]], points[t[2]]});
  // The order in which corners first come is that of the points.
  return list;
}

}  // namespace

TEST_CASE("a tetrahedron is the same from every format") {
  check_tetrahedron("OFF\n4 4 6\n" + corners + faces, MeshFormat::off);
  check_tetrahedron("# c\nOFF 4 4 6 # c\n\n" + corners + "\r\n" + faces, MeshFormat::off);
  check_tetrahedron("COFF\n4 4 6\n0 0 0 1 2 3\n1.5 0 0 1 2 3\n0 .25 0 1 2 3\n0 0 -2 1 2 3\n" + faces, MeshFormat::off);
  check_tetrahedron("o x\nv 0 0 0\nv 1.5 0 0\nv 0 .25 0\nvn 0 0 1\nv 0 0 -2 1\nf 1 2/7 3//8\nf 1 4 2\nf -4 -2 -1\nf 2 4 3\n",
                    MeshFormat::obj);
  check_tetrahedron("ply\nformat ascii 1.0\n" + ply_elements + "0 0 9 0\n1.5 0 9 0\n0 .25 9 0\n0 0 9 -2\n2 1 1\n" + faces,
                    MeshFormat::ply);
  check_tetrahedron(binary_ply(std::endian::little), MeshFormat::ply);
  check_tetrahedron(binary_ply(std::endian::big), MeshFormat::ply);
  check_tetrahedron(binary_stl(facets()), MeshFormat::stl);
  check_tetrahedron(binary_stl(facets(), "solid in spite of that"), MeshFormat::stl);
  std::string text = "solid facet of a name\n";
  for (const auto& t : triangles) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const std::uint32_t i : t) {
      text += "vertex " + std::to_string(points[i].x) + " " + std::to_string(points[i].y) + " " + std::to_string(points[i].z) +
              "\n";
    }
    text += "endloop\nendfacet\n";
  }
  check_tetrahedron(text + "endsolid\n", MeshFormat::stl);
}

TEST_CASE("a polygon is a fan from its first corner") {
  const auto read = parse_mesh("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 2 3 4 1\n", MeshFormat::obj, "f");
  CHECK(std::get<Mesh>(read).triangles == std::vector<std::array<std::uint32_t, 3>>{{1, 2, 3}, {1, 3, 0}});
}

TEST_CASE("what is no mesh is refused with its place") {
  using enum MeshFormat;
  CHECK(error("", off) == "f:0: the file ends too early");
  CHECK(error("OFF\n2 1 0\n0 0 0\n0 x 0\n", off) == "f:4: a number is wanted where 'x' stands");
  CHECK(error("OFF\n2 1 0\n0 0 0\n0 0\n", off) == "f:4: a number is wanted where '' stands");
  CHECK(error("OFF\n1 1 0\n0 0 1e999\n", off) == "f:3: a coordinate that is not finite");
  CHECK(error("OFF\n1 1 0\nnan 0 0\n", off) == "f:3: a coordinate that is not finite");
  CHECK(error("OFF\n1 -1 0\n", off) == "f:2: a count below zero");
  CHECK(error("OFF\n1 1.5 0\n", off) == "f:2: an integer is wanted where '1.5' stands");
  CHECK(error("OFF\n99999999999 1 0\n0 0 0\n", off) == "f:3: the file ends before point 1");
  CHECK(error("OFF\n1 1 0\n0 0 0\n4000000000 0 0\n", off) == "f:4: an integer is wanted where '' stands");
  CHECK(error("OFF BINARY\n", off) == "f:1: binary OFF is not known");
  CHECK(error("4OFF\n", off) == "f:1: only OFF of three dimensions is known");
  CHECK(error("OFF\n1 1 0\n0 0 0\n3 0 0 1\n", off) == "f: face 0 names point 1, there are 1, from 0");
  CHECK(error("OFF\n1 1 0\n0 0 0\n2 0 0\n", off) == "f: face 0 has 2 corners, three are the least");
  CHECK(error("OFF\n1 0 0\n0 0 0\n", off) == "f: holds no faces");
  CHECK(error("v 0 0 0\nf 1 0 1\n", obj) == "f:2: point 0, where the first is 1");
  CHECK(error("v 0 0 0\nf 1 -2 1\n", obj) == "f: face 0 names point -1, there are 1, from 0");
  CHECK(error("v 0 0 0\nf 1 \xff 1\n", obj) == "f:2: an integer is wanted where '?' stands");
  CHECK(error("stl", stl) == "f: is neither text that starts with 'solid' nor long enough to be binary");
  CHECK(error("solid\nfacet normal 0 0 1\nvertex 0 0 0\nvertex 1 0 0\nendfacet\n", stl) == "f:5: a facet of 2 corners");
  CHECK(error("solid\nfacet normal 0 0 1\nvertex 0 0 0\n", stl) == "f:3: the file ends too early");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(error(binary_stl({{{{1, 0, 0}, {0, 0, 0}, {nan, 0, 0}}}}), stl) == "f: facet 0 has a coordinate that is not finite");
  std::string cut = binary_stl(facets());
  cut.pop_back();
  CHECK(error(cut, stl) == "f: the file ends in facet 3 of 4");
  const std::string ply_head = "ply\nformat ascii 1.0\n";
  CHECK(error("plx\n", ply) == "f:1: a PLY file starts with 'ply'");
  CHECK(error(ply_head, ply) == "f:2: the file ends in its header");
  CHECK(error("ply\nformat utf8 1.0\n", ply) == "f:2: an unknown format");
  CHECK(error(ply_head + "element vertex 9\nend_header\n", ply) == "f:4: an element without properties");
  CHECK(error(ply_head + "element vertex 1\nproperty float x\nend_header\n0\n", ply) ==
        "f:5: the element vertex wants the properties x, y and z");
  CHECK(error(ply_head + "element face 1\nproperty list uchar half vertex_index\nend_header\n", ply) ==
        "f:4: an unknown type of number");
  std::string ply_cut = binary_ply(std::endian::little);
  ply_cut.pop_back();
  CHECK(error(ply_cut, ply) == "f: face 3 is cut off by the end of the file");
}
