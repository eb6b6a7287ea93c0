// Cases as bytes: every case comes back bit by bit, and every string of bytes is a case.
#include "fuzz/case_bytes.hpp"

#include <limits>

#include "fuzz/case_text.hpp"
#include "fuzz/family.hpp"
#include "fuzz/random.hpp"
#include "tests/catch.hpp"

using namespace graze;
using namespace graze::fuzz;

namespace {

using Bytes = std::vector<std::uint8_t>;

// Text in hexadecimal tells all bits but those of a NaN, and the bytes of a second encoding tell them too.
template <Real T>
void require_round_trip(const Case<T>& input) {
  const Bytes bytes = encode_case(input);
  const Case<T> decoded = std::get<Case<T>>(decode_case(group_of(input.index()), bytes));
  CHECK(format_case(decoded) == format_case(input));
  CHECK(encode_case(decoded) == bytes);
}

template <Real T>
Case<T> decoded(QueryGroup group, const Bytes& bytes) {
  return std::get<Case<T>>(decode_case(group, bytes));
}

}  // namespace

TEST_CASE("every family's cases come back from their bytes") {
  for (const Family& family : families()) {
    for (std::uint64_t index = 0; index < 200; ++index) {
      require_round_trip(make<float>(family, 7, index).input);
      require_round_trip(make<double>(family, 7, index).input);
    }
  }
}

TEST_CASE("any bytes are a case, which comes back") {
  for (std::uint64_t index = 0; index < 5000; ++index) {
    Random random(1, "bytes", index);
    Bytes bytes(random.below(160));
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.bits());
    for (const QueryGroup group : {QueryGroup::ray_sphere, QueryGroup::ray_triangle, QueryGroup::implicit}) {
      std::visit(
          [&](const auto& input) {
            CHECK(group_of(input.index()) == group);
            require_round_trip(input);
          },
          decode_case(group, bytes));
    }
  }
}

TEST_CASE("the empty string is a case of zeros, and what is missing is read as zero") {
  CHECK(format_case(decoded<float>(QueryGroup::ray_sphere, {})) ==
        "ray_sphere 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0");
  CHECK(format_case(decoded<double>(QueryGroup::implicit, {8, 0, 0, 0, 0, 0, 0, 0xf0, 0x3f})) ==
        "point_line 0x1p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0");
  // A number whose last bytes are missing, and bytes that are left over.
  CHECK(format_case(decoded<float>(QueryGroup::implicit, {0, 0, 0, 0x80})) ==
        "point_line 0x1p-126 0x0p+0 0x0p+0 0x0p+0 0x0p+0");
  CHECK(format_case(decoded<float>(QueryGroup::ray_sphere, Bytes(500, 0))) ==
        format_case(decoded<float>(QueryGroup::ray_sphere, {})));
}

TEST_CASE("small integers have the compact form, with an exponent for positions, direction and range") {
  RaySphere<double> query;
  query.ray = {{-8, 0, 0}, {0.25, 0, 0}, 2, 24};
  query.sphere = {{0, 4, 0}, 4};
  const Bytes bytes = encode_case(Case<double>(query));
  CHECK(bytes == Bytes{0 | 8 | 16 | 32, 2, 0xfe, 1, 0xfe, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 12});
  require_round_trip(Case<double>(query));

  SECTION("an infinite end is 127") {
    query.ray.t_max = std::numeric_limits<double>::infinity();
    CHECK(encode_case(Case<double>(query)).back() == 127);
    require_round_trip(Case<double>(query));
  }
  SECTION("an end of 127 and a zero with a sign have none") {
    query.ray.t_max = 127;
    CHECK(encode_case(Case<double>(query)).size() == 1 + 12 * 8);
    query.ray.t_max = 24;
    query.sphere.center.x = -0.0;
    CHECK(encode_case(Case<double>(query)).size() == 1 + 12 * 8);
  }
  SECTION("exponents may be eightfold") {
    CHECK(format_case(decoded<double>(QueryGroup::implicit, {8 | 32 | 64, 100, 0x81, 0, 3, 0xff, 1, 0, 2})) ==
          "point_line 0x1.8p+801 -0x1p+800 0x1p-1016 0x0p+0 0x1p-1015");
  }
}
