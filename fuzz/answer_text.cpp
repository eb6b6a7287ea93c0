#include "fuzz/answer_text.hpp"

#include <array>
#include <optional>
#include <vector>

#include "fuzz/answer_names.hpp"
#include "fuzz/number_text.hpp"
#include "fuzz/words.hpp"

namespace graze::fuzz {
namespace {

/// An answer line taken apart: its kind, the numbers behind it, and its details.
template <Real T>
struct Words {
  std::string_view kind;
  std::vector<T> numbers;
  std::string_view status;  // the word behind `invalid`
  std::string_view root, origin, facing;
  std::optional<LineError> error;
};

/// Puts the value of `key=` where it belongs; false where the word is no detail.
template <Real T>
bool take_detail(std::string_view word, Words<T>& words) {
  const auto take = [&](std::string_view key, std::string_view& value) {
    if (!word.starts_with(key)) return false;
    value = word.substr(key.size());
    return true;
  };
  return take("root=", words.root) || take("origin=", words.origin) || take("facing=", words.facing);
}

template <Real T>
Words<T> take_apart(std::string_view line) {
  constexpr std::size_t most_numbers = 3;
  Words<T> words;
  words.kind = take_word(line);
  if (words.kind == "invalid") words.status = take_word(line);
  for (std::string_view word = take_word(line); !word.empty(); word = take_word(line)) {
    if (take_detail(word, words)) continue;
    const std::optional<T> number = parse_number<T>(word);
    if (!number || words.numbers.size() == most_numbers) {
      words.error = LineError{quoted(word) + (number ? " is a number too many" : " is neither a number nor a detail")};
      return words;
    }
    words.numbers.push_back(*number);
  }
  return words;
}

/// The value of that name in the range from first to last.
template <class Enum>
std::optional<Enum> find_named(std::string_view name, Enum first, Enum last) {
  for (int i = static_cast<int>(first); i <= static_cast<int>(last); ++i) {
    if (name_of(static_cast<Enum>(i)) == name) return static_cast<Enum>(i);
  }
  return std::nullopt;
}

LineError unknown(std::string_view word, std::string_view what) {
  return {word.empty() ? "there is no " + std::string(what) : quoted(word) + " is no " + std::string(what)};
}

LineError wrong_count(std::string_view kind, std::string_view wanted) {
  return {std::string(kind) + " takes " + std::string(wanted)};
}

/// The status behind `invalid`; ok is none.
std::optional<Status> status_of(std::string_view word) {
  return find_named(word, Status::non_finite, Status::empty_range);
}

template <Real T>
std::variant<Answer<T>, LineError> parse_sphere(const Words<T>& words) {
  SphereHit<T> hit;
  const auto kind = words.kind == "hit" ? SphereKind::secant : find_named(words.kind, SphereKind::miss, SphereKind::secant);
  if (!kind) return unknown(words.kind, "kind of ray_sphere");
  hit.kind = *kind;
  const std::size_t count = words.numbers.size();
  if (hit.kind == SphereKind::miss && count != 0) return wrong_count(words.kind, "no value");
  if (hit.kind == SphereKind::tangent && count != 1) return wrong_count(words.kind, "one value, t");
  if (hit.kind == SphereKind::secant && count != 1 && count != 2) return wrong_count(words.kind, "one value or two, the roots");
  for (std::size_t i = 0; i < count; ++i) hit.t[i] = words.numbers[i];
  if (count != 0) hit.root = hit.kind == SphereKind::tangent || count == 2 ? Root::both : Root::first;
  if (!words.root.empty()) {
    const auto root = find_named(words.root, Root::none, Root::both);
    if (!root) return unknown(words.root, "root");
    // How many roots there are is told by the values.
    if (hit.kind == SphereKind::secant && (*root == Root::both) != (count == 2)) {
      return LineError{"root=" + std::string(words.root) + " does not go with " + std::to_string(count) +
                       (count == 1 ? " value" : " values")};
    }
    hit.root = *root;
  }
  if (!words.origin.empty()) {
    const auto origin = find_named(words.origin, OriginSide::inside, OriginSide::outside);
    if (!origin) return unknown(words.origin, "side of the origin");
    hit.origin = *origin;
  }
  return Answer<T>(hit);
}

template <Real T>
std::variant<Answer<T>, LineError> parse_triangle(const Words<T>& words) {
  TriangleHit<T> hit;
  const auto kind =
      words.kind == "hit" ? TriangleKind::face : find_named(words.kind, TriangleKind::miss, TriangleKind::degenerate);
  if (!kind) return unknown(words.kind, "kind of ray_triangle");
  hit.kind = *kind;
  const std::size_t count = words.numbers.size();
  if (hit.kind == TriangleKind::miss) {
    if (count != 0) return wrong_count(words.kind, "no value");
  } else if (hit.is_interval()) {
    if (count != 2) return wrong_count(words.kind, "two values, the ends of the common part");
    hit.t = words.numbers[0];
    hit.t_end = words.numbers[1];
  } else {
    if (count != 1 && count != 3) return wrong_count(words.kind, "t, or t u v");
    hit.t = hit.t_end = words.numbers[0];
    if (count == 3) {
      hit.u = words.numbers[1];
      hit.v = words.numbers[2];
    }
  }
  if (!words.facing.empty()) {
    const auto facing = find_named(words.facing, Facing::none, Facing::back);
    if (!facing) return unknown(words.facing, "facing");
    hit.facing = *facing;
  }
  return Answer<T>(hit);
}

template <Real T>
std::variant<Answer<T>, LineError> parse_side(const Case<T>& input, const Words<T>& words) {
  const bool about_sphere = std::holds_alternative<PointSphere<T>>(input);
  for (const Sign sign : {Sign::negative, Sign::zero, Sign::positive}) {
    if (words.kind != (about_sphere ? name_about_sphere(sign) : name_of(sign))) continue;
    if (!words.numbers.empty()) return wrong_count(words.kind, "no value");
    return Answer<T>(Side{Status::ok, sign});
  }
  return unknown(words.kind, about_sphere ? "side of a sphere" : "sign");
}

/// Invalid, in the query's own type of answer.
template <Real T>
Answer<T> invalid(const Case<T>& input, Status status) {
  if (std::holds_alternative<RaySphere<T>>(input)) {
    SphereHit<T> hit;
    hit.status = status;
    hit.kind = SphereKind::invalid;
    return hit;
  }
  if (std::holds_alternative<RayTriangle<T>>(input)) {
    TriangleHit<T> hit;
    hit.status = status;
    hit.kind = TriangleKind::invalid;
    return hit;
  }
  return Side{status, Sign::zero};
}

}  // namespace

template <Real T>
std::variant<Answer<T>, LineError> parse_answer(const Case<T>& input, std::string_view line) {
  const Words<T> words = take_apart<T>(line);
  if (words.kind == "invalid") {
    const auto status = status_of(words.status);
    if (!status) return unknown(words.status, "status");
    return invalid(input, *status);
  }
  // A kind that is none says more than a word behind it.
  const auto answer = [&]() -> std::variant<Answer<T>, LineError> {
    if (std::holds_alternative<RaySphere<T>>(input)) return parse_sphere(words);
    if (std::holds_alternative<RayTriangle<T>>(input)) return parse_triangle(words);
    return parse_side(input, words);
  }();
  if (words.error && std::holds_alternative<Answer<T>>(answer)) return *words.error;
  return answer;
}

template std::variant<Answer<float>, LineError> parse_answer(const Case<float>&, std::string_view);
template std::variant<Answer<double>, LineError> parse_answer(const Case<double>&, std::string_view);

}  // namespace graze::fuzz
