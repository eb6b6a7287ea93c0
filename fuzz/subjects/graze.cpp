// The kernel itself under test.
#include "fuzz/subjects/formula_subject.hpp"
#include "fuzz/subjects/subjects.hpp"
#include "graze/implicit.hpp"
#include "graze/sphere.hpp"
#include "graze/triangle.hpp"

namespace graze::fuzz {
namespace {

struct Kernel {
  static constexpr std::string_view name = "graze";
  static constexpr std::string_view about = "this library: exact decisions, correctly rounded numbers";

  template <Real T>
  static SphereHit<T> answer(const RaySphere<T>& query) {
    return intersect(query.ray, query.sphere);
  }
  template <Real T>
  static TriangleHit<T> answer(const RayTriangle<T>& query) {
    return intersect(query.ray, query.triangle);
  }
  template <Real T>
  static Side answer(const PointLine<T>& query) {
    return side(query.point, query.line);
  }
  template <Real T>
  static Side answer(const PointPlane<T>& query) {
    return side(query.point, query.plane);
  }
  template <Real T>
  static Side answer(const PointSphere<T>& query) {
    return side(query.point, query.sphere);
  }
};

}  // namespace

const Subject& graze_subject() {
  static const FormulaSubject<Kernel> subject;
  return subject;
}

}  // namespace graze::fuzz
