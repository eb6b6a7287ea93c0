// What an option that counts something takes.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <string>

namespace graze::cli {

/// A number above zero; whether it fits the option's type is checked after this.
inline const CLI::Validator positive(
    [](const std::string& text) {
      return std::strtod(text.c_str(), nullptr) > 0 ? std::string() : "'" + text + "' is no number above zero";
    },
    "POSITIVE");

}  // namespace graze::cli
