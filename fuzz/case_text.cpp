#include "fuzz/case_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

#include "fuzz/answer_names.hpp"
#include "fuzz/case_numbers.hpp"
#include "fuzz/number_text.hpp"
#include "fuzz/same_bits.hpp"
#include "fuzz/words.hpp"

namespace graze::fuzz {
namespace {

// In the order of the alternatives of Case.
constexpr std::array<NumbersText, 5> queries = {{
    {"ray_sphere", "ex ey ez dx dy dz cx cy cz r", true},
    {"ray_triangle", "ex ey ez dx dy dz ax ay az bx by bz cx cy cz", true},
    {"point_line", "px py a b c", false},
    {"point_plane", "px py pz a b c d", false},
    {"point_sphere", "px py pz cx cy cz r", false},
}};
static_assert(std::variant_size_v<Case<double>> == queries.size());

constexpr std::size_t most_numbers = 17;  // of ray_triangle with its range

LineError unknown_query(std::string_view word) {
  std::string what = "unknown query " + quoted(word) + "; the queries are";
  for (const NumbersText& query : queries) what.append(query.name == queries[0].name ? " " : ", ").append(query.name);
  return {std::move(what)};
}

LineError no_number(std::string_view word, const NumbersText& query, std::size_t index) {
  std::string names(query.numbers);
  if (query.has_range) names += " t_min t_max";
  std::string_view rest = names;
  std::string_view name = take_word(rest);
  for (std::size_t i = 0; i < index; ++i) name = take_word(rest);
  return {quoted(word) + " is no number (" + std::string(name) + " of " + std::string(query.name) + ")"};
}

LineError wrong_count(const NumbersText& query, std::size_t count, std::size_t given) {
  std::string what(query.name);
  what.append(" takes ").append(std::to_string(count)).append(" numbers, ").append(query.numbers);
  if (query.has_range) what.append(", or ").append(std::to_string(count + 2)).append(" with t_min t_max");
  what.append("; this line has ").append(std::to_string(given));
  return {std::move(what)};
}

}  // namespace

template <Real T>
std::optional<LineError> parse_numbers(const NumbersText& text, std::string_view line, std::span<T* const> numbers) {
  const std::size_t most = numbers.size(), least = text.has_range ? most - 2 : most;
  std::size_t given = 0;
  for (std::string_view word = take_word(line); !word.empty(); word = take_word(line), ++given) {
    if (given >= most) continue;
    const std::optional<T> number = parse_number<T>(word);
    if (!number) return no_number(word, text, given);
    *numbers[given] = *number;
  }
  if (given != least && given != most) return wrong_count(text, least, given);
  return {};
}

namespace {

/// Reads the numbers of a Query from what follows its name.
template <class Query, Real T>
std::variant<Case<T>, LineError> parse_query(const NumbersText& text, std::string_view rest) {
  Query query;
  std::array<T*, most_numbers> numbers{};
  std::size_t most = 0;
  for_each_number(query, [&](T& number) { numbers[most++] = &number; });
  if (auto error = parse_numbers<T>(text, rest, std::span(numbers).first(most))) return *std::move(error);
  return Case<T>(query);
}

template <Real T, std::size_t I = 0>
std::variant<Case<T>, LineError> parse_named(std::string_view name, std::string_view rest) {
  if constexpr (I == queries.size()) {
    return unknown_query(name);
  } else {
    if (name == queries[I].name) return parse_query<std::variant_alternative_t<I, Case<T>>, T>(queries[I], rest);
    return parse_named<T, I + 1>(name, rest);
  }
}

template <Real T>
void append_values(std::string& line, std::initializer_list<T> values) {
  for (const T value : values) line.append(" ").append(format_number(value, NumberForm::shortest));
}

std::string invalid(Status status) {
  return "invalid " + std::string(name_of(status));
}

template <Real T>
std::string answer_line(const SphereHit<T>& hit, Details details) {
  if (hit.kind == SphereKind::invalid) return invalid(hit.status);
  std::string line(name_of(hit.kind));
  if (hit.count() > 0) append_values(line, {hit.t[0]});
  if (hit.count() > 1) append_values(line, {hit.t[1]});
  if (details == Details::yes) {
    line.append(" origin=").append(name_of(hit.origin));
    if (hit.kind != SphereKind::miss) line.append(" root=").append(name_of(hit.root));
  }
  return line;
}

template <Real T>
std::string answer_line(const TriangleHit<T>& hit, Details details) {
  if (hit.kind == TriangleKind::invalid) return invalid(hit.status);
  std::string line(name_of(hit.kind));
  if (hit.is_interval()) {
    append_values(line, {hit.t, hit.t_end});
  } else if (hit.kind != TriangleKind::miss) {
    append_values(line, {hit.t, hit.u, hit.v});
  }
  if (details == Details::yes) line.append(" facing=").append(name_of(hit.facing));
  return line;
}

}  // namespace

bool is_skipped(std::string_view line) {
  const std::size_t first = line.find_first_not_of(blanks);
  return first == std::string_view::npos || line[first] == '#';
}

template <Real T>
std::variant<Case<T>, LineError> parse_case(std::string_view line) {
  const std::string_view name = take_word(line);
  if (name.empty()) return LineError{"the line is blank, where a case is wanted"};
  return parse_named<T>(name, line);
}

template <Real T>
std::string format_number(T number, NumberForm form) {
  if (std::isnan(number)) return "nan";
  if (std::isinf(number)) return number < 0 ? "-inf" : "inf";
  std::array<char, 64> buffer;
  if (form == NumberForm::shortest) {
    return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), number).ptr};
  }
  // to_chars has neither the prefix nor, before it, the sign.
  char* const end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), std::fabs(number), std::chars_format::hex).ptr;
  return (std::signbit(number) ? "-0x" : "0x") + std::string(buffer.data(), end);
}

template <Real T>
std::string_view query_name(const Case<T>& input) {
  return queries[input.index()].name;
}

template <Real T>
std::string format_case(const Case<T>& input, NumberForm form) {
  std::array<T, most_numbers> numbers{};
  std::size_t count = 0;
  std::visit([&](const auto& query) { for_each_number(query, [&](const T& number) { numbers[count++] = number; }); }, input);
  const bool default_range = queries[input.index()].has_range && same_bits(numbers[count - 2], T(0)) &&
                             same_bits(numbers[count - 1], std::numeric_limits<T>::infinity());
  if (default_range) count -= 2;
  std::string line(query_name(input));
  for (std::size_t i = 0; i < count; ++i) line.append(" ").append(format_number(numbers[i], form));
  return line;
}

template <Real T>
std::string format_answer(const Case<T>& input, const Answer<T>& answer, Details details) {
  if (const Side* side = std::get_if<Side>(&answer)) {
    if (side->status != Status::ok) return invalid(side->status);
    return std::string(std::holds_alternative<PointSphere<T>>(input) ? name_about_sphere(side->sign) : name_of(side->sign));
  }
  if (const auto* hit = std::get_if<SphereHit<T>>(&answer)) return answer_line(*hit, details);
  return answer_line(std::get<TriangleHit<T>>(answer), details);
}

template std::variant<Case<float>, LineError> parse_case(std::string_view);
template std::variant<Case<double>, LineError> parse_case(std::string_view);
template std::string format_number(float, NumberForm);
template std::string format_number(double, NumberForm);
template std::string_view query_name(const Case<float>&);
template std::string_view query_name(const Case<double>&);
template std::string format_case(const Case<float>&, NumberForm);
template std::string format_case(const Case<double>&, NumberForm);
template std::string format_answer(const Case<float>&, const Answer<float>&, Details);
template std::string format_answer(const Case<double>&, const Answer<double>&, Details);

template std::optional<LineError> parse_numbers(const NumbersText&, std::string_view, std::span<float* const>);
template std::optional<LineError> parse_numbers(const NumbersText&, std::string_view, std::span<double* const>);

}  // namespace graze::fuzz
