#include "fuzz/plugins/declaration.hpp"

#include <algorithm>

#include "fuzz/number_text.hpp"
#include "fuzz/words.hpp"

namespace graze::fuzz {
namespace {

std::optional<std::size_t> find_query(std::string_view word) {
  static const std::array<Case<double>, 5> cases = {RaySphere<double>{}, RayTriangle<double>{}, PointLine<double>{},
                                                    PointPlane<double>{}, PointSphere<double>{}};
  for (const Case<double>& input : cases) {
    if (query_name(input) == word) return input.index();
  }
  return std::nullopt;
}

LineError unknown(std::string_view word) {
  std::string what = quoted(word) +
                     " can't be declared; there are: ray_sphere, ray_triangle, point_line, point_plane, point_sphere, " +
                     "float, double, t-ulps=K, uv-ulps=K";
  for (const DeviationText& text : deviation_texts) {
    if (text.name != name_of(Deviation::inexact_numbers)) what.append(", ").append(text.name);
  }
  return {std::move(what)};
}

/// Takes `key=K`; false where the word is something else.
bool take_ulps(std::string_view word, std::string_view key, double& ulps, std::optional<LineError>& error) {
  if (!word.starts_with(key)) return false;
  const auto number = parse_number<double>(word.substr(key.size()));
  if (number && *number >= 0.5) {
    ulps = *number;
  } else {
    error = LineError{quoted(word) + " wants a number of ulps, 0.5 or more"};
  }
  return true;
}

}  // namespace

std::variant<Declaration, LineError> parse_declaration(std::string_view words) {
  Declaration declaration;
  std::array<bool, 5> queries{};
  std::array<bool, 2> precisions{};
  std::optional<LineError> error;
  while (!words.empty()) {
    const std::size_t end = std::min(words.find(','), words.size());
    std::string_view rest = words.substr(0, end);
    const std::string_view word = take_word(rest);
    words.remove_prefix(std::min(end + 1, words.size()));
    if (const auto query = find_query(word)) {
      queries[*query] = true;
    } else if (word == "float" || word == "double") {
      precisions[word == "double"] = true;
    } else if (const auto deviation = find_deviation(word); deviation && *deviation != Deviation::inexact_numbers) {
      declaration.deviations.set.add(*deviation);
    } else if (!take_ulps(word, "t-ulps=", declaration.deviations.t_ulps, error) &&
               !take_ulps(word, "uv-ulps=", declaration.deviations.uv_ulps, error)) {
      return unknown(word);
    }
    if (error) return *error;
  }
  const auto all_or_named = [](auto& named) {
    if (std::none_of(named.begin(), named.end(), [](bool b) { return b; })) named.fill(true);
  };
  all_or_named(queries);
  all_or_named(precisions);
  for (std::size_t p = 0; p < precisions.size(); ++p) {
    if (precisions[p]) declaration.offers[p] = queries;
  }
  return declaration;
}

}  // namespace graze::fuzz
