// Cases as bytes, the same for every machine: the query's kind, then each number's bits in eight bytes, the least first. Read
// as bits too, because x87 changes a signalling NaN that it moves.
#pragma once

#include <cstring>
#include <istream>
#include <ostream>

#include "fuzz/case_numbers.hpp"
#include "graze/numeric/bits.hpp"
#include "tests/bits/digest.hpp"

namespace graze::fuzz {

template <Real T>
void write_case(std::ostream& out, const Case<T>& input) {
  out.put(static_cast<char>(input.index()));
  std::visit(
      [&](const auto& query) {
        for_each_number(query, [&](const T& x) {
          const std::uint64_t bits = numeric::bits_of(x);
          for (int byte = 0; byte < 8; ++byte) out.put(static_cast<char>(bits >> (8 * byte)));
        });
      },
      input);
}

/// Leaves the stream bad where it ends too soon or names no query.
template <Real T>
[[nodiscard]] Case<T> read_case(std::istream& in) {
  Case<T> input;
  switch (in.get()) {
    case 0:
      input = RaySphere<T>{};
      break;
    case 1:
      input = RayTriangle<T>{};
      break;
    case 2:
      input = PointLine<T>{};
      break;
    case 3:
      input = PointPlane<T>{};
      break;
    case 4:
      input = PointSphere<T>{};
      break;
    default:
      in.setstate(std::ios::failbit);
      break;
  }
  std::visit(
      [&](auto& query) {
        for_each_number(query, [&](T& x) {
          std::uint64_t bits = 0;
          for (int byte = 0; byte < 8; ++byte) bits |= static_cast<std::uint64_t>(in.get() & 0xff) << (8 * byte);
          const auto own = static_cast<numeric::Bits<T>>(bits);
          std::memcpy(&x, &own, sizeof x);
        });
      },
      input);
  return input;
}

/// The digest of one stream's cases, by a taker that is given each.
template <Real T, class Taker>
[[nodiscard]] Digest digest_of(std::istream& cases, Taker taker) {
  for (std::uint64_t index = 0; index < cases_of_a_stream && cases; ++index) taker.add(read_case<T>(cases));
  return taker.digest();
}

/// Of all streams, each by a new taker_of<T>(); nothing where the file is cut short.
template <class TakerOf>
[[nodiscard]] Digests replayed(std::istream& cases, TakerOf taker_of) {
  Digests all;
  for (std::string name; std::getline(cases, name);) {
    all[name] = name.ends_with(" float") ? digest_of<float>(cases, taker_of.template operator()<float>())
                                         : digest_of<double>(cases, taker_of.template operator()<double>());
    if (!cases) return {};
  }
  return all;
}

}  // namespace graze::fuzz
