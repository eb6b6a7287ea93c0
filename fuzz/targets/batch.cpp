// Batches against the single query, lane by lane. A disagreement is printed, and ends the program.
//
// The bytes: the first tells the form, the floating-point mode and, by its highest bit, spheres or triangles; the second the
// arrays' offset and how often the lanes are repeated; the third how many bytes a case has, less 4. The rest are cases
// (fuzz/case_bytes.hpp); those of another precision than the first's are left out.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <variant>

#include "fuzz/batch_check.hpp"
#include "fuzz/case_bytes.hpp"

namespace graze::fuzz {
namespace {

template <Real T>
const Sphere<T>& shape_of(const RaySphere<T>& query) {
  return query.sphere;
}
template <Real T>
const Triangle<T>& shape_of(const RayTriangle<T>& query) {
  return query.triangle;
}

struct Header {
  unsigned first, second, third;
};

template <Real T, template <class> class Query, template <class> class Shape>
void check(QueryGroup group, const Header& header, std::span<const std::uint8_t> bytes) {
  constexpr std::size_t most_lanes = 300;
  Batch<T, Shape> cases;
  const std::size_t length = 4 + header.third;
  for (std::size_t at = 0; at < bytes.size() && cases.rays.size() < most_lanes; at += length) {
    const AnyCase decoded = decode_case(group, bytes.subspan(at, std::min(length, bytes.size() - at)));
    const auto* input = std::get_if<Case<T>>(&decoded);
    const auto* query = input == nullptr ? nullptr : std::get_if<Query<T>>(input);
    if (query == nullptr) continue;
    cases.rays.push_back(query->ray);
    cases.shapes.push_back(shape_of(*query));
  }
  const std::size_t n = std::min(cases.rays.size() * (1 + header.second / 16), most_lanes);
  Batch<T, Shape> batch{
      BatchForm(header.first % 3), float_modes[header.first / 3 % float_modes.size()], header.second % 16, {}, {}};
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t k = i % cases.rays.size();
    if (batch.form != BatchForm::one_ray || i == 0) batch.rays.push_back(cases.rays[k]);
    if (batch.form != BatchForm::one_shape || i == 0) batch.shapes.push_back(cases.shapes[k]);
  }
  if (n == 0) return;
  if (const auto fault = find_batch_fault(batch)) {
    std::fprintf(stderr, "The batch is wrong: %s\n", fault->c_str());
    std::abort();
  }
}

}  // namespace
}  // namespace graze::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace graze;
  using namespace graze::fuzz;
  if (size < 4) return 0;
  const Header header{data[0], data[1], data[2]};
  const std::span rest(data + 3, size - 3);
  constexpr unsigned double_bit = 8;
  const bool is_double = (rest[0] & double_bit) != 0, is_sphere = (header.first & 0x80) != 0;
  if (is_sphere && is_double) check<double, RaySphere, Sphere>(QueryGroup::ray_sphere, header, rest);
  if (is_sphere && !is_double) check<float, RaySphere, Sphere>(QueryGroup::ray_sphere, header, rest);
  if (!is_sphere && is_double) check<double, RayTriangle, Triangle>(QueryGroup::ray_triangle, header, rest);
  if (!is_sphere && !is_double) check<float, RayTriangle, Triangle>(QueryGroup::ray_triangle, header, rest);
  return 0;
}
