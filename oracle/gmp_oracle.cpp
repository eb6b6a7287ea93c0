#include "oracle/gmp_queries.hpp"

namespace graze::oracle {

const Oracle& gmp_oracle() {
  static const Adapter<gmp::Queries> oracle;
  return oracle;
}

}  // namespace graze::oracle
