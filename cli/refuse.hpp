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

/// The same where no file is at fault.
inline int refuse_by_name(const std::string& message) {
  return refuse("graze: " + message);
}

}  // namespace graze::cli
