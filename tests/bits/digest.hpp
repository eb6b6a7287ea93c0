// A digest of the kernel's answers to streams of cases, one of each family and precision, and how it is held against another.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <iostream>
#include <map>
#include <string>

#include "fuzz/case_numbers.hpp"
#include "fuzz/float_mode.hpp"
#include "fuzz/kernel_calls.hpp"

namespace graze::fuzz {

inline constexpr std::uint64_t digest_seed = 20240229, cases_of_a_stream = 2000;

/// FNV-1a, eight bytes at a time. Numbers come by reference: x87 changes a signalling NaN that it moves.
class Hash {
 public:
  void add(std::uint64_t word) {
    for (int byte = 0; byte < 8; ++byte) state_ = (state_ ^ ((word >> (8 * byte)) & 0xff)) * 0x100000001b3;
  }
  void add(const float& x) { add(std::uint64_t{std::bit_cast<std::uint32_t>(x)}); }
  void add(const double& x) { add(std::bit_cast<std::uint64_t>(x)); }
  template <class Enum>
  requires std::is_enum_v<Enum>
  void add(Enum value) { add(static_cast<std::uint64_t>(value)); }
  template <Real T>
  void add(const SphereHit<T>& hit) {
    add(hit.status), add(hit.kind), add(hit.root), add(hit.origin), add(hit.t[0]), add(hit.t[1]);
  }
  template <Real T>
  void add(const TriangleHit<T>& hit) {
    add(hit.status), add(hit.kind), add(hit.facing), add(hit.t), add(hit.t_end), add(hit.u), add(hit.v);
  }
  void add(const Side& side) { add(side.status), add(side.sign); }

  [[nodiscard]] std::string text() const {
    char digits[17];
    std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(state_));
    return digits;
  }

 private:
  std::uint64_t state_ = 0xcbf29ce484222325;
};

/// Of one family in one precision.
struct Digest {
  std::string inputs, answers;    // in the default mode
  std::string unlike_modes = {};  // those whose answers differ
  bool operator==(const Digest&) const = default;
};
/// By family and precision.
using Digests = std::map<std::string, Digest>;

template <Real T>
void add_input(const Case<T>& input, Hash& hash) {
  hash.add(std::uint64_t{input.index()});
  std::visit([&](const auto& query) { for_each_number(query, [&](const T& x) { hash.add(x); }); }, input);
}

template <Real T>
void add_answer(const Case<T>& input, FloatMode mode, Hash& hash) {
  const KernelAnswer<T> kernel = [&] {
    const FloatModeScope scope(mode);
    return kernel_answer(input);
  }();
  std::visit([&](const auto& answer) { hash.add(answer); }, kernel.answer);
  hash.add(std::uint64_t{kernel.hits});
}

/// Takes one stream's cases.
class StreamDigest {
 public:
  template <Real T>
  void add(const Case<T>& input) {
    add_input(input, inputs_);
    for (std::size_t i = 0; i < answers_.size(); ++i) add_answer(input, float_modes[i], answers_[i]);
  }

  [[nodiscard]] Digest digest() const {
    Digest digest{inputs_.text(), answers_[0].text()};
    for (std::size_t i = 1; i < answers_.size(); ++i) {
      if (answers_[i].text() != answers_[0].text()) digest.unlike_modes.append("; ").append(name_of(float_modes[i]));
    }
    return digest;
  }

 private:
  Hash inputs_;
  std::array<Hash, float_modes.size()> answers_;
};

/// With a line of what they are of and which program has made them.
inline void print(const Digests& all, const char* of, const char* maker) {
  std::cout << "# family precision, hash of " << of << ", hash of their answers; made by " << maker << ", seed " << digest_seed
            << '\n';
  for (const auto& [name, digest] : all) std::cout << name << ' ' << digest.inputs << ' ' << digest.answers << '\n';
}

inline Digests read(std::istream& file) {
  Digests all;
  std::string line, family, precision;
  Digest digest;
  while (file >> family) {
    if (family.front() == '#') {
      std::getline(file, line);
    } else if (file >> precision >> digest.inputs >> digest.answers) {
      all[family.append(" ").append(precision)] = digest;
    }
  }
  return all;
}

/// Whether every mode gives the default one's answers; tells where not.
inline bool are_modes_alike(const Digests& all) {
  bool alike = true;
  for (const auto& [name, digest] : all) {
    if (digest.unlike_modes.empty()) continue;
    std::cerr << name << ": the answers depend on the mode" << digest.unlike_modes << '\n';
    alike = false;
  }
  return alike;
}

inline bool are_same(const Digests& golden, const Digests& ours) {
  int other_inputs = 0, other_answers = 0;
  for (const auto& [name, digest] : ours) {
    const auto at = golden.find(name);
    if (at == golden.end() || at->second.inputs != digest.inputs) {
      std::cerr << name << ": the cases are others\n";
      ++other_inputs;
    } else if (at->second.answers != digest.answers) {
      std::cerr << name << ": the answers are others\n";
      ++other_answers;
    }
  }
  if (other_inputs != 0) {
    std::cerr
        << "The cases are not those of the golden file. Where they were changed, make it anew by the program that its first "
           "line names.\nElse they depend on the compiler.\n";
  }
  if (other_answers != 0) std::cerr << "The same cases have other answers: the bits depend on the build.\n";
  if (golden.size() != ours.size()) {
    std::cerr << "The golden file has " << golden.size() << " lines where there are " << ours.size() << '\n';
  }
  return other_inputs == 0 && other_answers == 0 && golden.size() == ours.size();
}

/// Whether all is well; what is not is told on standard error.
inline bool is_well(const Digests& golden, const Digests& ours) {
  const bool alike = are_modes_alike(ours), same = are_same(golden, ours);
  return alike && same;
}

}  // namespace graze::fuzz
