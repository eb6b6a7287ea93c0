// A digest of the kernel's answers to a fixed stream of cases: `intersect`, `hits` and `side`, all families, both precisions.
// All floating-point modes must give the same.
//   answers_digest           prints it: a line for each family and precision, with a hash of the cases and one of the answers
//   answers_digest GOLDEN    compares it with that file
// Exit status: 0 all is the same, 1 not, 2 the file cannot be read.
#include <array>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <map>
#include <string>

#include "fuzz/case_numbers.hpp"
#include "fuzz/family.hpp"
#include "fuzz/float_mode.hpp"
#include "fuzz/kernel_calls.hpp"

namespace graze::fuzz {
namespace {

constexpr std::uint64_t seed = 20240229, cases = 2000;

/// FNV-1a, eight bytes at a time.
class Hash {
 public:
  void add(std::uint64_t word) {
    for (int byte = 0; byte < 8; ++byte) state_ = (state_ ^ ((word >> (8 * byte)) & 0xff)) * 0x100000001b3;
  }
  void add(float x) { add(std::uint64_t{std::bit_cast<std::uint32_t>(x)}); }
  void add(double x) { add(std::bit_cast<std::uint64_t>(x)); }
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
void add_answer(const Case<T>& input, FloatMode mode, Hash& hash) {
  const KernelAnswer<T> kernel = [&] {
    const FloatModeScope scope(mode);
    return kernel_answer(input);
  }();
  std::visit([&](const auto& answer) { hash.add(answer); }, kernel.answer);
  hash.add(std::uint64_t{kernel.hits});
}

template <Real T>
Digest digest_of(const Family& family) {
  Hash inputs;
  std::array<Hash, float_modes.size()> answers;
  for (std::uint64_t index = 0; index < cases; ++index) {
    const Case<T> input = make<T>(family, seed, index).input;
    inputs.add(std::uint64_t{input.index()});
    std::visit([&](const auto& query) { for_each_number(query, [&](const T& x) { inputs.add(x); }); }, input);
    for (std::size_t i = 0; i < answers.size(); ++i) add_answer(input, float_modes[i], answers[i]);
  }
  Digest digest{inputs.text(), answers[0].text()};
  for (std::size_t i = 1; i < answers.size(); ++i) {
    if (answers[i].text() != answers[0].text()) digest.unlike_modes.append("; ").append(name_of(float_modes[i]));
  }
  return digest;
}

Digests digests() {
  Digests all;
  for (const Family& family : families()) {
    all[std::string(family.name) + " float"] = digest_of<float>(family);
    all[std::string(family.name) + " double"] = digest_of<double>(family);
  }
  return all;
}

void print(const Digests& all) {
  std::cout << "# family precision, hash of " << cases << " cases, hash of their answers; made by answers_digest, seed " << seed
            << '\n';
  for (const auto& [name, digest] : all) std::cout << name << ' ' << digest.inputs << ' ' << digest.answers << '\n';
}

Digests read(std::istream& file) {
  Digests all;
  std::string line, family, precision;
  Digest digest;
  while (file >> family) {
    if (family.front() == '#') {
      std::getline(file, line);
    } else if (file >> precision >> digest.inputs >> digest.answers) {
      all[family + ' ' + precision] = digest;
    }
  }
  return all;
}

/// Whether every mode gives the default one's answers; tells where not.
bool are_modes_alike(const Digests& all) {
  bool alike = true;
  for (const auto& [name, digest] : all) {
    if (digest.unlike_modes.empty()) continue;
    std::cerr << name << ": the answers depend on the mode" << digest.unlike_modes << '\n';
    alike = false;
  }
  return alike;
}

bool are_same(const Digests& golden, const Digests& ours) {
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
    std::cerr << "The cases are not those of the golden file. Where families were changed, make it anew: answers_digest > "
                 "tests/bits/golden.txt\nElse the families depend on the compiler.\n";
  }
  if (other_answers != 0) std::cerr << "The same cases have other answers: the bits depend on the build.\n";
  if (golden.size() != ours.size()) {
    std::cerr << "The golden file has " << golden.size() << " lines where there are " << ours.size() << '\n';
  }
  return other_inputs == 0 && other_answers == 0 && golden.size() == ours.size();
}

}  // namespace
}  // namespace graze::fuzz

int main(int argc, char** argv) {
  using namespace graze::fuzz;
  if (argc > 2) {
    std::cerr << "usage: answers_digest [GOLDEN]\n";
    return 2;
  }
  Digests golden;
  if (argc == 2) {
    std::ifstream file(argv[1]);
    if (!file) {
      std::cerr << argv[1] << ": cannot be read\n";
      return 2;
    }
    golden = read(file);
  }
  const Digests ours = digests();
  if (argc == 1) print(ours);
  const bool is_same = argc == 1 || are_same(golden, ours);
  return are_modes_alike(ours) && is_same ? 0 : 1;
}
