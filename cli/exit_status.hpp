// What the program's exit status means, everywhere.
#pragma once

#include <iostream>
#include <string>

namespace graze::cli {

enum ExitStatus : int {
  exit_well = 0,         ///< all is well
  exit_found_wrong = 1,  ///< the thing checked was found wrong
  exit_bad_input = 2,    ///< usage or input error, or output that can't be written
};

/// Tells on standard error what is wrong, after the results so far.
inline ExitStatus refuse(const std::string& message) {
  std::cout.flush();
  std::cerr << message << '\n';
  return exit_bad_input;
}
/// The same of what stands in no file.
inline ExitStatus refuse_by_name(const std::string& message) {
  return refuse("graze: " + message);
}

}  // namespace graze::cli
