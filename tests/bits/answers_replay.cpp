// The digest of the kernel's answers to cases that answers_digest wrote, for machines that the families are not built for.
//   answers_replay CASES GOLDEN
// Exit status: 0 all is as in the golden file, 1 not, 2 a file cannot be read.
#include <fstream>

#include "tests/bits/case_stream.hpp"
#include "tests/bits/digest.hpp"

namespace graze::fuzz {
namespace {

template <Real T>
Digest digest_of(std::istream& cases) {
  StreamDigest stream;
  for (std::uint64_t index = 0; index < cases_of_a_stream && cases; ++index) stream.add(read_case<T>(cases));
  return stream.digest();
}

/// All streams; the file is left bad where it is cut short.
Digests digests(std::istream& cases) {
  Digests all;
  for (std::string name; std::getline(cases, name);) {
    all[name] = name.ends_with(" float") ? digest_of<float>(cases) : digest_of<double>(cases);
    if (!cases) return {};
  }
  return all;
}

}  // namespace
}  // namespace graze::fuzz

int main(int argc, char** argv) {
  using namespace graze::fuzz;
  if (argc != 3) {
    std::cerr << "usage: answers_replay CASES GOLDEN\n";
    return 2;
  }
  std::ifstream cases(argv[1], std::ios::binary), golden(argv[2]);
  if (!cases || !golden) {
    std::cerr << (cases ? argv[2] : argv[1]) << ": cannot be read\n";
    return 2;
  }
  const Digests ours = digests(cases);
  if (ours.empty()) {
    std::cerr << argv[1] << ": is cut short\n";
    return 2;
  }
  return is_well(read(golden), ours) ? 0 : 1;
}
