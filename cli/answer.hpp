// `graze answer`: cases in, answers out.
#pragma once

#include <CLI/App.hpp>

namespace graze::cli {

/// Adds the command to the program; when it runs it sets `status`, an ExitStatus.
void add_answer(CLI::App& program, int& status);

}  // namespace graze::cli
