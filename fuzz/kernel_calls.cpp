#include "fuzz/kernel_calls.hpp"

#include "graze/implicit.hpp"
#include "graze/sphere.hpp"
#include "graze/triangle.hpp"

namespace graze::fuzz {
namespace {

template <Real T>
KernelAnswer<T> answer(const Case<T>& input) {
  return std::visit(
      [](const auto& query) -> KernelAnswer<T> {
        if constexpr (requires { query.ray, query.sphere; }) {
          return {intersect(query.ray, query.sphere), hits(query.ray, query.sphere)};
        } else if constexpr (requires { query.triangle; }) {
          return {intersect(query.ray, query.triangle), hits(query.ray, query.triangle)};
        } else if constexpr (requires { query.line; }) {
          return {side(query.point, query.line)};
        } else if constexpr (requires { query.plane; }) {
          return {side(query.point, query.plane)};
        } else {
          return {side(query.point, query.sphere)};
        }
      },
      input);
}

}  // namespace

KernelAnswer<float> kernel_answer(const Case<float>& input) {
  return answer(input);
}
KernelAnswer<double> kernel_answer(const Case<double>& input) {
  return answer(input);
}

}  // namespace graze::fuzz
