// A report as JSON, by docs/report.schema.json.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <variant>

#include "fuzz/report/report.hpp"

namespace graze::fuzz {

using Json = nlohmann::ordered_json;

/// The value of the field `format`; another one where readers of this one could not follow.
inline constexpr std::string_view report_format = "graze report 1";

/// The same report always gives the same bytes. Sums stand beside the parts that they are made of.
[[nodiscard]] Json to_json(const Report& report);

/// What was found on the cases of a part, without the range: as in rows, parts and totals.
[[nodiscard]] Json to_json(const Report& report, const Part& part, bool is_mesh);

/// What makes two reports ones of the same campaign: all but what was found, on which machine, in which shard.
[[nodiscard]] Json identity(const Report& report);

/// What is wrong with a text: a clause.
struct ReportError {
  std::string what;
};

/// Reads what to_json wrote. Refuses, by the name of the field, what is missing, of another type, or does not fit the rest.
[[nodiscard]] std::variant<Report, ReportError> parse_report(std::string_view text);

/// Of the first place where the two differ: its name, and both values there, shortened. Empty where they are equal.
[[nodiscard]] std::string first_difference(const Json& a, const Json& b);

}  // namespace graze::fuzz
