// The first generated scenes of a stream.
#pragma once

#include <string_view>

#include "fuzz/scene/draft.hpp"
#include "tests/catch.hpp"

namespace graze::test {

inline constexpr std::uint64_t scene_seed = 1;

/// Calls visit(draft, scene, random) for each; options_of(i) tells how the i-th is built.
template <Real T, class OptionsOf, class Visit>
void each_scene(std::string_view name, std::uint64_t scenes, OptionsOf options_of, Visit visit) {
  const fuzz::Random stream(scene_seed, name, sizeof(T));
  for (std::uint64_t i = 0; i < scenes; ++i) {
    fuzz::Random random = stream.at(i);
    const fuzz::SceneDraft<T> draft = fuzz::draft_scene<T>(random);
    Scene<T> scene;
    INFO("seed " << scene_seed << ", scene " << i << ", " << draft.family);
    REQUIRE(scene.build(draft.parts, options_of(i)).ok());
    REQUIRE(scene.size() == draft.primitives.size());
    visit(draft, scene, random);
  }
}

}  // namespace graze::test
