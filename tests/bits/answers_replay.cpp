// The digest of the kernel's answers to cases that answers_digest wrote, for machines that the families are not built for.
//   answers_replay CASES GOLDEN
// Exit status: 0 all is as in the golden file, 1 not, 2 a file cannot be read.
#include <fstream>

#include "tests/bits/case_stream.hpp"

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
  const Digests ours = replayed(cases, []<graze::Real>() { return StreamDigest(); });
  if (ours.empty()) {
    std::cerr << argv[1] << ": is cut short\n";
    return 2;
  }
  return is_well(read(golden), ours) ? 0 : 1;
}
