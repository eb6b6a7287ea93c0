// The end of a command that cannot go on.
#pragma once

#include <iostream>
#include <string>

#include "cli/exit_status.hpp"

namespace graze::cli {

/// Tells on standard error, after the answers so far, what is wrong.
inline int refuse(const std::string& message) {
  std::cout.flush();
  std::cerr << message << '\n';
  return exit_bad_input;
}

}  // namespace graze::cli
