#include "cli/families.hpp"

#include <CLI/CLI.hpp>
#include <iostream>
#include <optional>

#include "cli/exit_status.hpp"
#include "fuzz/family.hpp"
#include "fuzz/shrink/failure.hpp"
#include "fuzz/subject.hpp"

namespace graze::cli {
namespace {

constexpr std::uint64_t seed = 1, cases = 1000;

/// How the subject fails worst on the family's first cases.
template <Real T>
fuzz::Disagreement worst(const fuzz::Family& family, const fuzz::Subject& subject) {
  fuzz::Disagreement worst = fuzz::Disagreement::none;
  for (std::uint64_t index = 0; index < cases; ++index) {
    worst = std::max(worst, fuzz::failure_of(subject, fuzz::make<T>(family, seed, index).input).disagreement);
  }
  return worst;
}

/// The first subject besides graze that decides wrongly, or the first that fails at all.
std::string who_fails(const fuzz::Family& family) {
  std::string misrounds;
  for (const fuzz::Subject* subject : fuzz::subjects().subspan(1)) {
    const fuzz::Disagreement how = std::max(worst<float>(family, *subject), worst<double>(family, *subject));
    if (how == fuzz::Disagreement::none) continue;
    std::string text = std::string(subject->name()) + ": " + std::string(fuzz::name_of(how));
    if (how != fuzz::Disagreement::misrounded) return text;
    if (misrounds.empty()) misrounds = std::move(text);
  }
  return misrounds.empty() ? "none in " + std::to_string(cases) + " cases a precision" : misrounds;
}

int run() {
  std::cout
      << "# Families\n\n"
         "Written by `graze families`. The last column names a kernel that fails on the first 1,000 cases of the family, seed "
         "1, in\n"
         "float or double: the first of `graze certify --help` that decides wrongly, or else that answers a wrong number.\n\n"
         "| family | what breaks here | kind of bug | effect | published | fails on it |\n|---|---|---|---|---|---|\n";
  for (const fuzz::Family& family : fuzz::families()) {
    std::cout << "| " << family.name << " | " << family.attacks << " | " << family.note.bug << " | " << family.note.effect
              << " | " << family.note.published << " | " << who_fails(family) << " |\n";
  }
  return exit_well;
}

}  // namespace

void add_families(CLI::App& program, int& status) {
  CLI::App* command = program.add_subcommand("families", "Write the table of boundary families, with who fails on each");
  command->callback([&status] { status = run(); });
}

}  // namespace graze::cli
