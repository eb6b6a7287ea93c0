// A digest of the kernel's answers to a fixed stream of cases: `intersect`, `hits` and `side`, all families, both precisions.
// All floating-point modes must give the same.
//   answers_digest           prints it: a line for each family and precision, with a hash of the cases and one of the answers
//   answers_digest GOLDEN    compares it with that file
//   answers_digest --cases   writes the cases, for answers_replay
// Exit status: 0 all is the same, 1 not, 2 the file cannot be read.
#include <fstream>

#include "fuzz/family.hpp"
#include "tests/bits/case_stream.hpp"
#include "tests/bits/digest.hpp"

namespace graze::fuzz {
namespace {

/// Calls take(name, maker) for each stream; maker(index) is a case of it.
template <class Take>
void for_each_stream(Take take) {
  for (const Family& family : families()) {
    take(std::string(family.name) + " float",
         [&](std::uint64_t index) { return make<float>(family, digest_seed, index).input; });
    take(std::string(family.name) + " double",
         [&](std::uint64_t index) { return make<double>(family, digest_seed, index).input; });
  }
}

Digests digests() {
  Digests all;
  for_each_stream([&](const std::string& name, const auto& case_at) {
    StreamDigest stream;
    for (std::uint64_t index = 0; index < cases_of_a_stream; ++index) stream.add(case_at(index));
    all[name] = stream.digest();
  });
  return all;
}

void write_cases(std::ostream& out) {
  for_each_stream([&](const std::string& name, const auto& case_at) {
    out << name << '\n';
    for (std::uint64_t index = 0; index < cases_of_a_stream; ++index) write_case(out, case_at(index));
  });
}

}  // namespace
}  // namespace graze::fuzz

int main(int argc, char** argv) {
  using namespace graze::fuzz;
  if (argc > 2) {
    std::cerr << "usage: answers_digest [GOLDEN | --cases]\n";
    return 2;
  }
  if (argc == 2 && std::string(argv[1]) == "--cases") {
    write_cases(std::cout);
    return std::cout.flush() ? 0 : 2;
  }
  if (argc == 1) {
    const Digests ours = digests();
    print(ours, "cases", "answers_digest");
    return are_modes_alike(ours) ? 0 : 1;
  }
  std::ifstream golden(argv[1]);
  if (!golden) {
    std::cerr << argv[1] << ": cannot be read\n";
    return 2;
  }
  return is_well(read(golden), digests()) ? 0 : 1;
}
