// A second kernel beside the exact scene, ray by ray of a picture.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "cli/camera.hpp"
#include "cli/primitives.hpp"
#include "fuzz/subject.hpp"

namespace graze::cli {

/// How a kernel that is asked about each primitive, and the nearest hit taken, sees a pixel.
enum class Finding : std::uint8_t {
  agrees,  ///< it takes one of the nearest, and answers as it should, but for what it declares to do otherwise
  lost,    ///< it hits nothing, or takes one farther off that has no corner in common with the nearest: the ray slips through
  false_hit,      ///< it hits, where there is nothing
  other_nearest,  ///< it takes another than the nearest: a neighbour, or one that is not hit, or not so near
  wrong_kind,     ///< the nearest is right, not its kind or which side it is seen from
  wrong_number,   ///< nothing but a number is wrong: farther off than the kernel declares
  failed,         ///< it crashed, hung, or answered what is none
};
inline constexpr int finding_count = 7;

template <Real T>
class SecondKernel {
 public:
  /// What is given must outlive this.
  SecondKernel(const fuzz::Subject& kernel, const Primitives<T>& primitives, const Camera& camera);

  /// The findings of a row of pixels: rays[x] with the exact scene's ties[x]. Asks about every primitive whose box is seen
  /// within a pixel of the ray.
  void judge_row(int y, std::span<const Ray<T>> rays, std::span<const std::vector<SceneHit<T>>> ties,
                 std::span<Finding> findings);

  /// The query that the kernel does not offer, a name of the contract's; empty while there was none.
  [[nodiscard]] const std::string& not_offered() const { return not_offered_; }

 private:
  /// The pixels that a primitive may be seen in.
  struct Rectangle {
    int left, top, right, bottom;
  };
  /// The nearest hit so far.
  struct Pixel {
    bool is_hit = false, has_failed = false;
    T t{};
    std::uint32_t index = 0;
    fuzz::Answer<T> answer;
  };
  struct Question {
    int x;
    std::uint32_t index;
  };

  void ask();
  [[nodiscard]] Finding finding(const Pixel& pixel, const Ray<T>& ray, const std::vector<SceneHit<T>>& ties) const;

  const fuzz::Subject& kernel_;
  const Primitives<T>& primitives_;
  std::vector<Rectangle> seen_;
  std::vector<Pixel> row_;
  std::vector<Question> questions_;
  std::vector<fuzz::Case<T>> cases_;
  std::string not_offered_;
};

}  // namespace graze::cli
