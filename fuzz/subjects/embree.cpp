// Ray and triangle, ray and sphere by Embree 3, as its users ask it: a scene of one primitive, built, and rtcIntersect1. Float
// alone. Triangles with the default flags are Moeller and Trumbore's test, with the robust flag edge functions about the origin
// (Wald, Woop, Benthin, Johnson, Ernst, "Embree: a kernel framework for efficient CPU ray tracing", SIGGRAPH 2014). Spheres are
// its RTC_GEOMETRY_TYPE_SPHERE_POINT. Fails as float arithmetic without exact signs does; in coordinates above 1.8e18, where it
// takes primitives for invalid; where an end of the range is met (t_min < t is demanded); where boxes of tiny primitives are
// missed by rounded slabs. It tells t, u, v and a normal alone: no features, one root. Rays with t_min < 0 or with
// numbers above 1.8e18 are against its rules and are not offered.
#include <embree3/rtcore.h>

#include <cmath>
#include <memory>
#include <mutex>
#include <vector>

#include "fuzz/float_mode.hpp"
#include "fuzz/subjects/embree_ray.hpp"
#include "fuzz/subjects/formula_subject.hpp"
#include "fuzz/subjects/subjects.hpp"

namespace graze::fuzz {
namespace {

/// A scene of one primitive whose numbers are replaced.
class OnePrimitive {
 public:
  OnePrimitive(RTCDevice device, RTCGeometryType type, RTCSceneFlags flags)
      : scene_(rtcNewScene(device)), geometry_(rtcNewGeometry(device, type)) {
    rtcSetSceneFlags(scene_, flags);
    if (type == RTC_GEOMETRY_TYPE_TRIANGLE) {
      numbers_ = buffer(RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, 12, 3);
      auto* index =
          static_cast<unsigned*>(rtcSetNewGeometryBuffer(geometry_, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, 1));
      for (unsigned i = 0; i < 3; ++i) index[i] = i;
    } else {
      numbers_ = buffer(RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, 16, 1);
    }
    rtcCommitGeometry(geometry_);
    rtcAttachGeometry(scene_, geometry_);
  }
  ~OnePrimitive() {
    rtcReleaseGeometry(geometry_);
    rtcReleaseScene(scene_);
  }
  OnePrimitive(const OnePrimitive&) = delete;
  OnePrimitive& operator=(const OnePrimitive&) = delete;

  /// The numbers of the corners, or center and radius.
  [[nodiscard]] float* numbers() { return numbers_; }

  /// Builds the scene anew and asks it.
  [[nodiscard]] RTCRayHit intersect(const Ray<float>& ray) {
    rtcUpdateGeometryBuffer(geometry_, RTC_BUFFER_TYPE_VERTEX, 0);
    rtcCommitGeometry(geometry_);
    rtcCommitScene(scene_);
    RTCRayHit query = embree_ray(ray);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene_, &context, &query);
    return query;
  }

 private:
  float* buffer(RTCBufferType type, RTCFormat format, std::size_t stride, std::size_t count) {
    return static_cast<float*>(rtcSetNewGeometryBuffer(geometry_, type, 0, format, stride, count));
  }

  RTCScene scene_;
  RTCGeometry geometry_;
  float* numbers_ = nullptr;
};

/// One device for all; its builds run in the thread that asks.
RTCDevice device() {
  static const RTCDevice shared = rtcNewDevice("threads=1");
  return shared;
}

/// Scenes that wait for the next question. A thread that waits inside Embree may be given another question to ask, so scenes
/// are lent one by one and not kept by thread.
class Pool {
 public:
  Pool(RTCGeometryType type, RTCSceneFlags flags) : type_(type), flags_(flags) {}

  template <class Ask>
  auto lend(Ask ask) {
    std::unique_ptr<OnePrimitive> scene = take();
    // Embree sets its own modes while it builds: the caller's are put back.
    const auto result = [&] {
      const FloatModeScope scope(FloatMode::nearest);
      return ask(*scene);
    }();
    const std::scoped_lock lock(mutex_);
    waiting_.push_back(std::move(scene));
    return result;
  }

 private:
  std::unique_ptr<OnePrimitive> take() {
    const std::scoped_lock lock(mutex_);
    if (waiting_.empty()) return std::make_unique<OnePrimitive>(device(), type_, flags_);
    std::unique_ptr<OnePrimitive> scene = std::move(waiting_.back());
    waiting_.pop_back();
    return scene;
  }

  RTCGeometryType type_;
  RTCSceneFlags flags_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<OnePrimitive>> waiting_;
};

/// Embree's rules for a ray, which Debian's build asserts.
bool may_be_asked(const Ray<float>& ray) {
  constexpr float largest = 1.844e18f;
  for (const float x : {ray.origin.x, ray.origin.y, ray.origin.z, ray.direction.x, ray.direction.y, ray.direction.z}) {
    if (!(std::abs(x) <= largest)) return false;
  }
  return ray.t_min >= 0 && !std::isnan(ray.t_max);
}

bool is_hit(const RTCRayHit& query) {
  return query.hit.geomID != RTC_INVALID_GEOMETRY_ID;
}

/// Formula of a FormulaSubject but for its name.
template <RTCSceneFlags flags>
struct Embree {
  static constexpr Deviations deviations{{Deviation::coplanar_is_miss, Deviation::degenerate_is_miss, Deviation::hit_or_miss,
                                          Deviation::nearest_root, Deviation::no_root, Deviation::no_origin,
                                          Deviation::no_facing, Deviation::invalid_unhandled}};

  static Reply<float> answer(const RayTriangle<float>& query) {
    if (!may_be_asked(query.ray)) return {};
    // Never taken down: Embree may be gone first when the program ends.
    static Pool& pool = *new Pool(RTC_GEOMETRY_TYPE_TRIANGLE, flags);
    const RTCRayHit found = pool.lend([&](OnePrimitive& scene) {
      float* numbers = scene.numbers();
      for (const Vec3<float>* corner : {&query.triangle.a, &query.triangle.b, &query.triangle.c}) {
        *numbers++ = corner->x;
        *numbers++ = corner->y;
        *numbers++ = corner->z;
      }
      return scene.intersect(query.ray);
    });
    TriangleHit<float> hit;
    if (!is_hit(found)) return Answer<float>(hit);
    hit.kind = TriangleKind::face;
    hit.t = hit.t_end = found.ray.tfar;
    hit.u = found.hit.u;
    hit.v = found.hit.v;
    return Answer<float>(hit);
  }

  static Reply<float> answer(const RaySphere<float>& query) {
    if (!may_be_asked(query.ray)) return {};
    static Pool& pool = *new Pool(RTC_GEOMETRY_TYPE_SPHERE_POINT, flags);
    const RTCRayHit found = pool.lend([&](OnePrimitive& scene) {
      float* numbers = scene.numbers();
      numbers[0] = query.sphere.center.x;
      numbers[1] = query.sphere.center.y;
      numbers[2] = query.sphere.center.z;
      numbers[3] = query.sphere.radius;
      return scene.intersect(query.ray);
    });
    SphereHit<float> hit;
    if (!is_hit(found)) return Answer<float>(hit);
    hit.kind = SphereKind::secant;
    hit.root = Root::first;
    hit.t[0] = found.ray.tfar;
    return Answer<float>(hit);
  }
};

struct EmbreeDefault : Embree<RTC_SCENE_FLAG_NONE> {
  static constexpr std::string_view name = "embree";
  static constexpr std::string_view about = "Embree 3, a scene of one primitive with the default flags, rtcIntersect1";
};

struct EmbreeRobust : Embree<RTC_SCENE_FLAG_ROBUST> {
  static constexpr std::string_view name = "embree-robust";
  static constexpr std::string_view about = "Embree 3, a scene of one primitive with RTC_SCENE_FLAG_ROBUST, rtcIntersect1";
};

}  // namespace

const Subject& embree_subject() {
  static const FormulaSubject<EmbreeDefault> subject;
  return subject;
}

const Subject& embree_robust_subject() {
  static const FormulaSubject<EmbreeRobust> subject;
  return subject;
}

}  // namespace graze::fuzz
