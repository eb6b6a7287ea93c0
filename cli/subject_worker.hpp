// `graze subject-worker`: the process that loads a user's shared library. Not for people: `graze certify --kernel` starts it.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace graze::cli {

/// Runs it where the arguments ask for it, and tells the exit status: subject-worker describe LIBRARY,
/// or subject-worker float|double MODE LIBRARY.
[[nodiscard]] std::optional<int> run_subject_worker(const std::vector<std::string>& arguments);

}  // namespace graze::cli
