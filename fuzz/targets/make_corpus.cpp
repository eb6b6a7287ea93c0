// Writes seeds of a target of cases: the first cases of each family in both precisions, each a file named by its hash.
//   make_corpus sphere|triangle|implicit FOLDER [CASES]     eight a family and precision unless said otherwise
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

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

std::optional<QueryGroup> group_named(std::string_view target) {
  if (target == "sphere") return QueryGroup::ray_sphere;
  if (target == "triangle") return QueryGroup::ray_triangle;
  if (target == "implicit") return QueryGroup::implicit;
  return std::nullopt;
}

/// Writes the case where it is of the group.
template <Real T>
bool write(QueryGroup group, const Family& family, std::uint64_t index, const std::filesystem::path& folder) {
  const Case<T> input = make<T>(family, seed, index).input;
  if (group_of(input.index()) != group) return true;
  const std::vector<std::uint8_t> bytes = encode_case(input);
  std::ofstream file(folder / hash_of(bytes), std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  return file.good();
}

bool write_corpus(QueryGroup group, const std::filesystem::path& folder, std::uint64_t cases) {
  std::filesystem::create_directories(folder);
  for (const Family& family : families()) {
    for (std::uint64_t index = 0; index < cases; ++index) {
      if (!write<float>(group, family, index, folder) || !write<double>(group, family, index, folder)) return false;
    }
  }
  return true;
}

}  // namespace
}  // namespace graze::fuzz

int main(int argc, char** argv) {
  // Families turn from shape to shape every fourth case.
  std::uint64_t cases = 8;
  const auto group = argc > 1 ? graze::fuzz::group_named(argv[1]) : std::nullopt;
  const bool is_understood =
      group && (argc == 3 || (argc == 4 && std::from_chars(argv[3], argv[3] + std::strlen(argv[3]), cases).ec == std::errc{}));
  if (!is_understood) {
    std::fprintf(stderr, "usage: %s sphere|triangle|implicit FOLDER [CASES]\n", argv[0]);
    return 2;
  }
  if (!graze::fuzz::write_corpus(*group, argv[2], cases)) {
    std::fprintf(stderr, "%s: cannot be written\n", argv[2]);
    return 2;
  }
  return 0;
}
