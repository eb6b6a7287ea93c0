// Case lines: what is read, what is refused and why, what is written, and that it reads back to the same bits.
#include "fuzz/case_text.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "fuzz/case_numbers.hpp"
#include "fuzz/same_bits.hpp"
#include "tests/catch.hpp"

using namespace graze;
using namespace graze::fuzz;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

template <Real T = double>
Case<T> read(const std::string& line) {
  const auto parsed = parse_case<T>(line);
  CAPTURE(line);
  if (const auto* error = std::get_if<LineError>(&parsed)) INFO(error->what);
  REQUIRE(std::holds_alternative<Case<T>>(parsed));
  return std::get<Case<T>>(parsed);
}

std::string error(const std::string& line) {
  const auto parsed = parse_case<double>(line);
  return std::holds_alternative<LineError>(parsed) ? std::get<LineError>(parsed).what : "no error";
}

// One number as the protocol reads it.
template <Real T = double>
T number(const std::string& word) {
  return std::get<PointLine<T>>(read<T>("point_line " + word + " 0 0 0 0")).point.x;
}

template <Real T>
std::vector<T> numbers_of(const Case<T>& input) {
  std::vector<T> numbers;
  std::visit([&](const auto& query) { for_each_number(query, [&](const T& x) { numbers.push_back(x); }); }, input);
  return numbers;
}

template <Real T>
bool same_case(const Case<T>& a, const Case<T>& b) {
  if (a.index() != b.index()) return false;
  const auto x = numbers_of(a);
  const auto y = numbers_of(b);
  for (std::size_t i = 0; i < x.size(); ++i) {
    // A NaN reads back as some NaN.
    if (!same_bits(x[i], y[i]) && !(std::isnan(x[i]) && std::isnan(y[i]))) return false;
  }
  return true;
}

// Cases of all queries from the generator of numbers.
template <Real T, class Next>
std::vector<Case<T>> cases_from(Next next) {
  std::vector<Case<T>> cases = {RaySphere<T>{}, RayTriangle<T>{}, PointLine<T>{}, PointPlane<T>{}, PointSphere<T>{}};
  for (Case<T>& input : cases) std::visit([&](auto& query) { for_each_number(query, [&](T& x) { x = next(); }); }, input);
  return cases;
}

template <Real T>
void check_round_trip(const Case<T>& input) {
  for (const NumberForm form : {NumberForm::hexadecimal, NumberForm::shortest}) {
    const std::string line = format_case(input, form);
    CAPTURE(line);
    CHECK(same_case(read<T>(line), input));
  }
}

}  // namespace

TEST_CASE("each query is read into its case, in the order of the contract") {
  CHECK(read("ray_sphere 1 2 3 4 5 6 7 8 9 10") == Case<double>(RaySphere<double>{{{1, 2, 3}, {4, 5, 6}}, {{7, 8, 9}, 10}}));
  CHECK(read("ray_sphere 1 2 3 4 5 6 7 8 9 10 11 12") ==
        Case<double>(RaySphere<double>{{{1, 2, 3}, {4, 5, 6}, 11, 12}, {{7, 8, 9}, 10}}));
  CHECK(read("ray_triangle 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15") ==
        Case<double>(RayTriangle<double>{{{1, 2, 3}, {4, 5, 6}}, {{7, 8, 9}, {10, 11, 12}, {13, 14, 15}}}));
  CHECK(read("ray_triangle 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17") ==
        Case<double>(RayTriangle<double>{{{1, 2, 3}, {4, 5, 6}, 16, 17}, {{7, 8, 9}, {10, 11, 12}, {13, 14, 15}}}));
  CHECK(read("point_line 1 2 3 4 5") == Case<double>(PointLine<double>{{1, 2}, {3, 4, 5}}));
  CHECK(read("point_plane 1 2 3 4 5 6 7") == Case<double>(PointPlane<double>{{1, 2, 3}, {4, 5, 6, 7}}));
  CHECK(read("point_sphere 1 2 3 4 5 6 7") == Case<double>(PointSphere<double>{{1, 2, 3}, {{4, 5, 6}, 7}}));
}

TEST_CASE("a ray without a range starts at 0 and has no end") {
  const auto query = std::get<RaySphere<float>>(read<float>("ray_sphere 0 0 0 1 0 0 5 0 0 1"));
  CHECK(same_bits(query.ray.t_min, 0.0F));
  CHECK(query.ray.t_max == std::numeric_limits<float>::infinity());
}

TEST_CASE("words are parted by any blanks, and the line may end with CR") {
  const Case<double> wanted = PointLine<double>{{1, 2}, {3, 4, 5}};
  CHECK(read("  point_line\t1  2 \t 3 4 5  ") == wanted);
  CHECK(read("point_line 1 2 3 4 5\r") == wanted);
  CHECK(read("point_line 1 2 3 4 5\r\n") == wanted);
}

TEST_CASE("blank lines and comments are skipped, and nothing else") {
  for (const char* line : {"", " ", "\t \r", "#", "# ray_sphere", "  # indented", "#\r"}) CHECK(is_skipped(line));
  for (const char* line : {"ray_sphere", "1 # 2", "-", "\xef\xbb\xbf"}) CHECK(!is_skipped(line));
  CHECK(!is_skipped(std::string(1, '\0')));
}

TEST_CASE("numbers are decimals and hexadecimal floats, inf and nan") {
  CHECK(number("0.1") == 0.1);
  CHECK(number("+.5e1") == 5);
  CHECK(number("5.") == 5);
  CHECK(number("0x1.8p+1") == 3);
  CHECK(number("-0X1.8P-1") == -0.75);
  CHECK(number("0x.1") == 0.0625);
  CHECK(number("inf") == inf);
  CHECK(number("-INF") == -inf);
  CHECK(number("infinity") == inf);
  CHECK(std::isnan(number("nan")));
  CHECK(std::isnan(number("-NaN")));
  CHECK(same_bits(number("-0"), -0.0));
  CHECK(same_bits(number("0"), 0.0));
}

TEST_CASE("numbers out of the range read as infinity, subnormal or 0") {
  CHECK(number("1e309") == inf);
  CHECK(number("-1e400") == -inf);
  CHECK(number("0x1p1024") == inf);
  CHECK(number("1e99999999999999999999") == inf);
  CHECK(number<float>("1e39") == std::numeric_limits<float>::infinity());
  CHECK(number("5e-324") == std::numeric_limits<double>::denorm_min());
  CHECK(number("0x1p-1074") == std::numeric_limits<double>::denorm_min());
  CHECK(number<float>("1e-45") == std::numeric_limits<float>::denorm_min());
  CHECK(same_bits(number("1e-400"), 0.0));
  CHECK(same_bits(number("-1e-99999999999999999999"), -0.0));
}

TEST_CASE("numbers are rounded correctly, once") {
  // 1 + 2^-53 is a tie and goes to even; a digit more, 700 places on, decides it.
  const std::string tie = "1.00000000000000011102230246251565404236316680908203125";
  CHECK(number(tie) == 1);
  CHECK(number(tie + std::string(700, '0') + "1") == 1 + 0x1p-52);
  CHECK(number("0x1.00000000000008p0") == 1);
  CHECK(number("0x1.000000000000080000000000000000001p0") == 1 + 0x1p-52);
  // 1 + 2^-24 + 2^-60 rounds up in float, but by way of double it would be the tie and go down.
  CHECK(number<float>("0x1.000001000000001p0") == 1 + 0x1p-23F);
  // Half of the least subnormal is a tie to 0.
  CHECK(same_bits(number("0x1p-1075"), 0.0));
  CHECK(number("0x1.0000001p-1075") == std::numeric_limits<double>::denorm_min());
  // The largest number and half a unit more: a tie that goes to infinity.
  CHECK(number("0x1.fffffffffffff7fp1023") == std::numeric_limits<double>::max());
  CHECK(number("0x1.fffffffffffff8p1023") == inf);
}

TEST_CASE("a line that is no case is refused with what is wrong") {
  const std::string queries = "; the queries are ray_sphere, ray_triangle, point_line, point_plane, point_sphere";
  CHECK(error("ray_cube 1 2 3") == "unknown query 'ray_cube'" + queries);
  CHECK(error("Ray_sphere") == "unknown query 'Ray_sphere'" + queries);
  CHECK(error("1 2 3") == "unknown query '1'" + queries);
  CHECK(error("") == "the line is blank, where a case is wanted");
  CHECK(error("point_line 1 2 3 4") == "point_line takes 5 numbers, px py a b c; this line has 4");
  CHECK(error("point_line 1 2 3 4 5 6") == "point_line takes 5 numbers, px py a b c; this line has 6");
  CHECK(error("point_plane") == "point_plane takes 7 numbers, px py pz a b c d; this line has 0");
  CHECK(error("point_sphere 1") == "point_sphere takes 7 numbers, px py pz cx cy cz r; this line has 1");
  const std::string sphere =
      "ray_sphere takes 10 numbers, ex ey ez dx dy dz cx cy cz r, or 12 with t_min t_max; this line has ";
  CHECK(error("ray_sphere 1 2 3 4 5 6 7 8 9") == sphere + "9");
  CHECK(error("ray_sphere 1 2 3 4 5 6 7 8 9 10 11") == sphere + "11");
  CHECK(error("ray_sphere 1 2 3 4 5 6 7 8 9 10 11 12 13") == sphere + "13");
  CHECK(
      error("ray_triangle 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16") ==
      "ray_triangle takes 15 numbers, ex ey ez dx dy dz ax ay az bx by bz cx cy cz, or 17 with t_min t_max; this line has 16");
}

TEST_CASE("a word that is no number is named with the place that it stands at") {
  CHECK(error("point_line 1 two 3 4 5") == "'two' is no number (py of point_line)");
  CHECK(error("ray_sphere x") == "'x' is no number (ex of ray_sphere)");
  CHECK(error("ray_sphere 1 2 3 4 5 6 7 8 9 10 0 never") == "'never' is no number (t_max of ray_sphere)");
  CHECK(error("ray_triangle 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 # 17") == "'#' is no number (t_min of ray_triangle)");
  for (const char* word : {"1,5", "1e", "0x", "0x1p", "1f", "--1", "1-2", ".", "1_000", "in", "nanx", "1;"}) {
    CHECK(error("point_line " + std::string(word) + " 0 0 0 0") ==
          std::string("'").append(word).append("' is no number (px of point_line)"));
  }
}

TEST_CASE("messages are printable and short, whatever the line holds") {
  CHECK(error(std::string("point_line 1\0 2 3 4 5", 21)) == "'1\\x00' is no number (px of point_line)");
  CHECK(error("point_line \x1b[31m 2 3 4 5") == "'\\x1b[31m' is no number (px of point_line)");
  CHECK(error("\xef\xbb\xbfpoint_line 1 2 3 4 5").substr(0, 38) == "unknown query '\\xef\\xbb\\xbfpoint_line'");
  CHECK(error("point_line " + std::string(100000, 'z')) ==
        std::string("'").append(40, 'z').append("...' is no number (px of point_line)"));
}

TEST_CASE("numbers are written in the shortest decimals or in hexadecimal") {
  const auto shortest = [](auto x) { return format_number(x, NumberForm::shortest); };
  CHECK(shortest(0.1) == "0.1");
  CHECK(shortest(0.1F) == "0.1");
  CHECK(shortest(1e300) == "1e+300");
  CHECK(shortest(5.0) == "5");
  CHECK(shortest(-0.0) == "-0");
  CHECK(shortest(1.0 / 3) == "0.3333333333333333");
  CHECK(shortest(1.0F / 3) == "0.33333334");
  CHECK(shortest(5e-324) == "5e-324");
  CHECK(shortest(inf) == "inf");
  CHECK(shortest(-inf) == "-inf");
  CHECK(shortest(not_a_number) == "nan");
  CHECK(shortest(-not_a_number) == "nan");
  const auto hexadecimal = [](auto x) { return format_number(x, NumberForm::hexadecimal); };
  CHECK(hexadecimal(3.0) == "0x1.8p+1");
  CHECK(hexadecimal(-0.75F) == "-0x1.8p-1");
  CHECK(hexadecimal(0.0) == "0x0p+0");
  CHECK(hexadecimal(-0.0F) == "-0x0p+0");
  CHECK(hexadecimal(-inf) == "-inf");
  CHECK(hexadecimal(not_a_number) == "nan");
}

TEST_CASE("a case line is the query and its numbers") {
  const Case<double> input = RaySphere<double>{{{0, 1, 0.5}, {1, 0, 0}}, {{5, 0, 0}, 1}};
  CHECK(format_case(input, NumberForm::shortest) == "ray_sphere 0 1 0.5 1 0 0 5 0 0 1");
  CHECK(format_case(input) == "ray_sphere 0x0p+0 0x1p+0 0x1p-1 0x1p+0 0x0p+0 0x0p+0 0x1.4p+2 0x0p+0 0x0p+0 0x1p+0");
  CHECK(query_name(input) == "ray_sphere");
  CHECK(format_case(Case<float>(PointLine<float>{{3, 6}, {2, 3, 4}}), NumberForm::shortest) == "point_line 3 6 2 3 4");
}

TEST_CASE("a range is written unless it is the default to the bit") {
  RaySphere<double> query{{{0, 0, 0}, {1, 0, 0}}, {{5, 0, 0}, 1}};
  const auto line = [&] { return format_case(Case<double>(query), NumberForm::shortest); };
  CHECK(line() == "ray_sphere 0 0 0 1 0 0 5 0 0 1");
  query.ray.t_max = 7;
  CHECK(line() == "ray_sphere 0 0 0 1 0 0 5 0 0 1 0 7");
  query.ray = {query.ray.origin, query.ray.direction, -0.0, inf};
  CHECK(line() == "ray_sphere 0 0 0 1 0 0 5 0 0 1 -0 inf");
  query.ray.t_min = not_a_number;
  CHECK(line() == "ray_sphere 0 0 0 1 0 0 5 0 0 1 nan inf");
}

TEST_CASE("cases read back to the same bits: special numbers") {
  const auto check = []<class T>(T) {
    using limits = std::numeric_limits<T>;
    for (const T special : {T(0), T(-0.0), limits::denorm_min(), -limits::denorm_min(), limits::min(),
                            std::nextafter(limits::min(), T(0)), limits::max(), limits::lowest(), limits::epsilon(), T(1) / 3,
                            limits::infinity(), -limits::infinity(), limits::quiet_NaN()}) {
      for (const Case<T>& input : cases_from<T>([&] { return special; })) check_round_trip(input);
    }
  };
  check(double{});
  check(float{});
}

TEST_CASE("cases read back to the same bits: random bit patterns") {
  std::mt19937_64 random(20240607);
  INFO("std::mt19937_64 seeded with 20240607");
  for (int i = 0; i < 2000; ++i) {
    for (const auto& input : cases_from<double>([&] { return std::bit_cast<double>(random()); })) check_round_trip(input);
    for (const auto& input : cases_from<float>([&] { return std::bit_cast<float>(static_cast<std::uint32_t>(random())); })) {
      check_round_trip(input);
    }
    // Subnormal numbers alone.
    for (const auto& input : cases_from<double>([&] { return std::bit_cast<double>(random() >> 12 >> (random() % 52)); })) {
      check_round_trip(input);
    }
  }
}
