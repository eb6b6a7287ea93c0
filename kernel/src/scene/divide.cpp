#include "scene/divide.hpp"

#include <algorithm>
#include <limits>

namespace graze::scene {
namespace {

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

  [[nodiscard]] std::unique_ptr<Branch> branch(const Range& range) const {
    auto out = std::make_unique<Branch>();
    out->range = range;
    if (is_leaf(range)) {
      out->cost.fill(area(range) * leaf_cost);
      return out;
    }
    const auto halves = split(range);
    for_ranges(2, range.size() > 4096 ? 1 : 2, threads_, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        (i == 0 ? out->one : out->other) = branch(i == 0 ? halves.first : halves.second);
      }
    });
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
      parted[n] = std::numeric_limits<float>::infinity();
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
  [[nodiscard]] static float blocks(std::size_t size) noexcept {
    const std::size_t whole = (size + width - 1) / width;
    return static_cast<float>(whole);
  }

  Pages<Reference>& references_;
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

std::unique_ptr<Branch> divide(Pages<Reference>& references, const Box& root, Threads threads) {
  return Builder(references, threads).branch({0, references.size(), root, 0});
}

}  // namespace graze::scene
