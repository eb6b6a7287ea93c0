// Memory of large arrays in large pages, where the system has them: a ray's way through a scene touches pages at random.
#pragma once

#include <cstddef>
#include <new>
#include <utility>
#include <vector>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace graze::scene {

/// Aligned to its elements, and, where they are many, to large pages, which the system is asked for.
template <class Element>
struct PageAllocator {
  using value_type = Element;
  PageAllocator() = default;
  template <class Other>
  PageAllocator(const PageAllocator<Other>&) noexcept {}  // NOLINT(google-explicit-constructor)

  [[nodiscard]] Element* allocate(std::size_t n) {
    const std::size_t bytes = n * sizeof(Element);
    void* const memory = ::operator new(bytes, alignment(n));
#if defined(__linux__)
    // Only advice: nothing depends on it.
    if (bytes >= least_bytes) static_cast<void>(madvise(memory, bytes, MADV_HUGEPAGE));
#endif
    return static_cast<Element*>(memory);
  }
  void deallocate(Element* memory, std::size_t n) noexcept {
    ::operator delete(memory, alignment(n));
  }
  /// What `resize` adds is left as it is found, for threads to write side by side, each the first to touch its pages.
  void construct(Element* at) noexcept {
    ::new (static_cast<void*>(at)) Element;
  }
  template <class... Values>
  void construct(Element* at, Values&&... values) {
    ::new (static_cast<void*>(at)) Element(std::forward<Values>(values)...);
  }
  bool operator==(const PageAllocator&) const = default;

 private:
  static constexpr std::size_t page = std::size_t(1) << 21, least_bytes = 2 * page;
  static std::align_val_t alignment(std::size_t n) noexcept {
    return std::align_val_t(n * sizeof(Element) >= least_bytes ? page : alignof(Element));
  }
};

template <class Element>
using Pages = std::vector<Element, PageAllocator<Element>>;

}  // namespace graze::scene
