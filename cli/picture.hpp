// A picture in memory, written as PNG.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace graze::cli {

/// Red, green, blue.
using Color = std::array<std::uint8_t, 3>;

class Picture {
 public:
  Picture(int width, int height) : width_(width), height_(height), pixels_(std::size_t(width) * std::size_t(height)) {}

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  /// Row 0 is the top.
  [[nodiscard]] Color& at(int x, int y) { return pixels_[std::size_t(y) * std::size_t(width_) + std::size_t(x)]; }
  [[nodiscard]] const Color& at(int x, int y) const { return const_cast<Picture&>(*this).at(x, y); }

  /// The bytes of a PNG file in which each pixel is a square of zoom x zoom; empty where the picture is too large for one.
  [[nodiscard]] std::string png(int zoom) const;

 private:
  int width_, height_;
  std::vector<Color> pixels_;
};

}  // namespace graze::cli
