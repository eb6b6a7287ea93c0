#include "fuzz/scene/scene_bytes.hpp"

#include <cmath>
#include <cstring>

#include "graze/numeric/bits.hpp"

namespace graze::fuzz {
namespace {

/// All that a scene may have: the oracle is asked about each for every query.
constexpr std::size_t most_primitives = 48;

class Reader {
 public:
  explicit Reader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  [[nodiscard]] bool is_done() const { return bytes_.empty(); }
  std::uint8_t byte() {
    if (bytes_.empty()) return 0;
    const std::uint8_t b = bytes_.front();
    bytes_ = bytes_.subspan(1);
    return b;
  }
  template <Real T>
  T number(bool is_raw, T unit) {
    if (!is_raw) return static_cast<T>(static_cast<std::int8_t>(byte())) * unit;
    numeric::Bits<T> bits = 0;
    for (unsigned i = 0; i < sizeof(T); ++i) bits |= static_cast<numeric::Bits<T>>(byte()) << (8 * i);
    return std::bit_cast<T>(bits);
  }

 private:
  std::span<const std::uint8_t> bytes_;
};

template <Real T>
SceneQuestion<T> decode(unsigned first, Reader bytes) {
  SceneQuestion<T> question;
  SceneDraft<T>& draft = question.draft;
  draft.family = "bytes";
  const bool is_raw = (first & 2) != 0;
  const unsigned repeats = 1 + (first >> 6);
  question.is_closed = (first & 16) != 0;
  question.is_refitted = (first & 32) != 0;
  const int exponent = static_cast<std::int8_t>(bytes.byte());
  const auto unit = static_cast<T>(std::ldexp(1.0, sizeof(T) == 4 ? exponent : 8 * exponent));
  const auto number = [&] { return bytes.number<T>(is_raw, unit); };
  const auto vector = [&] {
    Vec3<T> v;
    for (T* x : {&v.x, &v.y, &v.z}) *x = number();
    return v;
  };
  if ((first & 8) != 0) {
    const unsigned flags = bytes.byte();
    question.options.ignore_coplanar = (flags & 1) != 0;
    question.options.cull_back_faces = (flags & 2) != 0;
    question.is_split = (flags & 4) != 0;
    question.options.leave_out = bytes.byte();
    question.options.mask = bytes.byte();
  }
  question.ray.origin = vector();
  question.ray.direction = vector();
  if ((first & 4) != 0) {
    // Of the unit 1/8: the parameters of hits on lattices.
    question.ray.t_min = bytes.number<T>(is_raw, T(0.125));
    question.ray.t_max = bytes.number<T>(is_raw, T(0.125));
  }
  while (!bytes.is_done() && draft.primitives.size() < most_primitives) {
    const unsigned kind = bytes.byte(), count = kind >> 1 & 15;
    const std::uint32_t mask = (kind >> 5) == 0 ? ~std::uint32_t(0) : kind >> 5;
    if ((kind & 1) != 0) {
      std::vector<Sphere<T>> spheres;
      for (unsigned i = 0; i < count; ++i) {
        const Vec3<T> center = vector();
        const T radius = number();
        spheres.push_back({center, radius});
        draft.primitives.push_back({Shape::sphere, {}, spheres.back(), mask});
      }
      draft.parts.push_back(Spheres<T>{std::move(spheres), mask});
      continue;
    }
    std::vector<Vec3<T>> points;
    for (unsigned i = 0; i < count; ++i) points.push_back(vector());
    std::vector<Corners> triangles;
    const unsigned wanted = bytes.byte() % most_primitives;
    for (unsigned i = 0; i < wanted && !points.empty(); ++i) {
      Corners corners;
      for (std::uint32_t& c : corners) c = bytes.byte() % count;
      for (unsigned k = 0; k < repeats; ++k) {
        triangles.push_back(corners);
        draft.primitives.push_back({Shape::triangle, {points[corners[0]], points[corners[1]], points[corners[2]]}, {}, mask});
      }
    }
    draft.parts.push_back(Mesh<T>{std::move(points), std::move(triangles), mask});
  }
  return question;
}

}  // namespace

std::variant<SceneQuestion<float>, SceneQuestion<double>> decode_scene(std::span<const std::uint8_t> bytes) {
  Reader reader(bytes);
  const unsigned first = reader.byte();
  if ((first & 1) != 0) return decode<double>(first, reader);
  return decode<float>(first, reader);
}

}  // namespace graze::fuzz
