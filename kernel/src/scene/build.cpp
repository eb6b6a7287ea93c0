// The hierarchy, from the top: binned by the surface area heuristic (Wald 2007) into two, the largest part again, until there
// are eight children or all are leaves.
#include "scene/build.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <memory>

#include "scene/parallel.hpp"

namespace graze::scene {
namespace {

/// Three floats and one more that is not looked at.
using Four = float __attribute__((vector_size(16)));

[[nodiscard]] inline Four lesser(const Four& a, const Four& b) noexcept {
  return a < b ? a : b;
}
[[nodiscard]] inline Four greater(const Four& a, const Four& b) noexcept {
  return a > b ? a : b;
}

/// A primitive, to be sorted.
struct alignas(16) Reference {
  float low[3];
  std::uint32_t index : 31;
  std::uint32_t is_sphere : 1;
  float high[3];
  std::uint32_t unused;

  /// With the index as the fourth.
  [[nodiscard]] Four low_corner() const noexcept {
    Four out;
    std::memcpy(&out, low, sizeof out);
    return out;
  }
  [[nodiscard]] Four high_corner() const noexcept {
    Four out;
    std::memcpy(&out, high, sizeof out);
    return out;
  }
  /// Twice that.
  [[nodiscard]] Four center() const noexcept { return low_corner() + high_corner(); }
};

/// A box that grows.
struct Hull {
  Four low = Four{} + 0x1p100F, high = Four{} - 0x1p100F;

  void include(const Four& from, const Four& to) noexcept {
    low = lesser(from, low);
    high = greater(to, high);
  }
  void include(const Hull& other) noexcept { include(other.low, other.high); }
  [[nodiscard]] Box box() const noexcept { return {{low[0], low[1], low[2]}, {high[0], high[1], high[2]}}; }
};

struct Range {
  std::size_t begin, end;
  Box box;
  int depth;

  [[nodiscard]] std::size_t size() const noexcept { return end - begin; }
};

/// A node while its children are not numbered yet.
struct Draft {
  int size = 0;
  std::array<Range, width> ranges;
  std::array<std::unique_ptr<Draft>, width> children;  ///< null for a leaf
};

constexpr int bins = 16;
/// Below this depth ranges are halved by number: at most 31 levels more, within `deepest`.
constexpr int deepest_by_area = 60;

struct Bin {
  Hull hull;
  std::size_t size = 0;

  void include(const Bin& other) noexcept {
    hull.include(other.hull);
    size += other.size;
  }
};
using Bins = std::array<std::array<Bin, bins>, 3>;

void include(Box& box, const Reference& r) noexcept {
  box.include({{r.low[0], r.low[1], r.low[2]}, {r.high[0], r.high[1], r.high[2]}});
}

/// From centers to bins. Whatever the rounding, a bin is in [0, bins).
struct Binning {
  Four low, scale;

  explicit Binning(const Hull& centers) noexcept : low(centers.low), scale{} {
    for (int k = 0; k < 3; ++k) {
      const float extent = centers.high[k] - centers.low[k];
      scale[k] = extent > 0x1p-100f ? bins * 0.9999f / extent : 0;
    }
  }
  using Places = std::int32_t __attribute__((vector_size(16)));
  [[nodiscard]] Places places(const Reference& r) const noexcept {
    const Four last = Four{} + (bins - 1), x = (r.center() - low) * scale;
    return __builtin_convertvector(lesser(x > 0 ? x : Four{}, last), Places);
  }
};

/// A way to part a range in two.
struct Split {
  int axis = -1;  ///< none where all centers share a bin
  int bin = 0;    ///< the first of the second part
};

class Builder {
 public:
  Builder(Pages<Reference>& references, Threads threads) : references_(references), threads_(threads) {}

  [[nodiscard]] std::unique_ptr<Draft> draft(const Range& range) const {
    auto out = std::make_unique<Draft>();
    out->ranges[0] = range;
    out->size = 1;
    while (out->size < width) {
      int largest = -1;
      for (int i = 0; i < out->size; ++i) {
        if (is_leaf(out->ranges[i])) continue;
        if (largest < 0 || out->ranges[i].box.half_area() > out->ranges[largest].box.half_area()) largest = i;
      }
      if (largest < 0) break;
      const auto [one, other] = split(out->ranges[largest]);
      out->ranges[largest] = one;
      out->ranges[out->size++] = other;
    }
    for_ranges(out->size, range.size() > 4096 ? 1 : width, threads_, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        if (!is_leaf(out->ranges[i])) out->children[i] = draft(out->ranges[i]);
      }
    });
    return out;
  }

 private:
  [[nodiscard]] bool is_leaf(const Range& range) const noexcept {
    if (range.size() > width) return false;
    for (std::size_t i = range.begin + 1; i < range.end; ++i) {
      if (references_[i].is_sphere != references_[range.begin].is_sphere) return false;
    }
    return true;
  }

  [[nodiscard]] Range range(std::size_t begin, std::size_t end, int depth) const {
    Range out{begin, end, Box::empty(), depth};
    const auto hull = [&](std::size_t from, std::size_t to) {
      Hull sum;
      for (std::size_t i = from; i < to; ++i) sum.include(references_[i].low_corner(), references_[i].high_corner());
      return sum;
    };
    out.box = summed<Hull>(out, hull, [](Hull& sum, const Hull& other) { sum.include(other); }).box();
    return out;
  }

  [[nodiscard]] std::pair<Range, Range> halves(const Range& whole, std::size_t middle) const {
    return {range(whole.begin, middle, whole.depth + 1), range(middle, whole.end, whole.depth + 1)};
  }

  /// Neither part is empty.
  [[nodiscard]] std::pair<Range, Range> split(const Range& whole) const {
    const auto begin = references_.begin() + static_cast<std::ptrdiff_t>(whole.begin);
    const auto end = references_.begin() + static_cast<std::ptrdiff_t>(whole.end);
    if (whole.size() <= width) {
      const auto middle = std::partition(begin, end, [](const Reference& r) { return r.is_sphere == 0; });
      return halves(whole, static_cast<std::size_t>(middle - references_.begin()));
    }
    const Binning binning(centers(whole));
    const Split best = best_split(whole, binning);
    if (best.axis >= 0 && whole.depth < deepest_by_area) {
      const auto middle =
          std::partition(begin, end, [&](const Reference& r) { return binning.places(r)[best.axis] < best.bin; });
      // The bins' own hulls would not do: another thread may have filled them in another rounding mode.
      if (middle != begin && middle != end) return halves(whole, static_cast<std::size_t>(middle - references_.begin()));
    }
    return halves(whole, whole.begin + whole.size() / 2);
  }

  /// The sum of what `part(begin, end)` gives for parts of a range, on all cores where it is long. Sums are exact, so the same.
  template <class Sum, class Part, class Add>
  [[nodiscard]] Sum summed(const Range& whole, Part part, Add add) const {
    constexpr std::size_t parts = 8, least = 1 << 16;
    if (whole.size() < least) return part(whole.begin, whole.end);
    std::array<Sum, parts> sums;
    for_ranges(parts, 1, threads_, [&](std::size_t from, std::size_t to) {
      for (std::size_t i = from; i < to; ++i) {
        sums[i] = part(whole.begin + whole.size() * i / parts, whole.begin + whole.size() * (i + 1) / parts);
      }
    });
    for (std::size_t i = 1; i < parts; ++i) add(sums[0], sums[i]);
    return sums[0];
  }

  [[nodiscard]] Hull centers(const Range& whole) const {
    return summed<Hull>(
        whole,
        [&](std::size_t begin, std::size_t end) {
          Hull hull;
          for (std::size_t i = begin; i < end; ++i) hull.include(references_[i].center(), references_[i].center());
          return hull;
        },
        [](Hull& sum, const Hull& hull) { sum.include(hull); });
  }

  [[nodiscard]] Bins filled(const Range& whole, const Binning& binning) const {
    return summed<Bins>(
        whole,
        [&](std::size_t begin, std::size_t end) {
          Bins table;
          for (std::size_t i = begin; i < end; ++i) {
            const Four low = references_[i].low_corner(), high = references_[i].high_corner();
            const Binning::Places places = binning.places(references_[i]);
            for (int k = 0; k < 3; ++k) {
              Bin& bin = table[k][places[k]];
              bin.hull.include(low, high);
              ++bin.size;
            }
          }
          return table;
        },
        [](Bins& sum, const Bins& table) {
          for (int k = 0; k < 3; ++k) {
            for (int i = 0; i < bins; ++i) sum[k][i].include(table[k][i]);
          }
        });
  }

  [[nodiscard]] Split best_split(const Range& whole, const Binning& binning) const {
    const Bins table = filled(whole, binning);
    Split best;
    float least = std::numeric_limits<float>::infinity();
    for (int k = 0; k < 3; ++k) {
      std::array<float, bins> cost{};
      Bin sum;
      for (int i = bins - 1; i > 0; --i) {
        sum.include(table[k][i]);
        cost[i] = sum.size == 0 ? -1 : sum.hull.box().half_area() * blocks(sum.size);
      }
      sum = {};
      for (int i = 1; i < bins; ++i) {
        sum.include(table[k][i - 1]);
        if (sum.size == 0 || cost[i] < 0) continue;
        const float total = cost[i] + sum.hull.box().half_area() * blocks(sum.size);
        if (total < least) {
          least = total;
          best = {k, i};
        }
      }
    }
    return best;
  }

  /// What a part costs: a block is tested at once.
  [[nodiscard]] static float blocks(std::size_t size) noexcept { return static_cast<float>((size + width - 1) / width); }

  Pages<Reference>& references_;
  Threads threads_;
};

/// How many nodes and blocks the drafts come to.
struct Sizes {
  std::size_t nodes = 0, triangles = 0, spheres = 0;
};

void count(const Draft& draft, const Pages<Reference>& references, Sizes& sizes) noexcept {
  ++sizes.nodes;
  for (int i = 0; i < draft.size; ++i) {
    if (draft.children[i] != nullptr) {
      count(*draft.children[i], references, sizes);
    } else {
      ++(references[draft.ranges[i].begin].is_sphere != 0 ? sizes.spheres : sizes.triangles);
    }
  }
}

/// A leaf whose block is to be filled.
struct Leaf {
  Child child;
  std::uint32_t begin, end;
};

/// Writes the nodes, depth first, and lists the leaves.
template <Real T>
std::uint32_t write(const Draft& draft, const Pages<Reference>& references, Data<T>& data, Sizes& written,
                    std::vector<Leaf>& leaves) {
  const auto self = static_cast<std::uint32_t>(written.nodes++);
  for (int i = 0; i < width; ++i) data.nodes[self].set(i, Box::empty(), Child::nothing());
  for (int i = 0; i < draft.size; ++i) {
    const Range& range = draft.ranges[i];
    Child child;
    if (draft.children[i] != nullptr) {
      child = Child::node(write(*draft.children[i], references, data, written, leaves));
    } else {
      child = references[range.begin].is_sphere != 0 ? Child::spheres(static_cast<std::uint32_t>(written.spheres++))
                                                     : Child::triangles(static_cast<std::uint32_t>(written.triangles++));
      leaves.push_back({child, static_cast<std::uint32_t>(range.begin), static_cast<std::uint32_t>(range.end)});
    }
    data.nodes[self].set(i, range.box, child);
  }
  return self;
}

template <Real T>
Pages<Reference> references_of(const Data<T>& data, Threads threads) {
  Pages<Reference> out(data.size());
  for (std::size_t p = 0; p < data.parts.size(); ++p) {
    const std::uint32_t first = data.first[p];
    for_ranges(size_of(data.parts[p]), 4096, threads, [&](std::size_t begin, std::size_t end) {
      const auto* mesh = std::get_if<Mesh<T>>(&data.parts[p]);
      for (std::size_t i = begin; i < end; ++i) {
        const Box box = mesh != nullptr ? box_of(data.space, triangle_of(*mesh, i))
                                        : box_of(data.space, std::get<Spheres<T>>(data.parts[p]).spheres[i]);
        Reference& r = out[first + i];
        std::copy_n(box.low, 3, r.low);
        std::copy_n(box.high, 3, r.high);
        r.index = static_cast<std::uint32_t>(first + i);
        r.is_sphere = mesh == nullptr ? 1 : 0;
        r.unused = 0;
      }
    });
  }
  return out;
}

/// The primitive as it is now.
template <Real T>
void load(const Data<T>& data, TriangleBlock<T>& block, int lane, std::uint32_t primitive) noexcept {
  const std::uint32_t part = data.part_of(primitive);
  block.set(lane, triangle_of(std::get<Mesh<T>>(data.parts[part]), primitive - data.first[part]), primitive);
}
template <Real T>
void load(const Data<T>& data, SphereBlock<T>& block, int lane, std::uint32_t primitive) noexcept {
  const std::uint32_t part = data.part_of(primitive);
  block.set(lane, std::get<Spheres<T>>(data.parts[part]).spheres[primitive - data.first[part]], primitive);
}

/// Empty lanes repeat the first shape, so that they hold ordinary numbers.
template <Real T, class Block>
void fill(const Data<T>& data, Block& block, const Reference* references, std::uint32_t size) noexcept {
  for (std::uint32_t i = 0; i < width; ++i) {
    load(data, block, static_cast<int>(i), references[i < size ? i : 0].index);
    if (i >= size) block.index[i] = no_primitive;
  }
}

template <Real T, class Block>
[[nodiscard]] Box reload(const Data<T>& data, Block& block) noexcept {
  Box box = Box::empty();
  for (int i = 0; i < width; ++i) {
    const std::uint32_t primitive = block.index[i];
    load(data, block, i, primitive == no_primitive ? block.index[0] : primitive);
    block.index[i] = primitive;
    if constexpr (requires { block.triangle(0); }) {
      box.include(box_of(data.space, block.triangle(i)));
    } else {
      box.include(box_of(data.space, block.sphere(i)));
    }
  }
  return box;
}

}  // namespace

template <Real T>
void build(Data<T>& data, Threads threads) {
  data.nodes.clear();
  data.triangles.clear();
  data.spheres.clear();
  data.root = Box::empty();
  if (data.size() == 0) return;
  Pages<Reference> references = references_of(data, threads);
  for (const Reference& r : references) include(data.root, r);
  std::unique_ptr<Draft> draft = Builder(references, threads).draft({0, references.size(), data.root, 0});
  Sizes sizes, written;
  count(*draft, references, sizes);
  data.nodes.resize(sizes.nodes);
  std::vector<Leaf> leaves;
  leaves.reserve(sizes.triangles + sizes.spheres);
  write(*draft, references, data, written, leaves);
  draft.reset();
  data.triangles.resize(sizes.triangles);
  data.spheres.resize(sizes.spheres);
  for_ranges(leaves.size(), 1024, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Leaf& leaf = leaves[i];
      const Reference* from = references.data() + leaf.begin;
      if (leaf.child.is_spheres()) {
        fill(data, data.spheres[leaf.child.index()], from, leaf.end - leaf.begin);
      } else {
        fill(data, data.triangles[leaf.child.index()], from, leaf.end - leaf.begin);
      }
    }
  });
}

template <Real T>
void refit(Data<T>& data) noexcept {
  // Children come after their parents.
  for (std::size_t n = data.nodes.size(); n-- > 0;) {
    Node& node = data.nodes[n];
    for (int i = 0; i < width; ++i) {
      const Child child = node.children[i];
      if (child.is_nothing()) continue;
      Box box = Box::empty();
      if (!child.is_leaf()) {
        const Node& inner = data.nodes[child.index()];
        for (int j = 0; j < width; ++j) {
          if (!inner.children[j].is_nothing()) box.include(inner.box(j));
        }
      } else if (child.is_spheres()) {
        box = reload(data, data.spheres[child.index()]);
      } else {
        box = reload(data, data.triangles[child.index()]);
      }
      node.set(i, box, child);
    }
  }
  data.root = Box::empty();
  for (int i = 0; i < width && !data.nodes.empty(); ++i) {
    if (!data.nodes[0].children[i].is_nothing()) data.root.include(data.nodes[0].box(i));
  }
}

template void build(Data<float>&, Threads);
template void build(Data<double>&, Threads);
template void refit(Data<float>&) noexcept;
template void refit(Data<double>&) noexcept;

}  // namespace graze::scene
