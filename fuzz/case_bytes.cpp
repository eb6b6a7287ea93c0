#include "fuzz/case_bytes.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include "fuzz/families/coordinates.hpp"
#include "fuzz/same_bits.hpp"

namespace graze::fuzz {
namespace {

constexpr std::uint8_t query_mask = 7, double_bit = 8, range_bit = 16, compact_bit = 32, eightfold_bit = 64;
constexpr std::int8_t infinite_end = 127;
constexpr std::size_t exponents = 3, queries = std::variant_size_v<Case<double>>;

/// The first query of a group, and how many it has.
constexpr std::size_t first_of(QueryGroup group) {
  return static_cast<std::size_t>(group);
}
constexpr std::size_t count_of(QueryGroup group) {
  return group == QueryGroup::implicit ? queries - first_of(group) : 1;
}

/// The numbers of a case in the order of its line; of a ray's range last, and only if it is given.
template <Real T>
struct Numbers {
  Numbers(Case<T>& input, bool range) : all(construct::coordinates(input)), query(input.index()) {
    plain_count = all.count;
    has_range = range && construct::ray_of(input) != nullptr;
    if (has_range) all.count += 2;
  }

  [[nodiscard]] std::size_t count() const { return all.count; }
  [[nodiscard]] T& at(std::size_t i) const { return *all.at[i]; }
  [[nodiscard]] bool is_end(std::size_t i) const { return has_range && i + 1 == all.count; }
  /// Which exponent the compact form gives the number.
  [[nodiscard]] std::size_t exponent_of(std::size_t i) const {
    if (i >= plain_count) return 2;
    if (query < 2) return i >= 3 && i < 6 ? 1 : 0;
    const std::size_t point = query == 2 ? 2 : 3;
    return query < 4 && i >= point ? 1 : 0;
  }

  construct::Coordinates<T> all;
  std::size_t query, plain_count = 0;
  bool has_range = false;
};

class Reader {
 public:
  explicit Reader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  std::uint8_t byte() {
    if (bytes_.empty()) return 0;
    const std::uint8_t first = bytes_.front();
    bytes_ = bytes_.subspan(1);
    return first;
  }
  std::int8_t signed_byte() { return static_cast<std::int8_t>(byte()); }

  template <Real T>
  T number() {
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < sizeof(T); ++i) bits |= std::uint64_t{byte()} << (8 * i);
    if constexpr (sizeof(T) == sizeof(float)) {
      return std::bit_cast<float>(static_cast<std::uint32_t>(bits));
    } else {
      return std::bit_cast<double>(bits);
    }
  }

 private:
  std::span<const std::uint8_t> bytes_;
};

template <Real T, std::size_t I = 0>
Case<T> case_of(std::size_t query) {
  if constexpr (I + 1 < queries) {
    if (query != I) return case_of<T, I + 1>(query);
  }
  return Case<T>(std::in_place_index<I>);
}

template <Real T>
Case<T> decode(QueryGroup group, std::uint8_t head, Reader reader) {
  Case<T> input = case_of<T>(first_of(group) + (head & query_mask) % count_of(group));
  const Numbers<T> numbers(input, (head & range_bit) != 0);
  if ((head & compact_bit) == 0) {
    for (std::size_t i = 0; i < numbers.count(); ++i) numbers.at(i) = reader.number<T>();
    return input;
  }
  const int factor = (head & eightfold_bit) != 0 ? 8 : 1;
  std::array<int, exponents> exponent{};
  for (int& e : exponent) e = factor * reader.signed_byte();
  for (std::size_t i = 0; i < numbers.count(); ++i) {
    const std::int8_t m = reader.signed_byte();
    const bool is_infinite = numbers.is_end(i) && m == infinite_end;
    numbers.at(i) = is_infinite ? std::numeric_limits<T>::infinity() : std::ldexp(T(m), exponent[numbers.exponent_of(i)]);
  }
  return input;
}

/// The exponent of the last bit of x; x is finite and not zero.
template <Real T>
int last_exponent(T x) {
  int exponent = 0;
  T m = std::frexp(x, &exponent);
  // A significand is read off in at most this many steps.
  for (; m != std::trunc(m); --exponent) m *= 2;
  return exponent;
}

/// Just this case if it has a compact form; else some other.
template <Real T>
std::vector<std::uint8_t> encode_compact(std::uint8_t head, const Numbers<T>& numbers) {
  constexpr int none = 128;
  std::array<int, exponents> exponent;
  exponent.fill(none);
  for (std::size_t i = 0; i < numbers.count(); ++i) {
    const T x = numbers.at(i);
    int& e = exponent[numbers.exponent_of(i)];
    if (std::isfinite(x) && x != 0) e = std::min(e, last_exponent(x));
  }
  std::vector<std::uint8_t> bytes{static_cast<std::uint8_t>(head | compact_bit)};
  for (int& e : exponent) {
    e = e == none ? 0 : std::clamp(e, -128, 127);
    bytes.push_back(static_cast<std::uint8_t>(e));
  }
  for (std::size_t i = 0; i < numbers.count(); ++i) {
    const T m = std::ldexp(numbers.at(i), -exponent[numbers.exponent_of(i)]);
    const bool is_infinite = numbers.is_end(i) && std::isinf(m);
    bytes.push_back(static_cast<std::uint8_t>(is_infinite ? infinite_end : m >= -128 && m <= 127 ? static_cast<int>(m) : 0));
  }
  return bytes;
}

template <Real T>
bool is_same_case(Case<T> a, Case<T> b) {
  if (a.index() != b.index()) return false;
  const Numbers<T> of_a(a, true), of_b(b, true);
  for (std::size_t i = 0; i < of_a.count(); ++i) {
    if (!same_bits(of_a.at(i), of_b.at(i))) return false;
  }
  return true;
}

template <Real T>
bool has_default_range(Case<T> input) {
  const Ray<T>* ray = construct::ray_of(input);
  return ray == nullptr || (same_bits(ray->t_min, T(0)) && same_bits(ray->t_max, std::numeric_limits<T>::infinity()));
}

}  // namespace

AnyCase decode_case(QueryGroup group, std::span<const std::uint8_t> bytes) {
  Reader reader(bytes);
  const std::uint8_t head = reader.byte();
  if ((head & double_bit) != 0) return decode<double>(group, head, reader);
  return decode<float>(group, head, reader);
}

template <Real T>
std::vector<std::uint8_t> encode_case(const Case<T>& input) {
  Case<T> copy = input;
  const bool range = !has_default_range(input);
  const Numbers<T> numbers(copy, range);
  const QueryGroup group = group_of(input.index());
  const auto head = static_cast<std::uint8_t>((input.index() - first_of(group)) |
                                              (sizeof(T) == sizeof(double) ? double_bit : 0) | (range ? range_bit : 0));

  std::vector<std::uint8_t> bytes = encode_compact(head, numbers);
  if (is_same_case(std::get<Case<T>>(decode_case(group, bytes)), input)) return bytes;

  bytes = {head};
  for (std::size_t i = 0; i < numbers.count(); ++i) {
    using Bits = std::conditional_t<sizeof(T) == sizeof(float), std::uint32_t, std::uint64_t>;
    const auto bits = std::bit_cast<Bits>(numbers.at(i));
    for (std::size_t b = 0; b < sizeof(T); ++b) bytes.push_back(static_cast<std::uint8_t>(bits >> (8 * b)));
  }
  return bytes;
}

template std::vector<std::uint8_t> encode_case(const Case<float>&);
template std::vector<std::uint8_t> encode_case(const Case<double>&);

}  // namespace graze::fuzz
