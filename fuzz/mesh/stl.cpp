// STL, as text or binary: triangles with corners of their own. Corners of the same coordinates become one point.
#include <map>
#include <tuple>

#include "fuzz/mesh/soup.hpp"

namespace graze::fuzz {
namespace {

constexpr std::size_t header_size = 80, facet_size = 50;

class Corners {
 public:
  explicit Corners(Soup& soup) : soup_(soup) {}
  /// The index of the point; -0 is 0.
  std::int64_t index_of(const Vec3<double>& p) {
    const auto [entry, is_new] = index_.try_emplace({p.x, p.y, p.z}, static_cast<std::int64_t>(soup_.points.size()));
    if (is_new) soup_.points.push_back(p);
    return entry->second;
  }

 private:
  Soup& soup_;
  std::map<std::tuple<double, double, double>, std::int64_t> index_;
};

void parse_text(std::string_view text, Soup& soup) {
  Words words(text);
  Corners corners(soup);
  // The name may have any words, facet among them: the first line is passed over whole.
  words.next_line();
  while (words.next_line()) {
    std::string_view word = words.word();
    if (word == "endsolid") return;
    if (word == "solid") continue;
    if (word != "facet") words.fail("a facet or the end of the solid is wanted");
    auto& polygon = soup.polygons.emplace_back();
    for (word = words.any_word(); word != "endfacet"; word = words.any_word()) {
      if (word != "vertex") continue;
      const double x = words.coordinate(words.any_word());
      const double y = words.coordinate(words.any_word());
      const double z = words.coordinate(words.any_word());
      polygon.push_back(corners.index_of({x, y, z}));
    }
    if (polygon.size() != 3) words.fail("a facet of " + std::to_string(polygon.size()) + " corners");
  }
  words.fail("the file ends before endsolid");
}

void parse_binary(std::string_view bytes, Soup& soup) {
  Corners corners(soup);
  Bytes in(bytes.substr(header_size), std::endian::little);
  std::uint32_t facets = 0;
  in.read(facets);
  for (std::uint32_t f = 0; f < facets; ++f) {
    float number[12] = {};
    std::uint16_t attributes = 0;
    bool is_whole = true;
    for (float& x : number) is_whole = is_whole && in.read(x);
    if (!is_whole || !in.read(attributes)) {
      throw MeshError{" the file ends in facet " + std::to_string(f) + " of " + std::to_string(facets)};
    }
    auto& polygon = soup.polygons.emplace_back();
    for (int corner = 1; corner < 4; ++corner) {
      const float* p = number + 3 * corner;
      if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2])) {
        throw MeshError{" facet " + std::to_string(f) + " has a coordinate that is not finite"};
      }
      polygon.push_back(corners.index_of({p[0], p[1], p[2]}));
    }
  }
}

/// A binary file may begin with `solid` too, but its length is what its count of facets says.
bool is_binary(std::string_view bytes) {
  if (bytes.size() < header_size + sizeof(std::uint32_t)) return false;
  std::uint32_t facets = 0;
  Bytes(bytes.substr(header_size), std::endian::little).read(facets);
  return !bytes.starts_with("solid") || bytes.size() == header_size + sizeof facets + std::uint64_t{facets} * facet_size;
}

}  // namespace

void parse_stl(std::string_view bytes, Soup& soup) {
  if (is_binary(bytes)) {
    parse_binary(bytes, soup);
  } else {
    if (!bytes.starts_with("solid")) throw MeshError{" is neither text that starts with 'solid' nor long enough to be binary"};
    parse_text(bytes, soup);
  }
}

}  // namespace graze::fuzz
