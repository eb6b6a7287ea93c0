// The regression corpus through the library: every answer is the one that is kept, and the one of both oracles.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/support/agreement.hpp"

namespace graze::test {
namespace {

namespace files = std::filesystem;

template <Real T>
files::path folder() {
  return files::path(GRAZE_CORPUS) / (std::same_as<T, float> ? "float" : "double");
}

std::vector<std::string> lines_of(const files::path& path) {
  std::ifstream file(path);
  CAPTURE(path.string());
  REQUIRE(file.good());
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

template <Real T>
std::vector<files::path> case_files() {
  std::vector<files::path> paths;
  for (const auto& entry : files::directory_iterator(folder<T>())) {
    if (entry.path().extension() == ".case") paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

files::path answers_path(files::path cases) {
  return cases.replace_extension(".answers");
}

template <Real T>
fuzz::Case<T> parsed(const std::string& line) {
  CAPTURE(line);
  const auto result = fuzz::parse_case<T>(line);
  REQUIRE(std::holds_alternative<fuzz::Case<T>>(result));
  return std::get<fuzz::Case<T>>(result);
}

/// The case lines of a file.
std::vector<std::string> case_lines(const files::path& path) {
  std::vector<std::string> lines = lines_of(path);
  std::erase_if(lines, [](const std::string& line) { return fuzz::is_skipped(line); });
  return lines;
}

/// The line of the answer on which both oracles agree.
template <Real T>
std::string agreed_answer(const fuzz::Case<T>& input) {
  const fuzz::Answer<T> gmp = fuzz::answer_of(oracle::gmp_oracle(), input),
                        cgal = fuzz::answer_of(oracle::cgal_oracle(), input);
  REQUIRE(fuzz::same_bits(gmp, cgal));
  return fuzz::format_answer(input, gmp, fuzz::Details::yes);
}

TEST_CASE("Every case of the corpus has the answer that is kept, in every environment") {
  in_both_formats([]<Real T>() {
    int count = 0;
    for (const files::path& path : case_files<T>()) {
      CAPTURE(path.string());
      const std::vector<std::string> cases = case_lines(path), answers = lines_of(answers_path(path));
      REQUIRE(cases.size() == answers.size());
      for (std::size_t i = 0; i < cases.size(); ++i) {
        CAPTURE(cases[i]);
        const fuzz::Case<T> input = parsed<T>(cases[i]);
        CHECK(fuzz::format_answer(input, fuzz::kernel_answer(input).answer, fuzz::Details::yes) == answers[i]);
        CHECK(agreed_answer(input) == answers[i]);
        require_agreement_in_all_environments(input);
        ++count;
      }
    }
    CHECK(count > 200);
  });
}

TEST_CASE("Every case of the corpus tells where it is from and since when, in numbers that keep their bits") {
  in_both_formats([]<Real T>() {
    for (const files::path& path : case_files<T>()) {
      CAPTURE(path.string());
      const std::vector<std::string> lines = lines_of(path);
      bool has_date = false;
      for (std::size_t i = 0; i < lines.size(); ++i) {
        has_date = has_date || lines[i].rfind("# Kept since 20", 0) == 0;
        if (fuzz::is_skipped(lines[i])) continue;
        CAPTURE(i + 1, lines[i]);
        CHECK(has_date);
        CHECK((i > 0 && lines[i - 1].rfind("# ", 0) == 0));
        CHECK(fuzz::format_case(parsed<T>(lines[i])) == lines[i]);
      }
    }
  });
}

TEST_CASE("Write the answers of the corpus", "[.answers]") {
  in_both_formats([]<Real T>() {
    for (const files::path& path : case_files<T>()) {
      std::ofstream file(answers_path(path));
      for (const std::string& line : case_lines(path)) file << agreed_answer(parsed<T>(line)) << '\n';
      CHECK(file.good());
    }
  });
}

}  // namespace
}  // namespace graze::test
