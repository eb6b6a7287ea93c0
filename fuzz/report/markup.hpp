// Text within HTML and SVG.
#pragma once

#include <string>
#include <string_view>

namespace graze::fuzz {

/// Any text as HTML, XML or an attribute's value may hold it; control characters, which XML cannot hold, become spaces.
[[nodiscard]] inline std::string escaped(std::string_view text) {
  std::string markup;
  for (const char letter : text) {
    switch (letter) {
      case '&':
        markup += "&amp;";
        break;
      case '<':
        markup += "&lt;";
        break;
      case '>':
        markup += "&gt;";
        break;
      case '"':
        markup += "&quot;";
        break;
      case '\'':
        markup += "&#39;";
        break;
      default:
        markup += static_cast<unsigned char>(letter) < 0x20 && letter != '\n' && letter != '\t' ? ' ' : letter;
    }
  }
  return markup;
}

/// <name>text</name>, the text escaped; `attributes` are markup.
[[nodiscard]] inline std::string element(std::string_view name, std::string_view text, std::string_view attributes = {}) {
  std::string markup = "<" + std::string(name);
  if (!attributes.empty()) markup.append(" ").append(attributes);
  return markup.append(">").append(escaped(text)).append("</").append(name).append(">");
}

}  // namespace graze::fuzz
