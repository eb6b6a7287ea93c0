#include "cli/picture.hpp"

#include <png.h>

namespace graze::cli {

std::string Picture::png(int zoom) const {
  const auto side = static_cast<std::size_t>(zoom), row = static_cast<std::size_t>(width_) * side;
  std::vector<Color> large(row * static_cast<std::size_t>(height_) * side);
  for (std::size_t i = 0; i < large.size(); ++i) {
    large[i] = at(static_cast<int>(i % row / side), static_cast<int>(i / row / side));
  }
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(row);
  image.height = static_cast<png_uint_32>(static_cast<std::size_t>(height_) * side);
  image.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = 0;
  if (png_image_write_to_memory(&image, nullptr, &size, 0, large.data(), 0, nullptr) == 0) return {};
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&image, bytes.data(), &size, 0, large.data(), 0, nullptr) == 0) return {};
  bytes.resize(size);
  return bytes;
}

}  // namespace graze::cli
