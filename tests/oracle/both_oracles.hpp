// Each claim is put to both oracles, in both precisions.
#pragma once

#include <cmath>

#include "oracle/oracle.hpp"
#include "tests/catch.hpp"
#include "tests/support/answers.hpp"

namespace graze::oracle {

using namespace test;

/// Runs test.operator()<T>(oracle) for both formats T and both oracles.
template <class Test>
void everywhere(Test test) {
  for (const Oracle* oracle : {&gmp_oracle(), &cgal_oracle()}) {
    CAPTURE(oracle->name());
    {
      INFO("float");
      test.template operator()<float>(*oracle);
    }
    {
      INFO("double");
      test.template operator()<double>(*oracle);
    }
  }
}

}  // namespace graze::oracle
