// Spatial splits: a triangle whose box is mostly empty is listed under several smaller boxes that cover it.
#pragma once

#include "scene/references.hpp"

namespace graze::scene {

/// Parts references whose boxes waste the most into several of the same triangle, at most as many more in all. Early split
/// clipping (Ernst and Greiner 2007), with how often each is parted after Karras and Aila 2013 (section 4.3). Throws
/// std::bad_alloc.
template <Real T>
void split(const Data<T>& data, Pages<Reference>& references);

}  // namespace graze::scene
