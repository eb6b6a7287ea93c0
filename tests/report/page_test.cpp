// Pages and JUnit files: what they say, and that no text escapes into markup.
#include "fuzz/report/page.hpp"

#include <algorithm>

#include "fuzz/report/junit.hpp"
#include "fuzz/report/markup.hpp"
#include "fuzz/report/side_by_side.hpp"
#include "tests/campaign/generated.hpp"
#include "tests/catch.hpp"

namespace graze::fuzz {
namespace {

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) ++n;
  return n;
}

Report hostile() {
  Report report = of_shard({1, 1});
  const std::string attack = "</pre></style><script>alert('&\"1')</script>";
  report.scope.kernel = report.scope.about = report.scope.compiler = attack;
  report.cpus = {attack};
  for (Row& row : report.rows) {
    row.name = attack + row.name;
    for (Part& part : row.parts) {
      for (Offender& o : part.tally.offenders) o.input = o.answer = o.truth = attack + std::string("\x01");
    }
  }
  return report;
}

TEST_CASE("no text becomes markup") {
  CHECK(escaped("<a href='x'>\"&\x01\n") == "&lt;a href=&#39;x&#39;&gt;&quot;&amp; \n");
  const Report report = hostile();
  for (const std::string& text : {page(report), comparison_page(std::vector<Report>{report, report}), junit(report)}) {
    CHECK(has(text, "&lt;script&gt;"));
    CHECK_FALSE(has(text, "<script"));
    CHECK_FALSE(has(text, "\x01"));
    CHECK(count(text, "</style>") == count(text, "<style>"));
  }
}

TEST_CASE("a page takes nothing from elsewhere") {
  for (const std::string& text :
       {page(of_shard({1, 1})), comparison_page(std::vector<Report>{cleaned(of_shard({1, 1})), of_shard({1, 1})})}) {
    for (const char* part : {"http:", "https:", "src=", "url(", "@import", "<script", "<link rel=\"stylesheet"})
      CHECK_FALSE(has(text, part));
  }
}

TEST_CASE("a page that passes says what that is worth") {
  const std::string text = page(cleaned(of_shard({1, 1})));
  CHECK(has(text, "PASS"));
  // 63 answers: 3/63.
  CHECK(has(text, "63 answers to n = 31 cases. By the rule of three, of cases drawn like these less than 3/n = 0.097"));
  CHECK(has(text, "&lt; 15 %"));
  CHECK_FALSE(has(text, "worst offenders"));
}

TEST_CASE("a page that fails tells of what, in hex, with the replay, and how many more there are") {
  const Report report = of_shard({1, 1});
  const std::string text = page(report);
  CHECK(has(text, "FAIL"));
  CHECK(has(text, "echo &#39;input "));
  CHECK(has(text, "The worst of 2 rows out of 2 that have any; the JSON report has 6, up to 3 a row."));
  CHECK(has(text, "no way in"));
}

TEST_CASE("an unfinished page says so") {
  CHECK(has(page(of_shard({1, 1}, 5)), "was interrupted"));
  CHECK_FALSE(has(page(of_shard({1, 2})), "was interrupted"));
}

TEST_CASE("a comparison has all kernels in all tables") {
  Report other = cleaned(of_shard({1, 1}));
  other.scope.kernel = "another";
  const std::vector<Report> reports{of_shard({1, 1}), other};
  const std::string text = comparison_page(reports);
  CHECK(has(text, "2 kernels"));
  // Summary, two precisions, and the list of kernels; the one that fails has a worst case too.
  CHECK(count(text, ">another<") == 4);
  CHECK(count(text, ">made-up<") == 5);
}

TEST_CASE("shares never round to none or all") {
  CHECK(percent(0, 10) == "0 %");
  CHECK(percent(10, 10) == "100 %");
  CHECK(percent(1, 1000000) == "0.0001 %");
  CHECK(percent(999999, 1000000) == "99.9 %");
  CHECK(percent(1, 3) == "33.3 %");
}

TEST_CASE("JUnit counts failures, errors and what is skipped") {
  const std::string failing = junit(of_shard({1, 1}));
  CHECK(count(failing, "<testcase ") == 3);
  CHECK(count(failing, "<failure ") == 2);
  CHECK(has(failing, "tests=\"3\" failures=\"2\" errors=\"1\" skipped=\"0\""));
  CHECK(has(failing, "<error message=\"no way in\"/>"));
  CHECK(has(junit(cleaned(of_shard({1, 1}))), "tests=\"3\" failures=\"0\" errors=\"0\" skipped=\"1\""));
  Report part = cleaned(of_shard({1, 1}));
  part.rows[0].parts[0].range.to = 20;
  CHECK(has(junit(part), "<error message=\"interrupted\"/>"));
}

}  // namespace
}  // namespace graze::fuzz
