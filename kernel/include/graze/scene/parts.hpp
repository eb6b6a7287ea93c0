// What a scene is made of: indexed triangle meshes and arrays of spheres, moved in or viewed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "graze/types.hpp"

namespace graze {

/// Elements that are owned (moved in) or viewed; what is viewed must outlive whoever holds the view, and stay where it is.
template <class Element>
class Array {
 public:
  Array() = default;
  Array(std::vector<Element> owned) : owned_(std::move(owned)), is_view_(false) {}  // NOLINT(google-explicit-constructor)
  Array(std::span<const Element> viewed) : viewed_(viewed), is_view_(true) {}       // NOLINT(google-explicit-constructor)

  [[nodiscard]] std::span<const Element> get() const noexcept { return is_view_ ? viewed_ : std::span<const Element>(owned_); }
  [[nodiscard]] std::size_t size() const noexcept { return get().size(); }
  [[nodiscard]] const Element& operator[](std::size_t i) const noexcept { return get()[i]; }
  /// Bytes that are owned.
  [[nodiscard]] std::size_t memory() const noexcept { return owned_.capacity() * sizeof(Element); }

 private:
  std::vector<Element> owned_;
  std::span<const Element> viewed_;
  bool is_view_ = false;
};

/// Three indices of points: the corners a, b, c.
using Corners = std::array<std::uint32_t, 3>;

template <Real T>
struct Mesh {
  Array<Vec3<T>> points;
  Array<Corners> triangles;
  std::uint32_t mask = ~std::uint32_t(0);  ///< a query whose mask shares no bit with this does not see the part
};

template <Real T>
struct Spheres {
  Array<Sphere<T>> spheres;
  std::uint32_t mask = ~std::uint32_t(0);
};

template <Real T>
using Part = std::variant<Mesh<T>, Spheres<T>>;

/// Why a scene was not built.
enum class BuildError : std::uint8_t {
  none,
  bad_index,        ///< a triangle names a point that its mesh has not got
  non_finite,       ///< a coordinate or a radius is NaN or infinite; a point that no triangle uses may be
  negative_radius,  ///< radius < 0
  open_edge,        ///< asked to be closed: a directed edge occurs more often than its reverse
  too_many,         ///< more than 2^30 primitives
  out_of_memory,
  other_topology,  ///< refit with another number of points or spheres
};

/// The outcome of a build, with the first offender.
struct BuildStatus {
  BuildError error = BuildError::none;
  std::uint32_t part = 0;     ///< which part, from 0
  std::uint32_t element = 0;  ///< which triangle or sphere of the part, from 0
  /// For bad_index and non_finite which corner, for open_edge which edge: 0 from a to b, 1 from b to c, 2 from c to a.
  std::uint32_t corner = 0;

  [[nodiscard]] bool ok() const noexcept { return error == BuildError::none; }
  bool operator==(const BuildStatus&) const = default;
};

}  // namespace graze
