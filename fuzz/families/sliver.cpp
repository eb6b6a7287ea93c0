// sliver. Triangles of aspect 2^+-50: one edge long and one of a unit; both long and a unit apart; the angle at a corner almost
// flat; corners on one line, whose nudged twins are the thinnest triangles there are; and ordinary ones scaled to where the
// products of a normal underflow or overflow. The ray aims at corners, edges and the face as for edge-corner. Normals computed
// from rounded edges point anywhere, and determinants of thin triangles are their own rounding errors.
#include "fuzz/families/constructions.hpp"
#include "fuzz/families/drafts.hpp"
#include "fuzz/families/finish.hpp"
#include "fuzz/families/registry.hpp"

namespace graze::fuzz::construct {

TriangleDraft sliver_draft(Random& random, int digits) {
  const int part_bits = random.between(1, digits / 6);
  const int edge_bits = choose_bits(random, 2, digits - 4 - part_bits);
  const int direction_bits = choose_bits(random, 1, digits - 4);
  const int along_bits = choose_bits(random, 1, digits - 3 - direction_bits);
  Aim aim;
  aim.e1 = choose_vector(random, edge_bits);
  const IntVec tiny = choose_vector(random, random.one_in(2) ? 1 : 2);
  switch (random.below(4)) {
    case 0:
      aim.e2 = tiny;
      break;
    case 1:
      aim.e2 = aim.e1 + tiny;
      break;
    case 2: {  // e1 and e2 nearly opposite or nearly in one direction, of different length
      const int cut = random.between(0, edge_bits / 2);
      aim.e1 = aim.e1 / power_of_two(cut);
      if (is_zero(aim.e1)) aim.e1.x = 1;
      const Int factor = choose_integer(random, cut);
      aim.e2 = factor * aim.e1 + tiny;
      break;
    }
    default:
      aim.e2 = choose_vector(random, edge_bits);
      break;
  }
  aim.point = choose_point(random, part_bits);
  aim.d = choose_vector(random, direction_bits);
  aim.tau = choose_natural(random, along_bits);
  aim.alpha = choose_factor(random, digits - direction_bits);
  return aimed_triangle(aim);
}

namespace {
struct Sliver {
  static constexpr std::string_view name = "sliver";
  static constexpr std::string_view attacks = "aspects of 2^50, corners an ulp off one line, normals that underflow";
  static constexpr Note note{"an absolute bound for the determinant; a normal that is nearly 0",
                             "hits with a t that makes no sense, small triangles lost",
                             "RenderKit/embree issue 387; jbikker/tinybvh pull request 283"};
  template <Real T>
  static LabelledCase<T> make(Random& random, std::uint64_t index) {
    Plan plan;
    if (random.one_in(3)) plan.reach = Reach::products;
    const bool on_a_line = random.one_in(4);
    const TriangleDraft draft = on_a_line ? degenerate_draft(random, digits<T>) : sliver_draft(random, digits<T>);
    return finish<T>(draft, random, index, plan);
  }
};
}  // namespace

Family sliver_family() {
  return family_of<Sliver>();
}

}  // namespace graze::fuzz::construct
