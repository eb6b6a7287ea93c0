// `graze shrink`: the simplest case on which a kernel fails in the same way.
#pragma once

#include <CLI/App.hpp>

namespace graze::cli {

/// Adds the command to the program; when it runs it sets `status`, an ExitStatus.
void add_shrink(CLI::App& program, int& status);

}  // namespace graze::cli
