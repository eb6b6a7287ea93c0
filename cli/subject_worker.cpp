#include "cli/subject_worker.hpp"

#include "fuzz/plugins/library_worker.hpp"

namespace graze::cli {

std::optional<int> run_subject_worker(const std::vector<std::string>& arguments) {
  if (arguments.size() < 3 || arguments[0] != "subject-worker") return std::nullopt;
  if (arguments.size() == 3 && arguments[1] == "describe") return fuzz::describe_library(arguments[2]);
  const auto mode = fuzz::find_float_mode(arguments[2]);
  if (arguments.size() != 4 || !mode) return std::nullopt;
  if (arguments[1] == "float") return fuzz::serve_library<float>(arguments[3], *mode);
  if (arguments[1] == "double") return fuzz::serve_library<double>(arguments[3], *mode);
  return std::nullopt;
}

}  // namespace graze::cli
