// Writes the seed corpus of the target `query`: the first cases of each family in both precisions, each a file named by its
// hash.
//   make_corpus FOLDER [CASES]     two a family and precision unless said otherwise
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

#include "fuzz/case_bytes.hpp"
#include "fuzz/family.hpp"

namespace graze::fuzz {
namespace {

constexpr std::uint64_t seed = 1;

/// FNV-1a.
std::string hash_of(const std::vector<std::uint8_t>& bytes) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const std::uint8_t byte : bytes) hash = (hash ^ byte) * 0x100000001b3;
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash));
  return digits;
}

template <Real T>
bool write(const Family& family, std::uint64_t index, const std::filesystem::path& folder) {
  const std::vector<std::uint8_t> bytes = encode_case(make<T>(family, seed, index).input);
  std::ofstream file(folder / hash_of(bytes), std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  return file.good();
}

/// Families turn from shape to shape every fourth case, and every fourth is exact.
bool write_corpus(const std::filesystem::path& folder, std::uint64_t cases) {
  std::filesystem::create_directories(folder);
  for (const Family& family : families()) {
    for (std::uint64_t index = 0; index < cases; ++index) {
      if (!write<float>(family, 4 * index, folder) || !write<double>(family, 4 * index + 1, folder)) return false;
    }
  }
  return true;
}

}  // namespace
}  // namespace graze::fuzz

int main(int argc, char** argv) {
  std::uint64_t cases = 2;
  const bool is_understood =
      argc == 2 || (argc == 3 && std::from_chars(argv[2], argv[2] + std::strlen(argv[2]), cases).ec == std::errc{});
  if (!is_understood) {
    std::fprintf(stderr, "usage: %s FOLDER [CASES]\n", argv[0]);
    return 2;
  }
  if (!graze::fuzz::write_corpus(argv[1], cases)) {
    std::fprintf(stderr, "%s: cannot be written\n", argv[1]);
    return 2;
  }
  return 0;
}
