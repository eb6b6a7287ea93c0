// As answers_replay, by batches: pairs, one ray, one shape; by every instruction set of the processor, or, compiled for one
// alone, by that.
//   batch_replay CASES GOLDEN
// Exit status: 0 all is as in the golden file, 1 not, 2 a file cannot be read.
#include <fstream>

#include "tests/bits/batch_digest.hpp"
#include "tests/bits/case_stream.hpp"
#include "tests/bits/targets.hpp"

int main(int argc, char** argv) {
  using namespace graze::fuzz;
  if (argc != 3) {
    std::cerr << "usage: batch_replay CASES GOLDEN\n";
    return 2;
  }
  std::ifstream golden(argv[2]);
  if (!golden) {
    std::cerr << argv[2] << ": cannot be read\n";
    return 2;
  }
  const Digests wanted = read(golden);
  bool is_cut_short = false;
  const bool is_same = with_each_target([&](const char* target) {
    for (const auto& [call, name] :
         {std::pair{BatchCall::pairs, "pairs"}, {BatchCall::one_ray, "one ray"}, {BatchCall::one_shape, "one shape"}}) {
      std::ifstream cases(argv[1], std::ios::binary);
      const Digests ours = replayed(cases, [call = call]<graze::Real T>() { return BatchStreamDigest<T>(call); });
      is_cut_short = ours.empty();
      if (is_cut_short) return false;
      const bool is_well_here = is_well(wanted, ours);
      std::cerr << "batches, " << name << ", " << target << (is_well_here ? ": as they should be\n" : ": not so\n");
      if (!is_well_here) return false;
    }
    return true;
  });
  if (is_cut_short) {
    std::cerr << argv[1] << ": cannot be read, or is cut short\n";
    return 2;
  }
  return is_same ? 0 : 1;
}
