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

/// Runs test.operator()<W, T>() for each filter: in the precision W, of inputs in the format T.
template <class Test>
void in_each_filter(Test test) {
  {
    INFO("float, in float");
    test.template operator()<float, float>();
  }
  {
    INFO("float, in double");
    test.template operator()<double, float>();
  }
  {
    INFO("double");
    test.template operator()<double, double>();
  }
}

}  // namespace graze::test
