// `graze families`: what there is, what a failure means, and who fails.
#pragma once

#include <CLI/App.hpp>

namespace graze::cli {

/// Adds the command to the program; when it runs it sets `status`, an ExitStatus.
void add_families(CLI::App& program, int& status);

}  // namespace graze::cli
