// `graze render`: a mesh seen by exact rays, as a picture.
#pragma once

#include <CLI/App.hpp>

namespace graze::cli {

/// Adds the command to the program; when it runs it sets `status`, an ExitStatus.
void add_render(CLI::App& program, int& status);

}  // namespace graze::cli
