// Every call that the kernel offers for a case.
#pragma once

#include "fuzz/case.hpp"

namespace graze::fuzz {

template <Real T>
struct KernelAnswer {
  Answer<T> answer;   ///< of `intersect` or `side`
  bool hits = false;  ///< of `hits`; false for a point
};

/// Compiled apart from the declaration, so that a program may be linked with another kernel behind it.
[[nodiscard]] KernelAnswer<float> kernel_answer(const Case<float>& input);
[[nodiscard]] KernelAnswer<double> kernel_answer(const Case<double>& input);

}  // namespace graze::fuzz
