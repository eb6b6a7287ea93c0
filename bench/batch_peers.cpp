#include "bench/batch_peers.hpp"

#include <cmath>
#include <type_traits>

namespace graze::bench::GRAZE_PEERS {
namespace {

/// Moeller and Trumbore (1997), every test taken.
template <Real T>
inline bool triangle_hit(const Ray<T>& ray, const batch::TriangleArrays<T>& s, std::size_t i) {
  const T ax = s.a.x[i], ay = s.a.y[i], az = s.a.z[i];
  const T e1x = s.b.x[i] - ax, e1y = s.b.y[i] - ay, e1z = s.b.z[i] - az;
  const T e2x = s.c.x[i] - ax, e2y = s.c.y[i] - ay, e2z = s.c.z[i] - az;
  const T tx = ray.origin.x - ax, ty = ray.origin.y - ay, tz = ray.origin.z - az;
  const T dx = ray.direction.x, dy = ray.direction.y, dz = ray.direction.z;
  const T px = dy * e2z - dz * e2y, py = dz * e2x - dx * e2z, pz = dx * e2y - dy * e2x;
  const T inverse = 1 / (e1x * px + e1y * py + e1z * pz);
  const T u = (tx * px + ty * py + tz * pz) * inverse;
  const T qx = ty * e1z - tz * e1y, qy = tz * e1x - tx * e1z, qz = tx * e1y - ty * e1x;
  const T v = (dx * qx + dy * qy + dz * qz) * inverse;
  const T t = (e2x * qx + e2y * qy + e2z * qz) * inverse;
  return (u >= 0) & (v >= 0) & (u + v <= 1) & (t >= ray.t_min) & (t <= ray.t_max);
}

/// The textbook's roots: t = (B -+ sqrt(D)) / A.
template <Real T>
inline bool sphere_hit(const Ray<T>& ray, const batch::SphereArrays<T>& s, std::size_t i) {
  const T lx = s.center.x[i] - ray.origin.x, ly = s.center.y[i] - ray.origin.y, lz = s.center.z[i] - ray.origin.z;
  const T dx = ray.direction.x, dy = ray.direction.y, dz = ray.direction.z;
  const T a = dx * dx + dy * dy + dz * dz, b = dx * lx + dy * ly + dz * lz;
  const T c = lx * lx + ly * ly + lz * lz - s.radius[i] * s.radius[i];
  const T discriminant = b * b - a * c, root = std::sqrt(discriminant);
  const T t1 = (b - root) / a, t2 = (b + root) / a;
  return (discriminant >= 0) & (((t1 >= ray.t_min) & (t1 <= ray.t_max)) | ((t2 >= ray.t_min) & (t2 <= ray.t_max)));
}

/// For 0 <= t without end only: no root is taken.
template <Real T>
inline bool sphere_hit_by_sign(const Ray<T>& ray, const batch::SphereArrays<T>& s, std::size_t i) {
  const T lx = s.center.x[i] - ray.origin.x, ly = s.center.y[i] - ray.origin.y, lz = s.center.z[i] - ray.origin.z;
  const T dx = ray.direction.x, dy = ray.direction.y, dz = ray.direction.z;
  const T a = dx * dx + dy * dy + dz * dz, b = dx * lx + dy * ly + dz * lz;
  const T c = lx * lx + ly * ly + lz * lz - s.radius[i] * s.radius[i];
  return (b * b - a * c >= 0) & ((b >= 0) | (c <= 0));
}

/// Counted in integers as wide as T, which vectors do best.
template <Real T, class Shapes, bool (*hit)(const Ray<T>&, const Shapes&, std::size_t)>
std::size_t count(const Ray<T>& ray, const Shapes& shapes) {
  std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t> n = 0;
  for (std::size_t i = 0; i < shapes.size; ++i) n += hit(ray, shapes, i);
  return static_cast<std::size_t>(n);
}

/// Ten independent chains in vectors as wide as the instruction set's: more than two units take in their latency.
template <class T>
std::size_t operations(std::size_t rounds) {
  typedef T Vector __attribute__((vector_size(GRAZE_PEER_BYTES)));
  Vector a = Vector{} + T(0.999), b = Vector{} + T(0.001);
  Vector x0 = a, x1 = a, x2 = a, x3 = a, x4 = a, x5 = a, x6 = a, x7 = a, x8 = a, x9 = a;
  for (std::size_t i = 0; i < rounds; ++i) {
    x0 = x0 * a + b, x1 = x1 * a + b, x2 = x2 * a + b, x3 = x3 * a + b, x4 = x4 * a + b;
    x5 = x5 * a + b, x6 = x6 * a + b, x7 = x7 * a + b, x8 = x8 * a + b, x9 = x9 * a + b;
    // What each chain is, is hidden, so none is merged with another.
    asm volatile("" : "+v"(x0), "+v"(x1), "+v"(x2), "+v"(x3), "+v"(x4), "+v"(x5), "+v"(x6), "+v"(x7), "+v"(x8), "+v"(x9));
  }
  return rounds * 10 * 2 * (GRAZE_PEER_BYTES / sizeof(T));
}

/// Four vectors a step, their bits combined.
std::size_t read(const float* numbers, std::size_t n) {
  typedef std::uint32_t Vector __attribute__((vector_size(GRAZE_PEER_BYTES), aligned(4), may_alias));
  constexpr std::size_t lanes = GRAZE_PEER_BYTES / 4;
  Vector sum[4] = {};
  for (std::size_t i = 0; i + 4 * lanes <= n; i += 4 * lanes) {
    for (std::size_t k = 0; k < 4; ++k) sum[k] |= *reinterpret_cast<const Vector*>(numbers + i + k * lanes);
  }
  const Vector all = sum[0] | sum[1] | sum[2] | sum[3];
  return all[0];
}

}  // namespace

const PeerSet peers{GRAZE_PEER_NAME,
                    count<float, batch::TriangleArrays<float>, triangle_hit<float>>,
                    count<double, batch::TriangleArrays<double>, triangle_hit<double>>,
                    count<float, batch::SphereArrays<float>, sphere_hit<float>>,
                    count<double, batch::SphereArrays<double>, sphere_hit<double>>,
                    count<float, batch::SphereArrays<float>, sphere_hit_by_sign<float>>,
                    count<double, batch::SphereArrays<double>, sphere_hit_by_sign<double>>,
                    operations<float>,
                    operations<double>,
                    read};

}  // namespace graze::bench::GRAZE_PEERS
