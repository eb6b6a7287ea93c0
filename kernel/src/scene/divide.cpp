#include "scene/divide.hpp"

#include <algorithm>
#include <limits>

namespace graze::scene {
namespace {

constexpr int most_bins = 16;
/// Where primitives are few, fewer bins find splits no worse.
constexpr std::size_t few = 32;
constexpr int bins_for_few = 8;
/// Greater ranges are divided by tasks of their own.
constexpr std::size_t task = 4096;
/// Below this depth ranges are halved by number: at most 31 levels more, within `deepest`.
constexpr int deepest_by_area = 60;

constexpr float infinity = std::numeric_limits<float>::infinity();

/// Of one axis.
struct Bin {
  Hull hull;
  std::int32_t size = 0;

  void include(const Bin& other) noexcept {
    hull.include(other.hull);
    size += other.size;
  }
};
using Bins = std::array<std::array<Bin, 3>, most_bins>;

/// From centers to bins. Whatever the rounding, a bin is in [0, bins).
struct Binning {
  Four low, scale;
  int bins;

  Binning(const Hull& centers, std::size_t size) noexcept
      : low(centers.low), scale{}, bins(size <= few ? bins_for_few : most_bins) {
    for (int k = 0; k < 3; ++k) {
      const float extent = centers.high[k] - centers.low[k];
      scale[k] = extent > 0x1p-100f ? static_cast<float>(bins) * 0.9999f / extent : 0;
    }
  }
  [[nodiscard]] FourIntegers places(const Reference& r) const noexcept {
    const Four first{}, last = first + static_cast<float>(bins - 1), x = (r.center() - low) * scale;
    return __builtin_convertvector(lesser(last, greater(x, first)), FourIntegers);
  }
  /// One of these.
  [[nodiscard]] int place(const Reference& r, int axis) const noexcept {
    const float x = (r.low[axis] + r.high[axis] - low[axis]) * scale[axis];
    return static_cast<int>(std::min(static_cast<float>(bins - 1), std::max(x, 0.0F)));
  }
};

/// What some bins of each axis hold, the axes side by side.
struct Columns {
  std::array<Four, 3> low, high;
  FourIntegers size{};

  Columns() {
    low.fill(Hull().low);
    high.fill(Hull().high);
  }
  explicit Columns(const std::array<Bin, 3>& axes)
      : low(transposed(axes[0].hull.low, axes[1].hull.low, axes[2].hull.low)),
        high(transposed(axes[0].hull.high, axes[1].hull.high, axes[2].hull.high)),
        size{axes[0].size, axes[1].size, axes[2].size, 0} {}

  void include(const Columns& other) noexcept {
    for (int k = 0; k < 3; ++k) {
      low[k] = lesser(other.low[k], low[k]);
      high[k] = greater(other.high[k], high[k]);
    }
    size += other.size;
  }
  /// Half the surface, times the blocks of so many, each of which is tested at once; infinite for nothing.
  [[nodiscard]] Four cost(int block) const noexcept {
    const Four x = high[0] - low[0], y = high[1] - low[1], z = high[2] - low[2];
    const FourIntegers blocks = (size + (block - 1)) / block;
    return size == 0 ? Four{} + infinity : (x * y + y * z + z * x) * __builtin_convertvector(blocks, Four);
  }

 private:
  [[nodiscard]] static std::array<Four, 3> transposed(const Four& a, const Four& b, const Four& c) noexcept {
    const Four low = __builtin_shufflevector(a, b, 0, 4, 1, 5), high = __builtin_shufflevector(a, b, 2, 6, 3, 7);
    return {__builtin_shufflevector(low, c, 0, 1, 4, 4), __builtin_shufflevector(low, c, 2, 3, 5, 5),
            __builtin_shufflevector(high, c, 0, 1, 6, 6)};
  }
};

/// A way to part a range in two.
struct Split {
  int axis = -1;  ///< none where all centers share a bin
  int bin = 0;    ///< the first of the second part
};

/// A range to be divided, and the hull of its centers.
struct Piece {
  Range range;
  Hull centers;
};

class Builder {
 public:
  Builder(Pages<Reference>& references, const Fits& fits, Threads threads)
      : references_(references), fits_(fits), threads_(threads) {}

  [[nodiscard]] Piece whole(const Box& root) const {
    const auto centers = [&](std::size_t begin, std::size_t end) {
      Hull hull;
      for (std::size_t i = begin; i < end; ++i) hull.include(references_[i].center(), references_[i].center());
      return hull;
    };
    const std::size_t size = references_.size();
    return {{0, size, root, 0}, summed<Hull>(size, threads_, centers, [](Hull& sum, const Hull& hull) { sum.include(hull); })};
  }

  [[nodiscard]] Branch* branch(const Piece& part, Branches& branches) const {
    Branch* const out = branches.make();
    const Range& range = out->range = part.range;
    if (is_leaf(range)) {
      out->cost.fill(area(range) * leaf_cost);
      return out;
    }
    const std::array<Piece, 2> halves = split(part);
    if (range.size() <= task) {
      out->one = branch(halves[0], branches);
      out->other = branch(halves[1], branches);
    } else {
      std::array<Branches, 2> of_each;
      std::array<Branch*, 2> each{};
      for_ranges(2, 1, threads_, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) each[i] = branch(halves[i], of_each[i]);
      });
      for (Branches& one : of_each) branches.adopt(std::move(one));
      out->one = each[0];
      out->other = each[1];
    }
    weigh(*out);
    return out;
  }

 private:
  /// What visiting a node and a leaf take, in one unit.
  static constexpr float node_cost = 1, leaf_cost = 1;
  /// In proportion to how many rays meet it; where areas are zero, so that fewer nodes cost less.
  [[nodiscard]] static float area(const Range& range) noexcept { return range.box.half_area() + 0x1p-100f; }

  /// From its halves' costs.
  static void weigh(Branch& branch) noexcept {
    std::array<float, width + 1> parted{};
    for (int n = 2; n <= width; ++n) {
      parted[n] = infinity;
      for (int k = 1; k < n; ++k) {
        const float cost = branch.one->cost[k - 1] + branch.other->cost[n - k - 1];
        if (!(cost < parted[n])) continue;
        parted[n] = cost;
        branch.share[n] = static_cast<std::uint8_t>(k);
      }
    }
    branch.cost[0] = area(branch.range) * node_cost + parted[width];
    for (int n = 2; n < width; ++n) {
      const float fewer = branch.cost[n - 2];
      if (!(parted[n] < fewer)) branch.share[n] = 0;
      branch.cost[n - 1] = std::min(parted[n], fewer);
    }
  }

  [[nodiscard]] bool is_of_one_kind(const Range& range) const noexcept {
    for (std::size_t i = range.begin + 1; i < range.end; ++i) {
      if (references_[i].is_sphere != references_[range.begin].is_sphere) return false;
    }
    return true;
  }
  [[nodiscard]] bool is_leaf(const Range& range) const {
    return range.size() <= width && is_of_one_kind(range) && fits_({&references_[range.begin], range.size()});
  }

  /// Neither part is empty.
  [[nodiscard]] std::array<Piece, 2> split(const Piece& whole) const {
    const Range& range = whole.range;
    if (range.size() <= width && !is_of_one_kind(range)) {
      return parted(range, [](const Reference& r) { return r.is_sphere == 0; });
    }
    const Binning binning(whole.centers, range.size());
    const Split best = best_split(range, binning);
    if (best.axis >= 0 && range.depth < deepest_by_area) {
      // The bins' own hulls would not do: another thread may have filled them in another rounding mode.
      const std::array<Piece, 2> halves =
          parted(range, [&](const Reference& r) { return binning.place(r, best.axis) < best.bin; });
      if (halves[0].range.size() != 0 && halves[1].range.size() != 0) return halves;
    }
    const std::size_t middle = range.begin + range.size() / 2;
    return parted(range, [this, middle](const Reference& r) { return &r < &references_[middle]; });
  }

  /// Those of which it holds come first; without branches, for nobody knows of which.
  template <class Holds>
  [[nodiscard]] std::array<Piece, 2> parted(const Range& range, const Holds& holds) const {
    std::array<Hull, 2> boxes, centers;
    std::size_t middle = range.begin;
    for (std::size_t i = range.begin; i < range.end; ++i) {
      const Reference r = references_[i];
      const bool is_first = holds(references_[i]);
      references_[i] = references_[middle];
      references_[middle] = r;
      middle += is_first ? 1 : 0;
      boxes[is_first ? 0 : 1].include(r.low_corner(), r.high_corner());
      centers[is_first ? 0 : 1].include(r.center(), r.center());
    }
    return {Piece{{range.begin, middle, boxes[0].box(), range.depth + 1}, centers[0]},
            Piece{{middle, range.end, boxes[1].box(), range.depth + 1}, centers[1]}};
  }

  [[nodiscard]] Bins filled(const Range& range, const Binning& binning) const {
    const auto part = [&](std::size_t begin, std::size_t end) {
      Bins table;
      for (std::size_t i = range.begin + begin; i < range.begin + end; ++i) {
        const Four low = references_[i].low_corner(), high = references_[i].high_corner();
        const FourIntegers places = binning.places(references_[i]);
        for (int k = 0; k < 3; ++k) {
          Bin& bin = table[places[k]][k];
          bin.hull.include(low, high);
          ++bin.size;
        }
      }
      return table;
    };
    return summed<Bins>(range.size(), threads_, part, [](Bins& sum, const Bins& table) {
      for (int i = 0; i < most_bins; ++i) {
        for (int k = 0; k < 3; ++k) sum[i][k].include(table[i][k]);
      }
    });
  }

  [[nodiscard]] Split best_split(const Range& range, const Binning& binning) const {
    const Bins table = filled(range, binning);
    // What is no more than eight and does not fit will in fours.
    const int block = range.size() > width ? width : width / 2;
    std::array<Columns, most_bins> columns;
    for (int i = 0; i < binning.bins; ++i) columns[i] = Columns(table[i]);
    std::array<Four, most_bins> cost;
    Columns sum;
    for (int i = binning.bins - 1; i > 0; --i) {
      sum.include(columns[i]);
      cost[i] = sum.cost(block);
    }
    sum = {};
    Four least = Four{} + infinity;
    FourIntegers at{};
    for (int i = 1; i < binning.bins; ++i) {
      sum.include(columns[i - 1]);
      const Four total = cost[i] + sum.cost(block);
      const FourIntegers is_less = total < least;
      least = is_less ? total : least;
      at = is_less ? FourIntegers{} + i : at;
    }
    Split best;
    for (int k = 0; k < 3; ++k) {
      if (least[k] < (best.axis < 0 ? infinity : least[best.axis])) best = {k, at[k]};
    }
    return best;
  }

  Pages<Reference>& references_;
  const Fits& fits_;
  Threads threads_;
};

}  // namespace

Children::Children(const Branch& branch) noexcept {
  if (branch.is_leaf()) {
    branches[static_cast<std::size_t>(size++)] = &branch;
  } else {
    take(*branch.one, branch.share[width]);
    take(*branch.other, width - branch.share[width]);
  }
}

void Children::take(const Branch& branch, int most) noexcept {
  while (most > 1 && branch.share[static_cast<std::size_t>(most)] == 0) --most;
  if (most == 1) {
    branches[static_cast<std::size_t>(size++)] = &branch;
  } else {
    const int first = branch.share[static_cast<std::size_t>(most)];
    take(*branch.one, first);
    take(*branch.other, most - first);
  }
}

const Branch* divide(Pages<Reference>& references, const Box& root, const Fits& fits, Threads threads, Branches& branches) {
  const Builder builder(references, fits, threads);
  return builder.branch(builder.whole(root), branches);
}

}  // namespace graze::scene
