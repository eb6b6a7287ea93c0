#include "cli/second_kernel.hpp"

#include "fuzz/case_text.hpp"
#include "fuzz/certify/comparison.hpp"
#include "graze/sphere.hpp"
#include "graze/triangle.hpp"

namespace graze::cli {
namespace {

/// Cases asked at once.
constexpr std::size_t most_cases = 16384;

/// The first value of a hit; none of a miss.
template <Real T>
std::optional<T> first_value(const fuzz::Answer<T>& answer) {
  if (const auto* sphere = std::get_if<SphereHit<T>>(&answer)) {
    if (sphere->kind == SphereKind::miss || sphere->kind == SphereKind::invalid) return {};
    return sphere->t[0];
  }
  const auto& triangle = std::get<TriangleHit<T>>(answer);
  if (triangle.kind == TriangleKind::miss || triangle.kind == TriangleKind::invalid) return {};
  return triangle.t;
}

template <Real T>
fuzz::Answer<T> exact_answer(const fuzz::Case<T>& input) {
  return std::visit(
      [](const auto& query) -> fuzz::Answer<T> {
        if constexpr (requires { query.triangle; }) {
          return intersect(query.ray, query.triangle);
        } else if constexpr (requires { query.ray; }) {
          return intersect(query.ray, query.sphere);
        } else {
          return {};
        }
      },
      input);
}

template <Real T>
bool share_corner(const Triangle<T>& s, const Triangle<T>& t) {
  const Vec3<T> corners[] = {t.a, t.b, t.c};
  const auto has = [&](const Vec3<T>& p) { return std::find(std::begin(corners), std::end(corners), p) != std::end(corners); };
  return has(s.a) || has(s.b) || has(s.c);
}
bool share_corner(const auto&, const auto&) {
  return false;
}

}  // namespace

template <Real T>
SecondKernel<T>::SecondKernel(const fuzz::Subject& kernel, const Primitives<T>& primitives, const Camera& camera)
    : kernel_(kernel), primitives_(primitives) {
  seen_.reserve(primitives.size());
  for (std::uint32_t i = 0; i < primitives.size(); ++i) {
    const Bounds<double> box = primitives.with(i, [](const auto& shape) { return bounds_of(shape); });
    Rectangle r{camera.width(), camera.height(), -1, -1};
    for (int c = 0; c < 8; ++c) {
      const auto spot = camera.spot_of(corner(box, c));
      // Before the eye in part: anywhere.
      if (!spot) r = {0, 0, camera.width() - 1, camera.height() - 1};
      if (!spot) break;
      const auto pixel = [](double at, int size) { return static_cast<int>(std::clamp(std::floor(at), 0.0, size - 1.0)); };
      r.left = std::min(r.left, pixel(spot->x - 1, camera.width()));
      r.right = std::max(r.right, pixel(spot->x + 1, camera.width()));
      r.top = std::min(r.top, pixel(spot->y - 1, camera.height()));
      r.bottom = std::max(r.bottom, pixel(spot->y + 1, camera.height()));
    }
    seen_.push_back(r);
  }
}

template <Real T>
void SecondKernel<T>::judge_row(int y, std::span<const Ray<T>> rays, std::span<const std::vector<SceneHit<T>>> ties,
                                std::span<Finding> findings) {
  row_.assign(rays.size(), {});
  for (std::uint32_t i = 0; i < seen_.size(); ++i) {
    const Rectangle& r = seen_[i];
    if (y < r.top || y > r.bottom) continue;
    for (int x = r.left; x <= r.right; ++x) {
      const auto at = static_cast<std::size_t>(x);
      if (Scene<T>::status_of(rays[at]) != Status::ok) continue;
      questions_.push_back({x, i});
      cases_.push_back(primitives_.with(i, [&](const auto& shape) { return case_of(rays[at], shape); }));
      if (cases_.size() == most_cases) ask();
    }
  }
  ask();
  for (std::size_t x = 0; x < rays.size(); ++x) findings[x] = finding(row_[x], rays[x], ties[x]);
}

template <Real T>
void SecondKernel<T>::ask() {
  std::vector<fuzz::Reply<T>> replies(cases_.size());
  kernel_.answer(std::span<const fuzz::Case<T>>(cases_), std::span<fuzz::Reply<T>>(replies));
  for (std::size_t i = 0; i < replies.size(); ++i) {
    const auto& [x, index] = questions_[i];
    const fuzz::Reply<T>& reply = replies[i];
    Pixel& pixel = row_[static_cast<std::size_t>(x)];
    if (!reply) {
      if (reply.failure().empty()) not_offered_ = fuzz::query_name(cases_[i]);
      pixel.has_failed = true;
      continue;
    }
    const std::optional<T> t = first_value(*reply);
    if (!t) continue;
    if (pixel.is_hit && !(*t < pixel.t) && !(*t == pixel.t && index < pixel.index)) continue;
    pixel.is_hit = true;
    pixel.t = *t;
    pixel.index = index;
    pixel.answer = *reply;
  }
  questions_.clear();
  cases_.clear();
}

template <Real T>
Finding SecondKernel<T>::finding(const Pixel& pixel, const Ray<T>& ray, const std::vector<SceneHit<T>>& ties) const {
  if (pixel.has_failed) return Finding::failed;
  if (ties.empty()) return pixel.is_hit ? Finding::false_hit : Finding::agrees;
  if (!pixel.is_hit) return Finding::lost;
  const fuzz::Case<T> input = primitives_.with(pixel.index, [&](const auto& shape) { return case_of(ray, shape); });
  const fuzz::Answer<T> right = exact_answer(input);
  const auto nearest = first_value<T>(ties.front().shape == Shape::triangle ? fuzz::Answer<T>(ties.front().triangle)
                                                                            : fuzz::Answer<T>(ties.front().sphere));
  // Of hits that round to one t each is the nearest to whoever sees but that.
  if (first_value(right) != nearest) {
    const bool is_neighbour = std::any_of(ties.begin(), ties.end(), [&](const SceneHit<T>& tie) {
      return primitives_.with(pixel.index, [&](const auto& taken) {
        return primitives_.with(tie.index, [&](const auto& true_one) { return share_corner(taken, true_one); });
      });
    });
    return is_neighbour || pixel.t < *nearest ? Finding::other_nearest : Finding::lost;
  }
  const fuzz::Comparison comparison = fuzz::compare(input, pixel.answer, right, oracle::gmp_oracle(), kernel_.deviations());
  switch (comparison.disagreement) {
    case fuzz::Disagreement::none:
      return Finding::agrees;
    case fuzz::Disagreement::misrounded:
      return Finding::wrong_number;
    default:
      return Finding::wrong_kind;
  }
}

template class SecondKernel<float>;
template class SecondKernel<double>;

}  // namespace graze::cli
