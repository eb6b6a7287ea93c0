# The planted bugs. FIND must stand exactly once in FILE.

graze_mutant(
  flipped_sign
  MODELS "a sign flipped with the wrong facing"
  FILE src/exact/triangle.cpp
  FIND [[negate_if(!flipped, dot(s, r))]]
  REPLACE [[negate_if(flipped, dot(s, r))]])

graze_mutant(
  dropped_bound
  MODELS "t_max forgotten"
  FILE src/exact/range.hpp
  FIND [[has_upper_end && numeric::compare(t, t_max) > 0]]
  REPLACE [[false && numeric::compare(t, t_max) > 0]])

graze_mutant(
  one_minus_u_below_u
  MODELS "the slip of lecture notes, 1 - u < u for 1 - u < v"
  FILE include/graze/predicates/triangle_filter.hpp
  FIND [=[whole_distance[0] - u_v[0] - u_v[1]]=]
  REPLACE [=[whole_distance[0] - u_v[0] - u_v[0]]=])

graze_mutant(
  sign_of_zero_is_zero
  MODELS "B + sgn(B) sqrt(D) with sgn(0) = 0"
  FILE src/numeric/approximation.hpp
  FIND [[const int sign = a.sign == 0 ? 1 : a.sign;]]
  REPLACE [[const int sign = a.sign;]])

# clang does not fuse a product that is needed for itself too, and so does no harm here.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  graze_mutant(
    contraction_on FMA
    MODELS "error-free transforms compiled with contraction"
    FILE src/numeric/double_double.hpp
    FIND [[#if GRAZE_HAS_FMA]]
    REPLACE [[#if 0]]
    OPTIONS "-O2 -mfma -ffp-contract=fast")
endif()

graze_mutant(
  filter_constant
  MODELS "the bound of the discriminant's error too small by 2^4"
  FILE include/graze/predicates/sphere_filter.hpp
  FIND [[= sphere_discriminant_error *]]
  REPLACE [[= W(0x1p-4) * sphere_discriminant_error *]])

# Too small by 2^4 it is caught too, but not soon.
graze_mutant(
  triangle_constant
  MODELS "the bound of a triangle's determinants too small by 2^6"
  FILE include/graze/predicates/triangle_filter.hpp
  FIND [[= triangle_error *]]
  REPLACE [[= W(0x1p-6) * triangle_error *]])

graze_mutant(
  float_unit
  MODELS "the filters in float bounded by a unit that is too small by 2^4"
  FILE include/graze/numeric/filter.hpp
  FIND [[W(0x1p-23)]]
  REPLACE [[W(0x1p-27)]])

graze_mutant(
  implicit_constant
  MODELS "the bound of a plane's error too small by 2^4"
  FILE include/graze/predicates/implicit_filter.hpp
  FIND [[plane_error * numeric]]
  REPLACE [[0x1p-4 * plane_error * numeric]])

graze_mutant(
  slack_too_small
  MODELS "leading bits trusted further than the steps that made them"
  FILE src/numeric/approximation.hpp
  FIND [[std::uint64_t slack = 16;]]
  REPLACE [[std::uint64_t slack = 1;]])

graze_mutant(
  midpoint_off
  MODELS "the midpoint test made at the number below instead"
  FILE src/numeric/rounding.hpp
  FIND [[{2 * kept + 1, unit - 1, a.sign < 0}]]
  REPLACE [[{2 * kept, unit - 1, a.sign < 0}]])

graze_mutant(
  tier_too_narrow
  MODELS "the bits forgotten that differences and sums of products need"
  FILE src/exact/scaled.hpp
  FIND [[input_bits = 64 * K - 4;]]
  REPLACE [[input_bits = 64 * K;]])

graze_mutant(
  denormals_are_zero
  MODELS "validation by comparison of floats, which denormals-are-zero falsifies"
  FILE include/graze/numeric/bits.hpp
  FIND [[return magnitude_bits(x) == 0;]]
  REPLACE [[return x == 0;]])

graze_mutant(
  rounding_mode_ignored
  MODELS "error-free transforms trusted in directed rounding"
  FILE src/numeric/double_double.hpp
  FIND [[return 1.0 + t == 1.0 && 1.0 - t == 1.0;]]
  REPLACE [[return 1.0 + t >= 1.0;]])

graze_mutant(
  negative_zero
  MODELS "a value below zero that rounds to zero answered as -0"
  FILE src/numeric/rounding.hpp
  FIND [[if (shift > 66) return 0;]]
  REPLACE [[if (shift > 66) return a.sign < 0 ? std::uint64_t(1) << (format.exponent_bits + format.precision - 1) : 0;]])

graze_mutant(
  tie_to_odd
  MODELS "ties rounded to odd"
  FILE src/numeric/rounding.hpp
  FIND [[(kept & 1) != 0]]
  REPLACE [[(kept & 1) == 0]])

graze_mutant(
  corners_swapped
  MODELS "a corner given another's name"
  FILE src/exact/triangle.cpp
  FIND [[TriangleKind::vertex_c : c_is_zero ? TriangleKind::vertex_b]]
  REPLACE [[TriangleKind::vertex_b : c_is_zero ? TriangleKind::vertex_c]])

graze_mutant(
  bound_after_rounding
  MODELS "the range compared with t after rounding"
  FILE src/exact/sphere.cpp
  FIND [[const SphereBits bits = answer(input(ray, sphere), numeric::format_of<T>, Wanted::numbers);]]
  REPLACE [[
  const Ray<T> line{ray.origin, ray.direction, -std::numeric_limits<T>::max()};
  SphereBits bits = answer(input(line, sphere), numeric::format_of<T>, Wanted::numbers);
  const auto is_within = [&](int i) {
    const T t = std::bit_cast<T>(static_cast<numeric::Bits<T>>(bits.t[i]));
    return ray.t_min <= t && t <= ray.t_max;
  };
  if (bits.kind == SphereKind::tangent && !is_within(0)) bits = {SphereKind::miss, Root::none, bits.origin};
  if (bits.kind == SphereKind::secant) {
    const bool first = is_within(0), second = is_within(1);
    if (!first && !second) bits = {SphereKind::miss, Root::none, bits.origin};
    else if (!first) bits = {SphereKind::secant, Root::second, bits.origin, {bits.t[1], 0}};
    else if (!second) bits = {SphereKind::secant, Root::first, bits.origin, {bits.t[0], 0}};
  }]])

graze_mutant(
  near_and_far_swapped
  MODELS "the nearer root taken for the farther where B < 0"
  FILE src/rounding/roots.cpp
  FIND [[is_certain = is_negative ? far(hit.t[count++]) : near(hit.t[count++]);]]
  REPLACE [[is_certain = near(hit.t[count++]);]])

graze_mutant(
  status_order
  MODELS "a negative radius told before a zero direction"
  FILE src/exact/validate.hpp
  FIND [[if (numeric::is_zero(ray.direction)) return]]
  REPLACE [[if (numeric::is_zero(ray.direction) && !radius_is_negative) return]])

graze_mutant(
  open_edge
  MODELS "the far corner of a segment left out"
  FILE src/exact/flat.hpp
  FIND [[compare(w, whole) > 0]]
  REPLACE [[compare(w, whole) >= 0]])

graze_mutant(
  low_part_too_large
  MODELS "a double-double divided as if it were normalised"
  FILE src/rounding/roots.cpp
  FIND [[{a, b, normalised(c), discriminant]]
  REPLACE [[{a, b, c, discriminant]])

graze_mutant(
  decision_without_range
  MODELS "a range forgotten where the decision alone is asked for"
  FILE src/exact/interval.hpp
  FIND [[if (range.starts_after(last) || range.ends_before(first)) return {};]]
  REPLACE [[if (rounded && (range.starts_after(last) || range.ends_before(first))) return {};]])

graze_mutant(
  face_error_forgotten
  MODELS "t, u and v of a face in double-double taken for exact"
  FILE src/rounding/face.cpp
  FIND [[pair_relative, pair_quotient_error]]
  REPLACE [[0 * pair_relative, 0]])

graze_mutant(
  face_error_too_small
  MODELS "the bound of a face's numbers too small by 2^16"
  FILE src/rounding/face.cpp
  FIND [[pair_relative, pair_quotient_error]]
  REPLACE [[0x1p-16 * pair_relative, 0x1p-16 * pair_quotient_error]])

graze_mutant(
  subnormal_exponent
  MODELS "the exponent of subnormal numbers off by one: wrong for them alone"
  FILE src/numeric/dyadic.hpp
  FIND [[field - (field != 0) + trailing]]
  REPLACE [[field - 1 + trailing]])

graze_mutant(
  widest_tier_missing
  MODELS "integers too narrow, wrong only where exponents span more than 1,000 bits"
  FILE src/exact/scaled.hpp
  FIND [[operator()<33>()]]
  REPLACE [[operator()<17>()]])

graze_mutant(
  shift_cut_off
  MODELS "a shift cut off at 1,000 bits: wrong only where exponents span more"
  FILE src/numeric/integer.hpp
  FIND [[const int shift = d.exponent - unit;]]
  REPLACE [[const int shift = std::min(d.exponent - unit, 1000);]])

graze_mutant(
  edge_of_one_winding
  MODELS "a shared edge left to the triangle of the other winding, as rasterizers do"
  FILE src/exact/triangle.cpp
  FIND [[if (a.is_negative()) return out;]]
  REPLACE [[if (a.is_negative() || (flipped && a.is_zero() && !b.is_zero() && !c.is_zero())) return out;]])

graze_mutant(
  tie_away_from_zero
  MODELS "ties rounded away from zero: wrong at half of the ties alone"
  FILE src/numeric/rounding.hpp
  FIND [[(side == 0 && (kept & 1) != 0)]]
  REPLACE [[side == 0]])

graze_mutant(
  lattice_of_positions_alone
  MODELS "a triangle's determinants from a direction that is cut to whole steps"
  FILE src/predicates/triangle_in_doubt.cpp
  FIND [[if (!directions.holds_all()) return Meeting::unknown;]]
  REPLACE [[]])

graze_mutant(
  lattice_without_a_corner
  MODELS "a triangle's determinants from a corner that is cut to whole steps"
  FILE src/predicates/triangle_in_doubt.cpp
  FIND [[, positions.include(c);]]
  REPLACE [[;]])

graze_mutant(
  lattice_without_the_center
  MODELS "a discriminant from a center that is cut to whole steps"
  FILE src/predicates/sphere_in_doubt.cpp
  FIND [[positions.include(c), ]]
  REPLACE [[]])

graze_mutant(
  lattice_too_fine
  MODELS "words too short for a lattice of 2^4 times as many steps"
  FILE src/numeric/lattice.hpp
  FIND [[0x1p23]]
  REPLACE [[0x1p19]])
