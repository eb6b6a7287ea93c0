// PLY (Stanford), as text and binary of both byte orders: the elements `vertex`, with x, y, z of any type, and `face`, with the
// list vertex_indices or vertex_index. Other elements and properties are read and dropped.
#include <array>
#include <optional>

#include "fuzz/mesh/soup.hpp"

namespace graze::fuzz {
namespace {

enum class Type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::optional<Type> type_named(std::string_view name) {
  constexpr std::array<std::array<std::string_view, 2>, 8> names{{{"char", "int8"},
                                                                  {"uchar", "uint8"},
                                                                  {"short", "int16"},
                                                                  {"ushort", "uint16"},
                                                                  {"int", "int32"},
                                                                  {"uint", "uint32"},
                                                                  {"float", "float32"},
                                                                  {"double", "float64"}}};
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (name == names[i][0] || name == names[i][1]) return static_cast<Type>(i);
  }
  return std::nullopt;
}

struct Property {
  std::string name;
  Type type;
  std::optional<Type> length = {};  ///< of a list: the type of its length
};

struct Element {
  std::string name;
  std::int64_t count;
  std::vector<Property> properties = {};
};

struct Header {
  std::optional<std::endian> binary;  ///< nothing for text
  std::vector<Element> elements;
};

Type type_of(Words& words) {
  const auto type = type_named(words.word());
  if (!type) words.fail("an unknown type of number");
  return *type;
}

Header parse_header(Words& words) {
  Header header;
  if (!words.next_line() || words.word() != "ply") words.fail("a PLY file starts with 'ply'");
  while (words.next_line()) {
    const std::string_view keyword = words.word();
    if (keyword == "end_header") return header;
    if (keyword == "format") {
      const std::string_view format = words.word();
      if (format == "binary_little_endian") header.binary = std::endian::little;
      if (format == "binary_big_endian") header.binary = std::endian::big;
      if (!header.binary && format != "ascii") words.fail("an unknown format");
    } else if (keyword == "element") {
      const std::string name(words.word());
      header.elements.push_back({name, words.count(words.word())});
    } else if (keyword == "property") {
      if (header.elements.empty()) words.fail("a property before the first element");
      Property property;
      Words ahead = words;
      if (ahead.word() == "list") {
        words.word();
        property.length = type_of(words);
      }
      property.type = type_of(words);
      property.name = words.word();
      header.elements.back().properties.push_back(property);
    } else if (keyword != "comment" && keyword != "obj_info") {
      words.fail("an unknown keyword of the header");
    }
  }
  words.fail("the file ends in its header");
}

/// The numbers of the body in order, from text or from bytes.
class Body {
 public:
  Body(const Words& words, std::optional<std::endian> binary)
      : words_(words), bytes_(words.rest_of_text(), binary.value_or(std::endian::native)), is_binary_(binary) {}

  double number(Type type, const Element& element, std::int64_t index) {
    if (!is_binary_) {
      const auto x = parse_number<double>(words_.any_word());
      if (!x) words_.fail("a number is wanted");
      return *x;
    }
    switch (type) {
      case Type::int8:
        return read<std::int8_t>(element, index);
      case Type::uint8:
        return read<std::uint8_t>(element, index);
      case Type::int16:
        return read<std::int16_t>(element, index);
      case Type::uint16:
        return read<std::uint16_t>(element, index);
      case Type::int32:
        return read<std::int32_t>(element, index);
      case Type::uint32:
        return read<std::uint32_t>(element, index);
      case Type::float32:
        return read<float>(element, index);
      case Type::float64:
        return read<double>(element, index);
    }
    return 0;
  }
  std::int64_t integer(Type type, const Element& element, std::int64_t index) {
    const double x = number(type, element, index);
    if (!(x == std::trunc(x) && std::abs(x) <= 0x1p53)) fail(element, index, "has an index or a length that is no integer");
    return static_cast<std::int64_t>(x);
  }
  [[noreturn]] static void fail(const Element& element, std::int64_t index, const std::string& what) {
    // Names are the file's own.
    const std::string name = element.name == "vertex" ? "point" : element.name == "face" ? "face" : "an element beside them,";
    throw MeshError{" " + name + " " + std::to_string(index) + " " + what};
  }

 private:
  template <class Number>
  double read(const Element& element, std::int64_t index) {
    Number x{};
    if (!bytes_.read(x)) fail(element, index, "is cut off by the end of the file");
    return static_cast<double>(x);
  }

  Words words_;
  Bytes bytes_;
  bool is_binary_;
};

/// One item of an element: its coordinates or its list of corners, if it has them.
void read_item(Body& body, const Element& element, std::int64_t index, Soup& soup) {
  Vec3<double> point;
  std::vector<std::int64_t> polygon;
  for (const Property& property : element.properties) {
    if (property.length) {
      const bool is_corners = property.name == "vertex_indices" || property.name == "vertex_index";
      for (std::int64_t left = body.integer(*property.length, element, index); left > 0; --left) {
        const double corner = body.number(property.type, element, index);
        if (!is_corners || element.name != "face") continue;
        if (!(corner == std::trunc(corner) && std::abs(corner) <= 0x1p53))
          Body::fail(element, index, "has an index that is no integer");
        polygon.push_back(static_cast<std::int64_t>(corner));
      }
    } else {
      const double x = body.number(property.type, element, index);
      if (property.name == "x") point.x = x;
      if (property.name == "y") point.y = x;
      if (property.name == "z") point.z = x;
    }
  }
  if (element.name == "vertex") {
    if (!std::isfinite(point.x) || !std::isfinite(point.y) || !std::isfinite(point.z)) {
      Body::fail(element, index, "has a coordinate that is not finite");
    }
    soup.points.push_back(point);
  }
  if (element.name == "face") soup.polygons.push_back(polygon);
}

bool has(const Element& element, std::string_view name, bool is_list) {
  for (const Property& property : element.properties) {
    if (property.name == name && property.length.has_value() == is_list) return true;
  }
  return false;
}

}  // namespace

void parse_ply(std::string_view bytes, Soup& soup) {
  Words words(bytes);
  const Header header = parse_header(words);
  Body body(words, header.binary);
  for (const Element& element : header.elements) {
    if (element.properties.empty() && element.count > 0) words.fail("an element without properties");
    if (element.name == "vertex" && !(has(element, "x", false) && has(element, "y", false) && has(element, "z", false))) {
      words.fail("the element vertex wants the properties x, y and z");
    }
    if (element.name == "face" && !has(element, "vertex_indices", true) && !has(element, "vertex_index", true)) {
      words.fail("the element face wants the list vertex_indices");
    }
    for (std::int64_t i = 0; i < element.count; ++i) read_item(body, element, i, soup);
  }
}

}  // namespace graze::fuzz
