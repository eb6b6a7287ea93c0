// a-extreme. Any exact case with its direction times 2^k, down to the least subnormal and up to the largest numbers. The
// geometry is the same, but A = d.d and the determinants with d under- or overflow, and with them every test that a
// textbook kernel makes; t overflows or becomes subnormal where the shape is near or far.
#include "fuzz/families/drafts.hpp"
#include "fuzz/families/finish.hpp"
#include "fuzz/families/registry.hpp"

namespace graze::fuzz::construct {

namespace {
struct AExtreme {
  static constexpr std::string_view name = "a-extreme";
  static constexpr std::string_view attacks = "d.d under- or overflows";
  static constexpr Note note{
      "d.d out of range for directions that are not normalised", "every hit lost, or NaN answered",
      "aardvark-platform/aardvark.base issue 127: overflow and underflow of coefficients turn hits into misses"};
  template <Real T>
  static LabelledCase<T> make(Random& random, std::uint64_t index) {
    Plan plan;
    plan.reach = Reach::directions;
    return finish<T>(any_draft(random, digits<T>, is_triangle_index(index)), random, index, plan);
  }
};
}  // namespace

Family a_extreme_family() {
  return family_of<AExtreme>();
}

}  // namespace graze::fuzz::construct
