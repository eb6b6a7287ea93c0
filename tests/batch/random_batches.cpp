// Batches of random length, form, shape, format, alignment, floating-point mode and instruction set, of the families' cases,
// against the single query.
//   random_batches [BATCHES [SEED]]    100000 and 1 unless said otherwise
// Exit status: 0 all agree, 1 one does not, 2 usage error.
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <optional>
#include <vector>

#include "batch/targets.hpp"
#include "fuzz/batch_check.hpp"
#include "hwy/highway.h"

namespace graze::fuzz {
namespace {

std::optional<std::string> check(Random& random) {
  constexpr std::size_t longest = 2200;
  switch (random.below(4)) {
    case 0:
      return find_batch_fault(random_batch<float, Triangle>(random, longest));
    case 1:
      return find_batch_fault(random_batch<double, Triangle>(random, longest));
    case 2:
      return find_batch_fault(random_batch<float, Sphere>(random, longest));
    default:
      return find_batch_fault(random_batch<double, Sphere>(random, longest));
  }
}

int run(std::uint64_t batches, std::uint64_t seed) {
  std::vector<std::int64_t> targets;
  for (std::int64_t left = hwy::SupportedTargets() & HWY_TARGETS; left != 0; left &= left - 1) targets.push_back(left & -left);
  for (std::uint64_t i = 0; i < batches; ++i) {
    Random random(seed, "batches", i);
    const std::int64_t target = targets[random.below(targets.size())];
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().DeInit();
    if (const auto fault = check(random)) {
      std::printf("batch %llu of seed %llu, %s: %s\n", static_cast<unsigned long long>(i),
                  static_cast<unsigned long long>(seed), hwy::TargetName(target), fault->c_str());
      return 1;
    }
  }
  std::printf("%llu batches of seed %llu by %zu instruction sets: 0 discrepancies\n", static_cast<unsigned long long>(batches),
              static_cast<unsigned long long>(seed), targets.size());
  return 0;
}

bool read(const char* text, std::uint64_t& out) {
  const char* end = text + std::strlen(text);
  return std::from_chars(text, end, out).ptr == end && text != end;
}

}  // namespace
}  // namespace graze::fuzz

int main(int argc, char** argv) {
  std::uint64_t batches = 100000, seed = 1;
  if (argc > 3 || (argc > 1 && !graze::fuzz::read(argv[1], batches)) || (argc > 2 && !graze::fuzz::read(argv[2], seed))) {
    std::fprintf(stderr, "usage: random_batches [BATCHES [SEED]]\n");
    return 2;
  }
  return graze::fuzz::run(batches, seed);
}
