// Scenes from files: meshes and lists of spheres.
#pragma once

#include <string>
#include <vector>

#include "graze/scene.hpp"

namespace graze::cli {

/// Makes the scene of the files, each a part, in order. Empty where all is well, else a whole message: file, line or element,
/// reason.
template <Real T>
[[nodiscard]] std::string load_scene(const std::vector<std::string>& files, bool is_closed, Scene<T>& scene);

/// The parts alone; each triangle and sphere can be looked up in them.
template <Real T>
[[nodiscard]] std::string load_parts(const std::vector<std::string>& files, std::vector<Part<T>>& parts);

/// A scene that views the parts of those files; they must outlive it. Empty where all is well, else a whole message.
template <Real T>
[[nodiscard]] std::string view_scene(const std::vector<std::string>& files, const std::vector<Part<T>>& parts, Scene<T>& scene);

}  // namespace graze::cli
