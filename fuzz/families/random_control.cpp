// random. The control: what a test without boundary families would do. Coordinates are uniform in [-1, 1], the direction points
// to a random point. Nothing here is on a boundary; a kernel that is wrong only elsewhere passes this family.
#include "fuzz/families/coordinates.hpp"
#include "fuzz/families/finish.hpp"
#include "fuzz/families/registry.hpp"

namespace graze::fuzz::construct {

namespace {
struct RandomControl {
  static constexpr std::string_view name = "random";
  static constexpr std::string_view attacks = "nothing: uniform numbers, the control";
  static constexpr Note note{"none", "none: what passes here alone has been tested on nothing that is hard",
                             "every kernel measured passes its decisions here, which is why suites of random rays pass"};
  template <Real T>
  static LabelledCase<T> make(Random& random, std::uint64_t index) {
    LabelledCase<T> result;
    if (is_triangle_index(index)) result.input = RayTriangle<T>{};
    const Coordinates<T> all = coordinates(result.input);
    for (std::size_t i = 0; i < all.count; ++i) {
      const Int mantissa = i == all.radius ? choose_natural(random, digits<T>) : choose_integer(random, digits<T>);
      bool exact = true;
      *all.at[i] = scaled<T>(mantissa, -digits<T>, exact);
    }
    Vec3<T>& d = ray_of(result.input)->direction;
    if (is_zero(d.x) && is_zero(d.y) && is_zero(d.z)) d.x = T(1);
    return result;
  }
};
}  // namespace

Family random_family() {
  return family_of<RandomControl>();
}

}  // namespace graze::fuzz::construct
