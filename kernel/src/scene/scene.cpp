// A scene's life: built, refitted, measured.
#include "graze/scene.hpp"

#include <new>

#include "scene/build.hpp"

namespace graze {

template <Real T>
Scene<T>::Scene() : data_(std::make_unique<scene::Data<T>>()) {}
template <Real T>
Scene<T>::~Scene() = default;
template <Real T>
Scene<T>::Scene(Scene&& other) noexcept = default;
template <Real T>
Scene<T>& Scene<T>::operator=(Scene&& other) noexcept = default;

template <Real T>
BuildStatus Scene<T>::build(std::vector<Part<T>> parts, const BuildOptions& options) {
  try {
    auto data = std::make_unique<scene::Data<T>>();
    data->parts = std::move(parts);
    BuildStatus status = scene::measure(*data, options.threads);
    if (status.ok() && options.is_closed) status = scene::check_closed(*data);
    if (!status.ok()) return status;
    data->options = options;
    scene::build(*data, options);
    data_ = std::move(data);
    return {};
  } catch (const std::bad_alloc&) {
    return {BuildError::out_of_memory, 0, 0, 0};
  }
}

namespace {

/// Another hierarchy. Where that throws the data is left as it was.
template <Real T>
void rebuild(scene::Data<T>& data) {
  scene::Hierarchy<T>& hierarchy = data;
  scene::Hierarchy<T> held = std::move(hierarchy);
  try {
    scene::build(data, data.options);
  } catch (...) {
    hierarchy = std::move(held);
    throw;
  }
}

/// Puts `fresh` in the place of `held`, which is the data's, and takes it back where that is refused.
template <Real T, class Elements>
BuildStatus replace(scene::Data<T>& data, Elements& held, Elements& fresh) {
  std::swap(held, fresh);
  const Bounds<T> bounds = data.bounds;
  const numeric::Extent extent = data.extent;
  const scene::Space space = data.space;
  BuildStatus status;
  try {
    status = scene::measure(data, Threads::mine);
    // Corners may have come apart that were the same point.
    if (status.ok() && data.options.is_closed) status = scene::check_closed(data);
    if (status.ok() && scene::still_fits(data)) {
      scene::refit(data);
    } else if (status.ok()) {
      rebuild(data);
    }
  } catch (const std::bad_alloc&) {
    status = {BuildError::out_of_memory, 0, 0, 0};
  }
  if (!status.ok()) {
    std::swap(held, fresh);
    data.bounds = bounds;
    data.extent = extent;
    data.space = space;
  }
  return status;
}

}  // namespace

template <Real T>
BuildStatus Scene<T>::refit(std::size_t part, Array<Vec3<T>> points) {
  const BuildStatus refused{BuildError::other_topology, static_cast<std::uint32_t>(part), 0, 0};
  auto* mesh = part < data_->parts.size() ? std::get_if<Mesh<T>>(&data_->parts[part]) : nullptr;
  return mesh != nullptr && mesh->points.size() == points.size() ? replace(*data_, mesh->points, points) : refused;
}

template <Real T>
BuildStatus Scene<T>::refit(std::size_t part, Array<Sphere<T>> spheres) {
  const BuildStatus refused{BuildError::other_topology, static_cast<std::uint32_t>(part), 0, 0};
  auto* held = part < data_->parts.size() ? std::get_if<Spheres<T>>(&data_->parts[part]) : nullptr;
  return held != nullptr && held->spheres.size() == spheres.size() ? replace(*data_, held->spheres, spheres) : refused;
}

template <Real T>
BuildStatus Scene<T>::refit() {
  Array<Vec3<T>> nothing, none;
  return replace(*data_, nothing, none);
}

template <Real T>
std::size_t Scene<T>::size() const noexcept {
  return data_->size();
}

template <Real T>
Bounds<T> Scene<T>::bounds() const noexcept {
  return data_->bounds;
}

template <Real T>
bool Scene<T>::is_closed() const noexcept {
  return data_->options.is_closed;
}

template <Real T>
std::size_t Scene<T>::memory() const noexcept {
  const auto held = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
  std::size_t bytes = sizeof(*data_) + held(data_->parts) + held(data_->first) + held(data_->nodes) + held(data_->triangles) +
                      held(data_->spheres) + held(data_->listings);
  for (const Part<T>& part : data_->parts) {
    const auto* mesh = std::get_if<Mesh<T>>(&part);
    bytes += mesh != nullptr ? mesh->points.memory() + mesh->triangles.memory() : std::get<Spheres<T>>(part).spheres.memory();
  }
  return bytes;
}

#define GRAZE_LIFE(T)                                                              \
  template Scene<T>::Scene();                                                      \
  template Scene<T>::~Scene();                                                     \
  template Scene<T>::Scene(Scene<T>&&) noexcept;                                   \
  template Scene<T>& Scene<T>::operator=(Scene<T>&&) noexcept;                     \
  template BuildStatus Scene<T>::build(std::vector<Part<T>>, const BuildOptions&); \
  template BuildStatus Scene<T>::refit(std::size_t, Array<Vec3<T>>);               \
  template BuildStatus Scene<T>::refit(std::size_t, Array<Sphere<T>>);             \
  template BuildStatus Scene<T>::refit();                                          \
  template std::size_t Scene<T>::size() const noexcept;                            \
  template Bounds<T> Scene<T>::bounds() const noexcept;                            \
  template std::size_t Scene<T>::memory() const noexcept;                          \
  template bool Scene<T>::is_closed() const noexcept;
GRAZE_LIFE(float)
GRAZE_LIFE(double)
#undef GRAZE_LIFE

}  // namespace graze
