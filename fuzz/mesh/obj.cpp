// OBJ (Wavefront): `v` and `f` lines; all others are passed over. Indices start at 1, and below 0 count from the last point.
#include "fuzz/mesh/soup.hpp"

namespace graze::fuzz {

void parse_obj(std::string_view bytes, Soup& soup) {
  Words words(bytes, '#');
  while (words.next_line()) {
    const std::string_view keyword = words.word();
    if (keyword == "v") {
      const double x = words.coordinate(words.word()), y = words.coordinate(words.word()), z = words.coordinate(words.word());
      soup.points.push_back({x, y, z});
    } else if (keyword == "f") {
      auto& polygon = soup.polygons.emplace_back();
      for (std::string_view corner = words.word(); !corner.empty(); corner = words.word()) {
        // position/texture/normal
        const std::int64_t i = words.integer(corner.substr(0, corner.find('/')));
        if (i == 0) words.fail("point 0, where the first is 1");
        polygon.push_back(i > 0 ? i - 1 : static_cast<std::int64_t>(soup.points.size()) + i);
      }
    }
  }
}

}  // namespace graze::fuzz
