// libFuzzer's mutations of the bytes, and ours of the case, by turns.
#include <algorithm>
#include <cstddef>

#include "fuzz/targets/mutated_bytes.hpp"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned seed) {
  graze::fuzz::Random random(seed, "mutate", 0);
  if (random.one_in(2)) return LLVMFuzzerMutate(data, size, max_size);
  const std::vector<std::uint8_t> bytes = graze::fuzz::mutated_bytes({data, size}, random);
  const std::size_t kept = std::min(bytes.size(), max_size);
  std::copy_n(bytes.begin(), kept, data);
  return kept;
}
