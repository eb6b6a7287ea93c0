// `graze trace`: rays in, hits out; `graze inside`: points in, places out.
#pragma once

#include <CLI/App.hpp>

namespace graze::cli {

/// Adds the command to the program; when it runs it sets `status`, an ExitStatus.
void add_trace(CLI::App& program, int& status);
void add_inside(CLI::App& program, int& status);

}  // namespace graze::cli
