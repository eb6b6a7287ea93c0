// The reader of case lines. Each line of the bytes is read in both precisions: it is skipped, refused with a printable reason,
// or a case, which is written in both forms of number and must read back to the same bits.
#include "fuzz/case_text.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/case_numbers.hpp"
#include "fuzz/same_bits.hpp"

namespace graze::fuzz {
namespace {

[[noreturn]] void fail(std::string_view line, const char* what, const std::string& detail) {
  std::fprintf(stderr, "# %s: %s, of the line\n%.*s\n", what, detail.c_str(), static_cast<int>(line.size()), line.data());
  std::abort();
}

template <Real T>
std::vector<T> numbers_of(const Case<T>& input) {
  std::vector<T> numbers;
  std::visit([&](const auto& query) { for_each_number(query, [&](const T& x) { numbers.push_back(x); }); }, input);
  return numbers;
}

/// A NaN's bits are not part of the protocol.
template <Real T>
bool is_same(const Case<T>& a, const Case<T>& b) {
  const auto of_a = numbers_of(a), of_b = numbers_of(b);
  return a.index() == b.index() && std::equal(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(),
                                              [](T x, T y) { return same_bits(x, y) || (x != x && y != y); });
}

template <Real T>
void check_line(std::string_view line) {
  const auto read = parse_case<T>(line);
  if (const auto* error = std::get_if<LineError>(&read)) {
    const bool is_printable = std::all_of(error->what.begin(), error->what.end(), [](char c) { return c >= ' ' && c <= '~'; });
    if (error->what.empty() || !is_printable) fail(line, "an error that cannot be printed", error->what);
    return;
  }
  const auto& input = std::get<Case<T>>(read);
  for (const NumberForm form : {NumberForm::hexadecimal, NumberForm::shortest}) {
    const std::string written = format_case(input, form);
    const auto again = parse_case<T>(written);
    if (is_skipped(written) || !std::holds_alternative<Case<T>>(again)) fail(line, "cannot be read again", written);
    if (!is_same(std::get<Case<T>>(again), input)) fail(line, "reads back to another case", written);
  }
}

}  // namespace
}  // namespace graze::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace graze::fuzz;
  std::string_view text(reinterpret_cast<const char*>(data), size);
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(text.size(), line.size() + 1));
    if (is_skipped(line)) continue;
    check_line<float>(line);
    check_line<double>(line);
  }
  return 0;
}
