// What a scene is built from, what it refuses, and what it says of itself.
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "fuzz/mesh/mesh.hpp"
#include "graze/scene.hpp"
#include "tests/catch.hpp"
#include "tests/support/formats.hpp"

namespace graze::test {
namespace {

template <Real T>
std::vector<Vec3<T>> square() {
  return {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
}
const std::vector<Corners> halves{{0, 1, 2}, {0, 2, 3}};

template <Real T>
BuildStatus status_of(std::vector<Part<T>> parts, bool is_closed = false) {
  Scene<T> scene;
  return scene.build(std::move(parts), {is_closed, Threads::all});
}

TEST_CASE("An invalid part is refused by its place") {
  in_both_formats([]<Real T>() {
    constexpr T infinity = std::numeric_limits<T>::infinity();
    const Mesh<T> good{square<T>(), halves};
    CHECK(status_of<T>({good}).ok());
    CHECK(status_of<T>({good, Mesh<T>{square<T>(), std::vector<Corners>{{0, 1, 2}, {0, 4, 1}}}}) ==
          BuildStatus{BuildError::bad_index, 1, 1, 1});
    std::vector<Vec3<T>> points = square<T>();
    points[3].y = std::numeric_limits<T>::quiet_NaN();
    CHECK(status_of<T>({Mesh<T>{points, halves}}) == BuildStatus{BuildError::non_finite, 0, 1, 2});
    CHECK(status_of<T>({Mesh<T>{points, std::vector<Corners>{{0, 1, 2}}}}).ok());
    CHECK(status_of<T>({good, Spheres<T>{std::vector<Sphere<T>>{{{0, 0, 0}, 1}, {{0, infinity, 0}, 1}}}}) ==
          BuildStatus{BuildError::non_finite, 1, 1, 0});
    CHECK(status_of<T>({Spheres<T>{std::vector<Sphere<T>>{{{0, 0, 0}, infinity}}}}) ==
          BuildStatus{BuildError::non_finite, 0, 0, 0});
    CHECK(status_of<T>({Spheres<T>{std::vector<Sphere<T>>{{{0, 0, 0}, -std::numeric_limits<T>::denorm_min()}}}}) ==
          BuildStatus{BuildError::negative_radius, 0, 0, 0});
    CHECK(status_of<T>({Spheres<T>{std::vector<Sphere<T>>{{{0, 0, 0}, -T(0)}}}}).ok());
  });
}

TEST_CASE("Of many faults in a long part the first is told, however many threads look") {
  in_both_formats([]<Real T>() {
    constexpr std::uint32_t size = 100'000;
    std::vector<Vec3<T>> points = square<T>();
    points.push_back({0, -std::numeric_limits<T>::infinity(), 0});
    points.push_back({0, 0, std::numeric_limits<T>::quiet_NaN()});
    const auto status = [&](std::vector<std::pair<std::uint32_t, Corners>> faults) {
      std::vector<Corners> triangles(size, Corners{0, 1, 2});
      for (const auto& [at, corners] : faults) triangles[at] = corners;
      return status_of<T>({Mesh<T>{points, std::move(triangles)}});
    };
    CHECK(status({}).ok());
    CHECK(status({{99'999, {0, 1, 4}}, {70'000, {0, 6, 1}}}) == BuildStatus{BuildError::bad_index, 0, 70'000, 1});
    CHECK(status({{99'999, {0, 6, 1}}, {70'000, {0, 1, 4}}}) == BuildStatus{BuildError::non_finite, 0, 70'000, 2});
    // Both in one thread's share, and both in one triangle.
    CHECK(status({{11, {0, 1, 6}}, {10, {5, 4, 1}}}) == BuildStatus{BuildError::non_finite, 0, 10, 0});
    CHECK(status({{11, {4, 1, 0}}, {10, {0, 1, 6}}}) == BuildStatus{BuildError::bad_index, 0, 10, 2});
    CHECK(status({{50'000, {0, 5, 6}}}) == BuildStatus{BuildError::non_finite, 0, 50'000, 1});
    CHECK(status({{50'000, {0, 6, 5}}}) == BuildStatus{BuildError::bad_index, 0, 50'000, 1});
  });
}

TEST_CASE("A build that fails leaves the scene as it was") {
  Scene<double> scene;
  REQUIRE(scene.build({Mesh<double>{square<double>(), halves}}).ok());
  CHECK(!scene.build({Mesh<double>{square<double>(), std::vector<Corners>{{9, 9, 9}}}}).ok());
  CHECK(scene.size() == 2);
  CHECK(scene.count({{0.25, 0.5, 1}, {0, 0, -1}}) == 1);
}

TEST_CASE("An open edge is named") {
  in_both_formats([]<Real T>() {
    const std::vector<Vec3<T>> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const std::vector<Corners> closed{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
    CHECK(status_of<T>({Mesh<T>{points, closed}}, true).ok());
    for (std::size_t turned = 0; turned < 4; ++turned) {
      std::vector<Corners> corners = closed;
      std::swap(corners[turned][0], corners[turned][1]);
      CHECK(status_of<T>({Mesh<T>{points, corners}}, true).error == BuildError::open_edge);
      CHECK(status_of<T>({Mesh<T>{points, corners}}).ok());
    }
    std::vector<Corners> open = closed;
    open.pop_back();
    const BuildStatus status = status_of<T>({Mesh<T>{points, open}}, true);
    REQUIRE(status.error == BuildError::open_edge);
    // The edge and not its reverse: an edge of the triangle that is missing, the other way round.
    const auto from = open[status.element][status.corner], to = open[status.element][(status.corner + 1) % 3];
    CHECK((std::pair(from, to) == std::pair(3U, 0U) || std::pair(from, to) == std::pair(2U, 3U) ||
           std::pair(from, to) == std::pair(0U, 2U)));
    // The same points under other indices, and -0 for 0; a part for each triangle.
    std::vector<Part<T>> parts;
    for (const Corners& t : closed) {
      std::vector<Vec3<T>> own{points[t[0]], points[t[1]], points[t[2]]};
      own[1].x = own[1].x == 0 ? -T(0) : own[1].x;
      parts.push_back(Mesh<T>{own, std::vector<Corners>{{0, 1, 2}}});
    }
    CHECK(status_of<T>(parts, true).ok());
    parts.push_back(Spheres<T>{std::vector<Sphere<T>>{{{5, 5, 5}, 1}}});
    parts.push_back(Mesh<T>{points, std::vector<Corners>{{0, 0, 1}}});
    CHECK(status_of<T>(parts, true).ok());
  });
}

TEST_CASE("A scene of nothing misses") {
  in_both_formats([]<Real T>() {
    Scene<T> scene;
    const Ray<T> ray{{0, 0, 0}, {1, 0, 0}};
    for (int i = 0; i < 2; ++i) {
      CHECK(!scene.closest(ray).is_hit());
      CHECK(scene.closest(ray).status == Status::ok);
      CHECK(!scene.any(ray));
      CHECK(scene.count(ray) == 0);
      CHECK(scene.all(ray).empty());
      CHECK(scene.ties(ray).empty());
      CHECK(scene.size() == 0);
      CHECK(scene.bounds() == Bounds<T>{});
      REQUIRE(scene.build({Mesh<T>{}, Spheres<T>{}}, {true, Threads::all}).ok());
    }
    CHECK(scene.inside({0, 0, 0}) == Place::outside);
  });
}

TEST_CASE("Viewed arrays are read in place, and only owned ones are counted") {
  std::vector<Vec3<double>> points;
  std::vector<Corners> triangles;
  for (std::uint32_t i = 0; i < 1000; ++i) {
    const double x = i;
    points.insert(points.end(), {{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}});
    triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  Scene<double> viewing, owning;
  REQUIRE(viewing.build({Mesh<double>{std::span<const Vec3<double>>(points), std::span<const Corners>(triangles)}}).ok());
  REQUIRE(owning.build({Mesh<double>{points, triangles}}).ok());
  CHECK(owning.memory() == viewing.memory() + points.size() * sizeof(points[0]) + triangles.size() * sizeof(triangles[0]));
  CHECK(viewing.memory() > 1000 * sizeof(Triangle<double>));
  CHECK(viewing.memory() < 1000 * 2.5 * sizeof(Triangle<double>));
}

TEST_CASE("A mesh of doubles takes little more than one of floats: its leaves hold each point once") {
  const fuzz::Mesh mesh = fuzz::icosphere(5);
  const auto n = static_cast<double>(mesh.triangles.size());
  std::vector<Vec3<float>> narrow;
  std::vector<Vec3<double>> soup;
  for (const Vec3<double>& p : mesh.points) {
    narrow.push_back({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
  }
  std::vector<Corners> apart;
  for (const Corners& t : mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(soup.size());
    for (const std::uint32_t c : t) soup.push_back(mesh.points[c]);
    apart.push_back({first, first + 1, first + 2});
  }
  Scene<float> floats;
  Scene<double> doubles, of_soup;
  REQUIRE(floats.build({Mesh<float>{std::span<const Vec3<float>>(narrow), std::span<const Corners>(mesh.triangles)}}).ok());
  REQUIRE(
      doubles.build({Mesh<double>{std::span<const Vec3<double>>(mesh.points), std::span<const Corners>(mesh.triangles)}}).ok());
  REQUIRE(of_soup.build({Mesh<double>{std::span<const Vec3<double>>(soup), std::span<const Corners>(apart)}}).ok());
  const auto bytes = [n](const auto& scene) { return static_cast<double>(scene.memory()) / n; };
  CAPTURE(bytes(floats), bytes(doubles), bytes(of_soup));
  CHECK(bytes(doubles) < 1.25 * bytes(floats));
  CHECK(bytes(doubles) < 60);
  CHECK(of_soup.memory() == doubles.memory());
}

TEST_CASE("The bounds hold everything, triangles exactly") {
  in_both_formats([]<Real T>() {
    Scene<T> scene;
    REQUIRE(scene.build({Mesh<T>{square<T>(), halves}}).ok());
    CHECK(scene.bounds() == Bounds<T>{{0, 0, 0}, {1, 1, 0}});
    REQUIRE(scene.build({Mesh<T>{square<T>(), halves}, Spheres<T>{std::vector<Sphere<T>>{{{1, 2, 3}, T(0.7)}}}}).ok());
    const Bounds<T> bounds = scene.bounds();
    CHECK(bounds.low == Vec3<T>{0, 0, 0});
    CHECK(bounds.high.z > T(3.7));
    CHECK(bounds.high.z < T(3.700001));
    constexpr T most = std::numeric_limits<T>::max();
    REQUIRE(scene.build({Spheres<T>{std::vector<Sphere<T>>{{{most, 0, 0}, most}}}}).ok());
    CHECK(std::isinf(scene.bounds().high.x));
    CHECK(scene.bounds().low.x <= 0);
  });
}

}  // namespace
}  // namespace graze::test
