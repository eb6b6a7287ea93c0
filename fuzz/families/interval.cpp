// interval. Exact cases whose range [t_min, t_max] ends at, one ulp before, one ulp after and between the parameters of the
// hits, with t_min = t_max, and with negative t_min. Pure cases are promised by comparing the ends with the exact t,
// representable or not: both ends belong to the range, and comparing a rounded t with them instead is wrong for every t that is
// not representable.
#include "fuzz/families/drafts.hpp"
#include "fuzz/families/finish.hpp"
#include "fuzz/families/registry.hpp"

namespace graze::fuzz::construct {

namespace {
struct Interval {
  static constexpr std::string_view name = "interval";
  static constexpr std::string_view attacks = "t_min and t_max at, around and between the exact t's";
  static constexpr Note note{"t compared with a bound after it was rounded, or strictly",
                             "a hit at the end of a range is lost, or one beyond it is told",
                             "RayTracing/raytracing.github.io issue 1727: roots at t_min and t_max are rejected"};
  template <Real T>
  static LabelledCase<T> make(Random& random, std::uint64_t index) {
    Draft draft = any_draft(random, digits<T>, is_triangle_index(index));
    for (int again = 0; again < 4 && count_marks(draft) == 0; ++again) {
      draft = any_draft(random, digits<T>, is_triangle_index(index));
    }
    Plan plan;
    plan.range = Range::always;
    plan.is_pure = index % 2 == 0;
    return finish<T>(draft, random, plan);
  }

 private:
  static int count_marks(const Draft& draft) {
    return std::visit([](const auto& any) { return any.promise.marks.count; }, draft);
  }
};
}  // namespace

Family interval_family() {
  return family_of<Interval>();
}

}  // namespace graze::fuzz::construct
