// Writes seeds of a target of cases: the first cases of each family in both precisions, each a file named by its hash.
//   make_corpus sphere|triangle|implicit|batch FOLDER [CASES]     eight a family and precision unless said otherwise
// Those of batch are batches of that many cases.
#include <algorithm>
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

using Bytes = std::vector<std::uint8_t>;

bool write(const Bytes& bytes, const std::filesystem::path& folder) {
  std::ofstream file(folder / hash_of(bytes), std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  return file.good();
}

/// The first cases of the family, those that are of the group.
template <Real T>
std::vector<Bytes> encoded(QueryGroup group, const Family& family, std::uint64_t cases) {
  std::vector<Bytes> all;
  for (std::uint64_t index = 0; index < cases; ++index) {
    const Case<T> input = make<T>(family, seed, index).input;
    if (group_of(input.index()) == group) all.push_back(encode_case(input));
  }
  return all;
}

/// The cases as one batch, by targets/batch.cpp. `number` chooses form, floating-point mode and offset.
Bytes batch_of(QueryGroup group, const std::vector<Bytes>& cases, std::uint8_t number) {
  constexpr std::uint8_t sphere_bit = 0x80, forms_and_modes = 15, least = 4;
  std::size_t longest = least;
  for (const Bytes& one : cases) longest = std::max(longest, one.size());
  Bytes batch{static_cast<std::uint8_t>((group == QueryGroup::ray_sphere ? sphere_bit : 0) | number % forms_and_modes), number,
              static_cast<std::uint8_t>(longest - least)};
  for (const Bytes& one : cases) {
    batch.insert(batch.end(), one.begin(), one.end());
    batch.resize(batch.size() + longest - one.size());
  }
  return batch;
}

template <Real T>
bool write_cases(QueryGroup group, const std::filesystem::path& folder, std::uint64_t cases) {
  for (const Family& family : families()) {
    for (const Bytes& one : encoded<T>(group, family, cases)) {
      if (!write(one, folder)) return false;
    }
  }
  return true;
}

template <Real T>
bool write_batches(const std::filesystem::path& folder, std::uint64_t cases) {
  std::uint8_t number = sizeof(T);
  for (const Family& family : families()) {
    for (const QueryGroup group : {QueryGroup::ray_sphere, QueryGroup::ray_triangle}) {
      const std::vector<Bytes> all = encoded<T>(group, family, cases);
      if (!all.empty() && !write(batch_of(group, all, number++), folder)) return false;
    }
  }
  return true;
}

}  // namespace
}  // namespace graze::fuzz

int main(int argc, char** argv) {
  // Families turn from shape to shape every fourth case.
  std::uint64_t cases = 8;
  using namespace graze::fuzz;
  const std::string_view target = argc > 1 ? argv[1] : "";
  const auto group = group_named(target);
  const bool is_understood =
      (group || target == "batch") &&
      (argc == 3 || (argc == 4 && std::from_chars(argv[3], argv[3] + std::strlen(argv[3]), cases).ec == std::errc{}));
  if (!is_understood) {
    std::fprintf(stderr, "usage: %s sphere|triangle|implicit|batch FOLDER [CASES]\n", argv[0]);
    return 2;
  }
  const std::filesystem::path folder = argv[2];
  std::filesystem::create_directories(folder);
  const bool is_written = group ? write_cases<float>(*group, folder, cases) && write_cases<double>(*group, folder, cases)
                                : write_batches<float>(folder, cases) && write_batches<double>(folder, cases);
  if (!is_written) {
    std::fprintf(stderr, "%s: cannot be written\n", argv[2]);
    return 2;
  }
  return 0;
}
