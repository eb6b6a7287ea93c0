// OFF (Geomview): counts, then a line a point, then a line a face. Normals, colors and textures follow a point's position and a
// face's corners, and are not kept.
#include "fuzz/mesh/soup.hpp"

namespace graze::fuzz {
namespace {

/// The prefix of the keyword says what else a point has; all of it comes after the position.
bool is_known(std::string_view keyword) {
  for (const std::string_view prefix : {"ST", "C", "N"}) {
    if (keyword.starts_with(prefix)) keyword.remove_prefix(prefix.size());
  }
  return keyword == "OFF";
}

}  // namespace

void parse_off(std::string_view bytes, Soup& soup) {
  Words words(bytes, '#');
  std::string_view first = words.any_word();
  if (first.ends_with("OFF")) {
    if (!is_known(first)) words.fail("only OFF of three dimensions is known");
    first = words.any_word();
    if (first == "BINARY") words.fail("binary OFF is not known");
  }
  const std::int64_t points = words.count(first), faces = words.count(words.any_word());
  for (std::int64_t i = 0; i < points; ++i) {
    if (!words.next_line()) words.fail("the file ends before point " + std::to_string(i));
    const double x = words.coordinate(words.word()), y = words.coordinate(words.word()), z = words.coordinate(words.word());
    soup.points.push_back({x, y, z});
  }
  for (std::int64_t i = 0; i < faces; ++i) {
    if (!words.next_line()) words.fail("the file ends before face " + std::to_string(i));
    auto& polygon = soup.polygons.emplace_back();
    for (std::int64_t left = words.count(words.word()); left > 0; --left) polygon.push_back(words.integer(words.word()));
  }
}

}  // namespace graze::fuzz
