// pythagorean-tangent. w = (a, b, c) with a^2 + b^2 + c^2 = h^2, d any vector orthogonal to w: the line from e = c - s w - j d
// touches the sphere of radius s h at c - s w. Other than for quaternion tangents, A = d.d is no square and d is as
// crooked as the mantissa allows.
#include "fuzz/families/constructions.hpp"
#include "fuzz/families/drafts.hpp"
#include "fuzz/families/finish.hpp"
#include "fuzz/families/registry.hpp"

namespace graze::fuzz::construct {

SphereDraft pythagorean_tangent_draft(Random& random, int digits) {
  const int quaternion_bits = choose_bits(random, 1, (digits - 7) / 2);
  const Frame frame = choose_frame(random, quaternion_bits);
  const Int common = content(frame.r1);  // divides the length, for |w| is a rational number and the root of an integer
  const IntVec w = frame.r1 / common;
  const Int h = frame.length / common;

  const int most_bits = digits - 4 - bit_length(w);
  const int orthogonal_bits = choose_bits(random, 1, most_bits);
  const IntVec d = choose_orthogonal(random, w, orthogonal_bits);
  const int along_bits = choose_bits(random, 1, digits - 2 - bit_length(d));
  const Int j = choose_way(random, along_bits);
  const int size_bits = choose_bits(random, 1, digits - 3 - bit_length(w));
  const Int s = choose_nonzero(random, size_bits);
  const Int alpha = choose_factor(random, digits - bit_length(d));

  SphereDraft draft;
  draft.direction = alpha * d;
  draft.center = j * d + s * w;
  draft.radius = magnitude(s) * h;
  draft.promise = {SphereKind::tangent, one_mark(make_mark(j, alpha))};
  return draft;
}

namespace {
struct PythagoreanTangent {
  static constexpr std::string_view name = "pythagorean-tangent";
  static constexpr std::string_view attacks = "discriminant exactly 0 where A is not a square";
  static constexpr Note note{"as for quaternion-tangent, with a root of A that is not an integer",
                             "a touching ray is lost, or two roots are told where there is one",
                             "aardvark-platform/aardvark.base issue 127: exact tangencies rejected"};
  template <Real T>
  static LabelledCase<T> make(Random& random, std::uint64_t index) {
    return finish<T>(pythagorean_tangent_draft(random, digits<T>), random, index);
  }
};
}  // namespace

Family pythagorean_tangent_family() {
  return family_of<PythagoreanTangent>();
}

}  // namespace graze::fuzz::construct
