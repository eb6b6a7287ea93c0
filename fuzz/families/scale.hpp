// Powers of two that a draft is multiplied by: positions and directions separately, to the ends of the exponent range.
#pragma once

#include <array>
#include <optional>

#include "fuzz/families/float_bits.hpp"
#include "fuzz/random.hpp"

namespace graze::fuzz::construct {

/// How far the exponents go.
enum class Reach {
  usual,       ///< often 0, mostly modest, now and then extreme
  directions,  ///< directions extreme, positions usual
  products,    ///< where squares, cubes and fourth powers leave the range
  everything,  ///< anything, with a liking for both ends
};

/// What a draft allows and its family asks for.
struct ScaleRequest {
  int position_bits = 0, direction_bits = 0;
  Reach reach = Reach::usual;
  bool one_scale = false;           ///< positions and directions share their exponents
  bool mixed_axes = false;          ///< each axis has exponents of its own
  std::optional<int> t_exponent{};  ///< t is 2^this times its lattice value, as near as the range allows
};

/// A lattice coordinate n along an axis becomes n * 2^position[axis], n * 2^direction[axis] in the direction, n * 2^length
/// as a radius; a mark is multiplied by 2^t.
struct Scale {
  std::array<int, 3> position{}, direction{};
  int length = 0, t = 0;
};

template <Real T>
[[nodiscard]] Scale choose_scale(Random& random, const ScaleRequest& request);

}  // namespace graze::fuzz::construct
