// Each claim is put in both formats.
#pragma once

#include "graze/types.hpp"
#include "tests/catch.hpp"

namespace graze::test {

/// Runs test.operator()<T>() for both formats T.
template <class Test>
void in_both_formats(Test test) {
  {
    INFO("float");
    test.template operator()<float>();
  }
  {
    INFO("double");
    test.template operator()<double>();
  }
}

}  // namespace graze::test
