// What the program's exit status means, everywhere.
#pragma once

namespace graze::cli {

enum ExitStatus : int {
  exit_well = 0,         ///< all is well
  exit_found_wrong = 1,  ///< the thing checked was found wrong
  exit_bad_input = 2,    ///< usage or input error, or output that can't be written
};

}  // namespace graze::cli
