// Embree's scenes, for times and losses beside ours.
#pragma once

#include <embree3/rtcore.h>

#include <atomic>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <vector>

#include "fuzz/mesh/mesh.hpp"
#include "fuzz/subjects/embree_ray.hpp"
#include "graze/types.hpp"

namespace graze::bench {

/// A triangle mesh in Embree, in float.
class EmbreeScene {
 public:
  EmbreeScene(const fuzz::Mesh& mesh, bool is_robust, const char* config = "threads=1") : device_(rtcNewDevice(config)) {
    rtcSetDeviceMemoryMonitorFunction(device_, count_bytes, this);
    scene_ = rtcNewScene(device_);
    if (is_robust) rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* points = static_cast<float*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.points.size()));
    for (const Vec3<double>& p : mesh.points) {
      *points++ = static_cast<float>(p.x);
      *points++ = static_cast<float>(p.y);
      *points++ = static_cast<float>(p.z);
    }
    void* corners = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned),
                                            mesh.triangles.size());
    std::memcpy(corners, mesh.triangles.data(), mesh.triangles.size() * 3 * sizeof(unsigned));
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
  }
  ~EmbreeScene() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;

  /// What Embree holds, its copy of the mesh included, and what it held at most.
  [[nodiscard]] std::size_t memory() const { return static_cast<std::size_t>(bytes_); }
  [[nodiscard]] std::size_t peak_memory() const { return static_cast<std::size_t>(peak_); }

  /// The index of the closest triangle, or RTC_INVALID_GEOMETRY_ID.
  [[nodiscard]] unsigned closest(const Ray<float>& ray) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit query = fuzz::embree_ray(ray);
    rtcIntersect1(scene_, &context, &query);
    return query.hit.geomID == RTC_INVALID_GEOMETRY_ID ? RTC_INVALID_GEOMETRY_ID : query.hit.primID;
  }
  [[nodiscard]] bool any(const Ray<float>& ray) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRay query = fuzz::embree_ray(ray).ray;
    rtcOccluded1(scene_, &context, &query);
    return query.tfar < 0;
  }
  /// All at once; the number of hits.
  [[nodiscard]] std::size_t closest_stream(std::span<const Ray<float>> rays, std::vector<RTCRayHit>& space,
                                           bool is_coherent) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = is_coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    space.resize(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) space[i] = fuzz::embree_ray(rays[i]);
    rtcIntersect1M(scene_, &context, space.data(), static_cast<unsigned>(rays.size()), sizeof(RTCRayHit));
    std::size_t hits = 0;
    for (const RTCRayHit& query : space) hits += query.hit.geomID != RTC_INVALID_GEOMETRY_ID;
    return hits;
  }
  /// Eight at a time; the number of hits.
  [[nodiscard]] std::size_t closest_packets(std::span<const Ray<float>> rays, bool is_coherent) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = is_coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    alignas(32) int valid[8];
    RTCRayHit8 packet;
    std::size_t hits = 0;
    for (std::size_t first = 0; first + 8 <= rays.size(); first += 8) {
      for (int i = 0; i < 8; ++i) {
        const Ray<float>& ray = rays[first + i];
        valid[i] = -1;
        packet.ray.org_x[i] = ray.origin.x;
        packet.ray.org_y[i] = ray.origin.y;
        packet.ray.org_z[i] = ray.origin.z;
        packet.ray.dir_x[i] = ray.direction.x;
        packet.ray.dir_y[i] = ray.direction.y;
        packet.ray.dir_z[i] = ray.direction.z;
        packet.ray.tnear[i] = ray.t_min;
        packet.ray.tfar[i] = ray.t_max;
        packet.ray.time[i] = 0;
        packet.ray.mask[i] = ~0U;
        packet.ray.flags[i] = 0;
        packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
        packet.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
      }
      rtcIntersect8(valid, scene_, &context, &packet);
      for (const unsigned id : packet.hit.geomID) hits += id != RTC_INVALID_GEOMETRY_ID;
    }
    return hits;
  }

 private:
  static bool count_bytes(void* self, ssize_t bytes, bool) {
    auto& scene = *static_cast<EmbreeScene*>(self);
    const std::int64_t now = scene.bytes_ += bytes;
    std::int64_t peak = scene.peak_;
    while (peak < now && !scene.peak_.compare_exchange_weak(peak, now)) {
    }
    return true;
  }

  std::atomic<std::int64_t> bytes_{0}, peak_{0};
  RTCDevice device_;
  RTCScene scene_;
};

}  // namespace graze::bench
