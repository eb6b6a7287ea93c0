// What batches are measured against: inexact decisions of one ray against arrays, as the compiler makes them, and the machine's
// peaks. batch_peers.cpp is compiled once for each instruction set; GRAZE_PEERS is its namespace.
#pragma once

#include <cstddef>
#include <cstdint>

#include "graze/batch.hpp"

namespace graze::bench {

/// What a lane of one ray against arrays takes in the filters of batch/*-inl.hpp: a multiply-add is two operations,
/// comparisons, signs and bits none.
inline constexpr double batch_triangle_operations = 60, batch_sphere_operations = 19;

/// How many of the shapes one ray hits, by a branch-free formula: what vectors do best.
template <Real T, class Shapes>
using Count = std::size_t (*)(const Ray<T>&, const Shapes&);

/// Peers and peaks of one instruction set.
struct PeerSet {
  const char* name;
  Count<float, batch::TriangleArrays<float>> float_triangles;
  Count<double, batch::TriangleArrays<double>> double_triangles;
  Count<float, batch::SphereArrays<float>> float_spheres;
  Count<double, batch::SphereArrays<double>> double_spheres;
  /// The same by the sign of the discriminant alone, without a root or division.
  Count<float, batch::SphereArrays<float>> float_spheres_by_sign;
  Count<double, batch::SphereArrays<double>> double_spheres_by_sign;
  /// Runs multiply-adds of whole vectors; returns how many operations of one lane that were, two for a multiply-add.
  std::size_t (*float_operations)(std::size_t rounds);
  std::size_t (*double_operations)(std::size_t rounds);
  /// Reads n floats; returns the sum's low bits.
  std::size_t (*read)(const float* numbers, std::size_t n);
};

namespace peers_v3 {
extern const PeerSet peers;
}
namespace peers_v4 {
extern const PeerSet peers;
}
namespace peers_v4_256 {
extern const PeerSet peers;
}

}  // namespace graze::bench
