#include "fuzz/batch_check.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

#include "exact/order.hpp"
#include "fuzz/case_text.hpp"
#include "fuzz/same_bits.hpp"
#include "graze/batch.hpp"
#include "graze/sphere.hpp"
#include "graze/triangle.hpp"

namespace graze::fuzz {
namespace {

/// Arrays of one number each, off their alignment by a few elements.
template <Real T, std::size_t n>
class Columns {
 public:
  Columns(std::size_t lanes, std::size_t offset) : offset_(offset) {
    for (std::vector<T>& column : columns_) column.resize(lanes + 2 * 16);
  }
  void set(std::size_t lane, const std::array<T, n>& numbers) {
    for (std::size_t k = 0; k < n; ++k) columns_[k][start(k) + lane] = numbers[k];
  }
  [[nodiscard]] const T* column(std::size_t k) const { return columns_[k].data() + start(k); }
  [[nodiscard]] batch::Vec3Arrays<T> vector(std::size_t k) const { return {column(k), column(k + 1), column(k + 2)}; }

 private:
  [[nodiscard]] std::size_t start(std::size_t k) const { return (offset_ * (2 * k + 1)) % 16; }

  std::size_t offset_;
  std::array<std::vector<T>, n> columns_;
};

template <Real T>
std::array<T, 8> numbers_of(const Ray<T>& ray) {
  const auto& [e, d, t_min, t_max] = ray;
  return {e.x, e.y, e.z, d.x, d.y, d.z, t_min, t_max};
}
template <Real T>
std::array<T, 9> numbers_of(const Triangle<T>& t) {
  return {t.a.x, t.a.y, t.a.z, t.b.x, t.b.y, t.b.z, t.c.x, t.c.y, t.c.z};
}
template <Real T>
std::array<T, 4> numbers_of(const Sphere<T>& s) {
  return {s.center.x, s.center.y, s.center.z, s.radius};
}

template <class Items>
auto columns_of(const Items& items, std::size_t offset) {
  using Numbers = decltype(numbers_of(items.front()));
  Columns<typename Numbers::value_type, std::tuple_size_v<Numbers>> columns(items.size(), offset);
  for (std::size_t i = 0; i < items.size(); ++i) columns.set(i, numbers_of(items[i]));
  return columns;
}

template <Real T>
batch::RayArrays<T> arrays(const Columns<T, 8>& c, std::size_t n, bool has_range) {
  if (!has_range) return {c.vector(0), c.vector(3), n};
  return {c.vector(0), c.vector(3), n, c.column(6), c.column(7)};
}
template <Real T>
batch::TriangleArrays<T> arrays(const Columns<T, 9>& c, std::size_t n) {
  return {c.vector(0), c.vector(3), c.vector(6), n};
}
template <Real T>
batch::SphereArrays<T> arrays(const Columns<T, 4>& c, std::size_t n) {
  return {c.vector(0), c.column(3), n};
}

constexpr std::uint64_t canary = 0xc0ffee0ddf00d555;

/// An output array, with a canary behind its end.
template <class T>
class Output {
 public:
  explicit Output(std::size_t n) : items_(n + 1), end_(n) { std::memset(items_.data(), 0x55, items_.size() * sizeof(T)); }
  [[nodiscard]] T* data() { return items_.data(); }
  [[nodiscard]] const T& operator[](std::size_t i) const { return items_[i]; }
  [[nodiscard]] bool is_kept() const {
    unsigned char bytes[sizeof(T)];
    std::memcpy(bytes, &items_[end_], sizeof(T));
    return std::all_of(bytes, bytes + sizeof(T), [](unsigned char b) { return b == 0x55; });
  }

 private:
  std::vector<T> items_;
  std::size_t end_;
};

template <Real T>
struct TriangleOutputs {
  using Hit = TriangleHit<T>;
  Output<Status> status;
  Output<TriangleKind> kind;
  Output<Facing> facing;
  Output<T> t, t_end, u, v;

  explicit TriangleOutputs(std::size_t n) : status(n), kind(n), facing(n), t(n), t_end(n), u(n), v(n) {}
  batch::TriangleHitArrays<T> arrays() {
    return {status.data(), kind.data(), facing.data(), t.data(), t_end.data(), u.data(), v.data()};
  }
  [[nodiscard]] Hit operator[](std::size_t i) const { return {status[i], kind[i], facing[i], t[i], t_end[i], u[i], v[i]}; }
  [[nodiscard]] bool are_kept() const {
    return status.is_kept() && kind.is_kept() && facing.is_kept() && t.is_kept() && t_end.is_kept() && u.is_kept() &&
           v.is_kept();
  }
};

template <Real T>
struct SphereOutputs {
  using Hit = SphereHit<T>;
  Output<Status> status;
  Output<SphereKind> kind;
  Output<Root> root;
  Output<OriginSide> origin;
  Output<T> first, second;

  explicit SphereOutputs(std::size_t n) : status(n), kind(n), root(n), origin(n), first(n), second(n) {}
  batch::SphereHitArrays<T> arrays() {
    return {status.data(), kind.data(), root.data(), origin.data(), first.data(), second.data()};
  }
  [[nodiscard]] Hit operator[](std::size_t i) const { return {status[i], kind[i], root[i], origin[i], {first[i], second[i]}}; }
  [[nodiscard]] bool are_kept() const {
    return status.is_kept() && kind.is_kept() && root.is_kept() && origin.is_kept() && first.is_kept() && second.is_kept();
  }
};

template <Real T>
TriangleOutputs<T> outputs(const Triangle<T>*, std::size_t n) {
  return TriangleOutputs<T>(n);
}
template <Real T>
SphereOutputs<T> outputs(const Sphere<T>*, std::size_t n) {
  return SphereOutputs<T>(n);
}

template <Real T>
Case<T> case_of(const Ray<T>& ray, const Triangle<T>& triangle) {
  return RayTriangle<T>{ray, triangle};
}
template <Real T>
Case<T> case_of(const Ray<T>& ray, const Sphere<T>& sphere) {
  return RaySphere<T>{ray, sphere};
}

/// Calls f(rays, shapes) with what the form makes of both.
template <Real T, template <class> class Shape, class RayColumns, class ShapeColumns, class F>
void call(const Batch<T, Shape>& batch, const RayColumns& rays, const ShapeColumns& shapes, F f) {
  const bool has_range =
      std::any_of(batch.rays.begin(), batch.rays.end(), [](const Ray<T>& ray) { return !numeric::is_default_range(ray); });
  const auto many_rays = arrays(rays, batch.rays.size(), has_range);
  const auto many_shapes = arrays(shapes, batch.shapes.size());
  if (batch.form == BatchForm::pairs) return f(many_rays, many_shapes);
  if (batch.form == BatchForm::one_ray) return f(batch.rays.front(), many_shapes);
  f(many_rays, batch.shapes.front());
}

template <Real T, template <class> class Shape>
std::string told(const Batch<T, Shape>& batch, std::size_t lane, const Case<T>& input, const std::string& what) {
  const char* form = batch.form == BatchForm::pairs     ? "pairs"
                     : batch.form == BatchForm::one_ray ? "one ray against many"
                                                        : "many rays against one";
  return std::to_string(sizeof(T) * 8) + " bits, " + form + ", " + std::string(name_of(batch.mode)) + ", lane " +
         std::to_string(lane) + " of " + std::to_string(batch.lanes()) + ", offset " + std::to_string(batch.offset) + ":\n  " +
         format_case(input) + "\n  " + what;
}

/// The nearest hit by exact comparison of all, against the batch's.
template <Real T, template <class> class Shape, class ShapeColumns>
std::optional<std::string> find_nearest_fault(const Batch<T, Shape>& batch, const ShapeColumns& shapes) {
  if (batch.form != BatchForm::one_ray) return std::nullopt;
  const Ray<T>& ray = batch.rays.front();
  const std::size_t n = batch.shapes.size();
  std::size_t truth = n;
  for (std::size_t i = 0; i < n; ++i) {
    if (!hits(ray, batch.shapes[i])) continue;
    if (truth == n || exact::compare_first(ray, batch.shapes[i], batch.shapes[truth]) < 0) truth = i;
  }
  const auto found = [&] {
    const FloatModeScope scope(batch.mode);
    return batch::nearest(ray, arrays(shapes, n));
  }();
  if (found.index != truth) {
    const std::string which =
        "the nearest of " + std::to_string(n) + " is " + std::to_string(truth) + ", answered " + std::to_string(found.index);
    return truth == n ? which : told(batch, truth, case_of(ray, batch.shapes[truth]), which);
  }
  if (truth == n || same_bits(found.hit, intersect(ray, batch.shapes[truth]))) return std::nullopt;
  return told(batch, truth, case_of(ray, batch.shapes[truth]), "the nearest hit has other numbers");
}

}  // namespace

template <Real T, template <class> class Shape>
std::optional<std::string> find_batch_fault(const Batch<T, Shape>& batch) {
  const std::size_t n = batch.lanes(), words = batch::mask_words(n);
  const auto rays = columns_of(batch.rays, batch.offset);
  const auto shapes = columns_of(batch.shapes, batch.offset + 5);
  std::vector<std::uint64_t> mask(words + 1, canary);
  auto out = outputs(static_cast<const Shape<T>*>(nullptr), n);
  {
    const FloatModeScope scope(batch.mode);
    call(batch, rays, shapes, [&](const auto& r, const auto& s) {
      batch::hits(r, s, mask.data());
      batch::intersect(r, s, out.arrays());
    });
  }
  for (std::size_t i = 0; i < n; ++i) {
    const Ray<T>& ray = batch.rays[batch.form == BatchForm::one_ray ? 0 : i];
    const Shape<T>& shape = batch.shapes[batch.form == BatchForm::one_shape ? 0 : i];
    const bool is_hit = hits(ray, shape), was_hit = ((mask[i / 64] >> (i % 64)) & 1) != 0;
    if (is_hit != was_hit) return told(batch, i, case_of(ray, shape), was_hit ? "decided as a hit" : "decided as a miss");
    const auto truth = intersect(ray, shape), answer = out[i];
    if (same_bits(truth, answer)) continue;
    const Case<T> input = case_of(ray, shape);
    return told(batch, i, input,
                "answered " + format_answer(input, Answer<T>(answer), Details::yes) + ", the single query " +
                    format_answer(input, Answer<T>(truth), Details::yes));
  }
  if (auto fault = find_nearest_fault(batch, shapes)) return fault;
  if (n % 64 != 0 && (mask[words - 1] >> (n % 64)) != 0) return "bits are set past the end of a mask of " + std::to_string(n);
  if (mask[words] != canary) return "a mask of " + std::to_string(n) + " bits is written past its end";
  if (!out.are_kept()) return "answers of " + std::to_string(n) + " lanes are written past their end";
  return std::nullopt;
}

template std::optional<std::string> find_batch_fault(const Batch<float, Triangle>&);
template std::optional<std::string> find_batch_fault(const Batch<double, Triangle>&);
template std::optional<std::string> find_batch_fault(const Batch<float, Sphere>&);
template std::optional<std::string> find_batch_fault(const Batch<double, Sphere>&);

}  // namespace graze::fuzz
