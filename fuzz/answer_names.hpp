// The words of the contract for the kinds and features of an answer.
#pragma once

#include <string_view>

#include "graze/answer.hpp"

namespace graze::fuzz {

[[nodiscard]] constexpr std::string_view name_of(Status status) {
  switch (status) {
    case Status::ok:
      return "ok";
    case Status::non_finite:
      return "non_finite";
    case Status::zero_direction:
      return "zero_direction";
    case Status::negative_radius:
      return "negative_radius";
    case Status::empty_range:
      return "empty_range";
  }
  return "unknown";
}

[[nodiscard]] constexpr std::string_view name_of(SphereKind kind) {
  switch (kind) {
    case SphereKind::invalid:
      return "invalid";
    case SphereKind::miss:
      return "miss";
    case SphereKind::tangent:
      return "tangent";
    case SphereKind::secant:
      return "secant";
  }
  return "unknown";
}

[[nodiscard]] constexpr std::string_view name_of(TriangleKind kind) {
  switch (kind) {
    case TriangleKind::invalid:
      return "invalid";
    case TriangleKind::miss:
      return "miss";
    case TriangleKind::face:
      return "face";
    case TriangleKind::edge_ab:
      return "edge_ab";
    case TriangleKind::edge_bc:
      return "edge_bc";
    case TriangleKind::edge_ca:
      return "edge_ca";
    case TriangleKind::vertex_a:
      return "vertex_a";
    case TriangleKind::vertex_b:
      return "vertex_b";
    case TriangleKind::vertex_c:
      return "vertex_c";
    case TriangleKind::coplanar:
      return "coplanar";
    case TriangleKind::degenerate:
      return "degenerate";
  }
  return "unknown";
}

[[nodiscard]] constexpr std::string_view name_of(Root root) {
  switch (root) {
    case Root::none:
      return "none";
    case Root::first:
      return "first";
    case Root::second:
      return "second";
    case Root::both:
      return "both";
  }
  return "unknown";
}

[[nodiscard]] constexpr std::string_view name_of(OriginSide side) {
  switch (side) {
    case OriginSide::inside:
      return "inside";
    case OriginSide::on:
      return "on";
    case OriginSide::outside:
      return "outside";
  }
  return "unknown";
}

[[nodiscard]] constexpr std::string_view name_of(Facing facing) {
  switch (facing) {
    case Facing::none:
      return "none";
    case Facing::front:
      return "front";
    case Facing::back:
      return "back";
  }
  return "unknown";
}

/// For a line or a plane: the sign of f.
[[nodiscard]] constexpr std::string_view name_of(Sign sign) {
  return sign == Sign::negative ? "negative" : sign == Sign::positive ? "positive" : "on";
}

/// For a sphere: where the point lies.
[[nodiscard]] constexpr std::string_view name_about_sphere(Sign sign) {
  return sign == Sign::negative ? "inside" : sign == Sign::positive ? "outside" : "on";
}

}  // namespace graze::fuzz
