// A user's shared library behind the case protocol: what the process that loads it runs.
#pragma once

#include <string>

#include "fuzz/float_mode.hpp"

namespace graze::fuzz {

/// Writes name, about and declaration, a line each, or `error WHAT`. Returns the exit status.
int describe_library(const std::string& path);

/// Answers cases on standard input in that precision until it ends, the library called in that mode. What the library prints
/// goes to standard error.
template <class T>
int serve_library(const std::string& path, FloatMode mode);

}  // namespace graze::fuzz
