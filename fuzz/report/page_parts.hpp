// What the pages are made of.
#pragma once

#include <string>

#include "fuzz/report/report.hpp"

namespace graze::fuzz {

enum class Width { normal, broad };

/// A whole document.
[[nodiscard]] std::string document(const std::string& title, const std::string& body, Width width = Width::normal);

/// The word with a sign, in its colour.
[[nodiscard]] std::string verdict_badge(Verdict verdict);

/// What the results are true of; without the kernel.
[[nodiscard]] std::string scope_section(const Report& report);

/// What each family attacks.
[[nodiscard]] std::string family_notes(const Report& report);

/// An offender with its picture and the command that replays it.
[[nodiscard]] std::string offender_section(const Report& report, const Row& row, const Offender& offender);

/// The background of a cell that holds a share of wrong answers.
[[nodiscard]] std::string heat(double share);

/// The rule of three: what n cases without a failure say of the rate, with 95 % confidence.
[[nodiscard]] std::string rate_bound(std::uint64_t n);

}  // namespace graze::fuzz
