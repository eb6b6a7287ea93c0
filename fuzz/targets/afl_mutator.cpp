// The mutator of cases as AFL++ loads it (AFL_CUSTOM_MUTATOR_LIBRARY): its own mutations of the bytes go on beside these.
#include <algorithm>
#include <cstddef>

#include "fuzz/targets/mutated_bytes.hpp"

namespace {

struct Mutator {
  unsigned seed;
  std::uint64_t calls = 0;
  std::vector<std::uint8_t> bytes = {};
};

}  // namespace

extern "C" void* afl_custom_init(void*, unsigned seed) {
  return new Mutator{seed};
}

extern "C" void afl_custom_deinit(void* mutator) {
  delete static_cast<Mutator*>(mutator);
}

extern "C" std::size_t afl_custom_fuzz(void* state, std::uint8_t* data, std::size_t size, std::uint8_t** out, std::uint8_t*,
                                       std::size_t, std::size_t max_size) {
  auto& mutator = *static_cast<Mutator*>(state);
  graze::fuzz::Random random(mutator.seed, "mutate", mutator.calls++);
  mutator.bytes = graze::fuzz::mutated_bytes({data, size}, random);
  *out = mutator.bytes.data();
  return std::min(mutator.bytes.size(), max_size);
}
