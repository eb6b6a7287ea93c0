// The steps from a draft to a case.
#include "fuzz/families/finish.hpp"

#include <algorithm>

#include "fuzz/families/bounds.hpp"

namespace graze::fuzz::construct {

namespace {

/// Lattice to format, noting whether every coordinate is representable.
template <Real T>
struct Converter {
  Scale scale;
  bool exact = true;

  Vec3<T> vector(const IntVec& v, const std::array<int, 3>& exponents) {
    Vec3<T> result;
    result.x = scaled<T>(v.x, exponents[0], exact);
    result.y = scaled<T>(v.y, exponents[1], exact);
    result.z = scaled<T>(v.z, exponents[2], exact);
    return result;
  }
  Vec3<T> position(const IntVec& v) { return vector(v, scale.position); }
  Ray<T> ray(const IntVec& origin, const IntVec& direction) {
    Ray<T> result;
    result.origin = position(origin);
    result.direction = vector(direction, scale.direction);
    return result;
  }
  RaySphere<T> convert(const SphereDraft& draft) {
    RaySphere<T> result;
    result.ray = ray(draft.origin, draft.direction);
    result.sphere.center = position(draft.center);
    result.sphere.radius = scaled<T>(draft.radius, scale.length, exact);
    return result;
  }
  RayTriangle<T> convert(const TriangleDraft& draft) {
    RayTriangle<T> result;
    result.ray = ray(draft.origin, draft.direction);
    result.triangle = {position(draft.corner[0]), position(draft.corner[1]), position(draft.corner[2])};
    return result;
  }
};

template <Real T>
bool is_default_range(const Ray<T>& ray) {
  return is_zero(ray.t_min) && !is_finite(ray.t_max);
}

/// The signs of t - t_min and of t_max - t.
template <Real T>
int from_start(const Ray<T>& ray, const Mark& mark, int exponent) {
  return -compare(ray.t_min, mark, exponent);
}
template <Real T>
int to_end(const Ray<T>& ray, const Mark& mark, int exponent) {
  return is_finite(ray.t_max) ? compare(ray.t_max, mark, exponent) : 1;
}

/// Whether one of the marks lies in the range; for an interval, whether it meets the range.
template <Real T>
bool meets(const Ray<T>& ray, const Marks& marks, int exponent, bool is_interval) {
  bool some_in = false, some_at_start = false, some_at_end = false;
  for (int i = 0; i < marks.count; ++i) {
    const Mark& mark = marks.at[static_cast<std::size_t>(i)];
    const bool started = from_start(ray, mark, exponent) >= 0;
    const bool not_ended = to_end(ray, mark, exponent) >= 0;
    some_in |= started && not_ended;
    some_at_start |= started;
    some_at_end |= not_ended;
  }
  return is_interval ? some_at_start && some_at_end : some_in;
}

/// What the promise says of this ray's range.
template <Real T, class Kind>
std::optional<Kind> kind_in_range(const Promise<Kind>& promise, const Ray<T>& ray, int exponent, bool is_interval) {
  if (promise.forward_only) return is_default_range(ray) ? promise.kind : std::nullopt;
  if (!promise.kind || promise.kind == Kind::miss) return promise.kind;
  return meets(ray, promise.marks, exponent, is_interval) ? promise.kind : Kind::miss;
}

template <Real T>
Label label_of(const SphereDraft& draft, const Ray<T>& ray, const Scale& scale) {
  const bool is_distorted =
      scale.position[0] != scale.length || scale.position[1] != scale.length || scale.position[2] != scale.length;
  Label label;
  if (!is_distorted) label.sphere = kind_in_range(draft.promise, ray, scale.t, false);
  return label;
}
template <Real T>
Label label_of(const TriangleDraft& draft, const Ray<T>& ray, const Scale& scale) {
  const bool is_interval = draft.promise.kind == TriangleKind::coplanar || draft.promise.kind == TriangleKind::degenerate;
  Label label;
  label.triangle = kind_in_range(draft.promise, ray, scale.t, is_interval);
  return label;
}

template <Real T, class AnyDraft>
LabelledCase<T> finish_draft(AnyDraft draft, Random& random, const Plan& plan) {
  apply_symmetry(draft, random);
  if constexpr (std::same_as<AnyDraft, TriangleDraft>) permute_corners(draft, random);
  const bool is_shared = plan.shared_position_bits != 0;
  if (plan.translate && random.one_in(2)) {
    apply_translation(draft, random, is_shared ? plan.shared_position_bits : position_bits(draft), digits<T>);
  }

  ScaleRequest request;
  request.position_bits = is_shared ? std::max(plan.shared_position_bits, digits<T>) + 1 : position_bits(draft);
  request.direction_bits = bit_length(draft.direction);
  request.reach = plan.reach;
  request.one_scale = plan.one_scale;
  request.mixed_axes = plan.mixed_axes;
  request.t_exponent = plan.t_exponent;
  Converter<T> converter{choose_scale<T>(random, request)};
  auto made = converter.convert(draft);

  const bool has_range = plan.range == Range::always || (plan.range == Range::sometimes && random.one_in(8));
  if (has_range) {
    const Marks& marks = draft.promise.marks;
    choose_bounds(made.ray, marks.count != 0 ? guesses<T>(marks, converter.scale.t) : guesses(made), random);
  }

  LabelledCase<T> result;
  if (plan.is_pure && converter.exact) result.label = label_of(draft, made.ray, converter.scale);
  result.input = made;
  if (random.one_in(8)) flip_zeros(result.input, random);
  if (!plan.is_pure) nudge(result.input, random, plan.nudged);
  return result;
}

}  // namespace

template <Real T>
LabelledCase<T> finish(const Draft& draft, Random& random, const Plan& plan) {
  if (const auto* sphere = std::get_if<SphereDraft>(&draft)) return finish_draft<T>(*sphere, random, plan);
  return finish_draft<T>(std::get<TriangleDraft>(draft), random, plan);
}

template LabelledCase<float> finish<float>(const Draft&, Random&, const Plan&);
template LabelledCase<double> finish<double>(const Draft&, Random&, const Plan&);

}  // namespace graze::fuzz::construct
