// From parts to a hierarchy.
#pragma once

#include "scene/data.hpp"

namespace graze::scene {

/// Checks the parts, and then fills in the rest; where they fail all is left as it was. Throws std::bad_alloc.
template <Real T>
[[nodiscard]] BuildStatus measure(Content<T>& content, Threads threads);

/// Builds the hierarchy of measured data. Throws std::bad_alloc.
template <Real T>
void build(Data<T>& data, const BuildOptions& options);

/// Whether the shapes of each leaf, as they are now, fit into it: points that were one may have come apart.
template <Real T>
[[nodiscard]] bool still_fits(const Data<T>& data) noexcept;

/// Gives the leaves of a built hierarchy the shapes as they are now, and every node its boxes; the data is measured and
/// still fits.
template <Real T>
void refit(Data<T>& data) noexcept;

/// Whether each directed edge of the meshes occurs as often as its reverse. Throws std::bad_alloc.
template <Real T>
[[nodiscard]] BuildStatus check_closed(const Content<T>& content);

}  // namespace graze::scene
