# Planted bugs in scenes, which generated scenes or the fuzzer's seeds must find. Compiled for one instruction set of four lanes.
if(CMAKE_CXX_FLAGS MATCHES "-fsanitize" OR NOT CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  return()
endif()
include(${PROJECT_SOURCE_DIR}/tests/mutants/mutant.cmake)
get_target_property(scene_sources graze_scene SOURCES)

foreach(source ${scene_sources})
  string(MAKE_C_IDENTIFIER "unmutated_${source}" name)
  graze_kernel_objects(${name} OPTIONS ${four_lanes} -DHWY_COMPILE_ONLY_STATIC INCLUDES ${kernel_includes} SOURCES ${kernel_dir}/${source})
endforeach()
# Those who find it, over any kernel: generated scenes against the oracle, and the replay of the fuzzer's seeds.
add_library(scene_mutant_campaign OBJECT ${PROJECT_SOURCE_DIR}/fuzz/scene/campaign.cpp)
add_library(scene_mutant_corpus OBJECT ${PROJECT_SOURCE_DIR}/fuzz/targets/scene.cpp ${PROJECT_SOURCE_DIR}/fuzz/targets/replay.cpp
                                       ${PROJECT_SOURCE_DIR}/fuzz/scene/scene_bytes.cpp)
add_library(scene_mutant_truth OBJECT ${PROJECT_SOURCE_DIR}/fuzz/scene/draft.cpp ${PROJECT_SOURCE_DIR}/fuzz/scene/truth.cpp)
foreach(part campaign corpus truth)
  target_link_libraries(scene_mutant_${part} PRIVATE graze_judge graze::graze)
endforeach()

# graze_scene_mutant(NAME BY campaign|corpus MODELS sentence FILE file FIND text REPLACE text [FMA] [CRASHES]); without a file it is the
# control, which must not be caught. FMA: what is mutated is compiled for AVX2 and FMA, where this processor has them. CRASHES: it writes
# where it must not, and ends the program.
function(graze_scene_mutant name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "FMA;CRASHES" "BY;MODELS;FILE;FIND;REPLACE" "")
  graze_choose_instructions()
  set(overlay ${CMAKE_CURRENT_BINARY_DIR}/${name})
  set(mutated)
  set(objects $<TARGET_OBJECTS:scene_mutant_${arg_BY}> $<TARGET_OBJECTS:scene_mutant_truth>)
  if(arg_FILE)
    graze_write_mutated(${name} ${arg_FILE} "${arg_FIND}" "${arg_REPLACE}" ${overlay})
  endif()
  foreach(source ${scene_sources})
    set(is_mutated FALSE)
    if(arg_FILE)
      graze_depends_on(${source} ${arg_FILE} is_mutated)
    endif()
    string(MAKE_C_IDENTIFIER "unmutated_${source}" unmutated)
    if(source STREQUAL arg_FILE)
      list(APPEND mutated ${overlay}/${source})
    elseif(is_mutated)
      list(APPEND mutated ${kernel_dir}/${source})
    else()
      list(APPEND objects $<TARGET_OBJECTS:${unmutated}>)
    endif()
  endforeach()
  if(mutated)
    graze_kernel_objects(mutated_scene_${name} OPTIONS ${instructions} -DHWY_COMPILE_ONLY_STATIC INCLUDES ${overlay}/include ${overlay}/src ${kernel_includes}
                         SOURCES ${mutated})
    list(APPEND objects $<TARGET_OBJECTS:mutated_scene_${name}>)
  endif()
  add_executable(mutant_scene_${name} ${objects})
  target_link_libraries(mutant_scene_${name} PRIVATE graze_judge graze::graze hwy::hwy)
  if(arg_BY STREQUAL "campaign")
    set(arguments 20000)
    set(sentence "of seed [0-9]+: ")
  else()
    set(arguments ${PROJECT_SOURCE_DIR}/fuzz/corpus/scene)
    set(sentence "The scene is wrong")
  endif()
  if(arg_CRASHES)
    string(APPEND sentence "|Segmentation fault|Aborted|Bus error")
  endif()
  if(arg_FILE)
    # By a shell: a program that ends itself fails a test whatever it says.
    add_test(NAME "scene: ${name} is caught" COMMAND sh -c "\"$@\" 2>&1; true" sh $<TARGET_FILE:mutant_scene_${name}> ${arguments})
    set_tests_properties("scene: ${name} is caught" PROPERTIES TIMEOUT 120 PASS_REGULAR_EXPRESSION "${sentence}")
  else()
    add_test(NAME "scene: the kernel itself is not caught by the ${arg_BY}" COMMAND mutant_scene_${name} ${arguments})
    set_tests_properties("scene: the kernel itself is not caught by the ${arg_BY}" PROPERTIES TIMEOUT 120)
  endif()
endfunction()

graze_scene_mutant(none_in_campaign BY campaign)
graze_scene_mutant(none_in_corpus BY corpus)

graze_scene_mutant(
  box_inward
  BY campaign
  MODELS "a box's low side rounded inward by 2^-20 of the coordinate"
  FILE src/scene/space.hpp
  FIND [[static_cast<float>(v - (0x1p-22 * size + 2 * error))]]
  REPLACE [[static_cast<float>(v + 0x1p-20 * size)]])

graze_scene_mutant(
  box_offset
  BY campaign
  MODELS "the offsets of the box test not widened by what they err"
  FILE src/scene/box_ray.hpp
  FIND [[float g = 0x1p-20f * __builtin_fabsf(f[k]) + error[k];]]
  REPLACE [[float g = 0;]])

graze_scene_mutant(
  box_offset_on_lanes
  BY campaign
  MODELS "the same where a ray's axes are in lanes"
  FILE src/scene/box_ray-inl.hpp
  FIND [[auto g = hn::Add(hn::Mul(set_float(0x1p-20f), hn::Abs(f)), error),]]
  REPLACE [[auto g = hn::Mul(set_float(0), error),]]
  FMA)

graze_scene_mutant(
  box_left_too_early
  BY campaign
  MODELS "the planes of a box that are met last, met earlier by 2^-16 of the way"
  FILE src/scene/box_ray.hpp
  FIND [[static constexpr float slack = 0x1p-19f;]]
  REPLACE [[static constexpr float slack = -0x1p-16f;]])

graze_scene_mutant(
  tie_later_index
  BY campaign
  MODELS "of equal t the highest index"
  FILE src/scene/query.hpp
  FIND [[order < 0 : one.index < other.index]]
  REPLACE [[order < 0 : one.index > other.index]])

graze_scene_mutant(
  end_too_early
  BY campaign
  MODELS "the ray cut off at the lower bound of the nearest hit"
  FILE src/scene/visitors-inl.hpp
  FIND [[this->end_at(found.t.high);]]
  REPLACE [[this->end_at(found.t.low);]])

graze_scene_mutant(
  cut_too_short
  BY campaign
  MODELS "a ray forgets what it enters in the last tenth before its nearest hit"
  FILE src/scene/agenda-inl.hpp
  FIND [[hn::Le(at, hn::Set(d, high))]]
  REPLACE [[hn::Le(at, hn::Set(d, 0.9f * high))]])

graze_scene_mutant(
  second_forgotten
  BY campaign
  MODELS "of a node's children that are met, the one after the nearest not kept"
  FILE src/scene/agenda-inl.hpp
  FIND [[end += key != Keys::not_met ? 1 : 0;]]
  REPLACE [[end += 0;]])

graze_scene_mutant(
  narrow_origin
  BY campaign
  MODELS "a ray's origin brought into box space in floats, off by 2^-18 of the scene"
  FILE src/scene/space.hpp
  FIND [[return (x - narrow_origin[axis]) * narrow_scale;]]
  REPLACE [[return (x - narrow_origin[axis]) * narrow_scale + 0x1p-18f;]])

graze_scene_mutant(
  narrow_origin_on_lanes
  BY campaign
  MODELS "the same where a ray's axes are in lanes"
  FILE src/scene/box_ray-inl.hpp
  FIND [[hn::LoadU(narrow, space.narrow_origin));]]
  REPLACE [[hn::Add(hn::LoadU(narrow, space.narrow_origin), set_float(0x1p-18f / space.narrow_scale)));]]
  FMA)

graze_scene_mutant(
  batch_forgets_last
  BY campaign
  MODELS "the answer of the last ray of a batch not written"
  FILE src/scene/streams-inl.hpp
  FIND [[if (slot.number < n_) batch_.finish]]
  REPLACE [[if (slot.number + 1 < n_) batch_.finish]])

graze_scene_mutant(
  enclosure_too_small
  BY campaign
  MODELS "the enclosure of a triangle's t without the determinant's error"
  FILE src/scene/enclose.hpp
  FIND [[distance + distance_error;]]
  REPLACE [[distance + 0x1p-30 * distance_error;]])

graze_scene_mutant(
  parity_skips_corner
  BY corpus
  MODELS "a way out that meets a corner not perturbed the second time"
  FILE src/exact/parity.cpp
  FIND [[return z != 0 ? z : compare(v.y, u.y);]]
  REPLACE [[return z;]])

graze_scene_mutant(
  refit_keeps_boxes
  BY corpus
  MODELS "refitting gives the leaves their shapes but the nodes no boxes"
  FILE src/scene/refit.cpp
  FIND [[      node.set(i, box, child);
    }
  }
  data.root = Box::empty();]]
  REPLACE [[      box = node.box(i);
    }
  }
  data.root = Box::empty();]])

graze_scene_mutant(
  split_counts_twice
  BY campaign
  MODELS "a triangle in several leaves counted in each"
  FILE src/scene/home-inl.hpp
  FIND [[return node.children[at->slot].index() == block;]]
  REPLACE [[return true;]])

graze_scene_mutant(
  split_without_crossings
  BY campaign
  MODELS "of a triangle beside a plane only its corners are in the box, not where its edges cross the plane"
  FILE src/scene/splits.cpp
  FIND [[const bool is_crossing = std::min]]
  REPLACE [[const bool is_crossing = false && std::min]])

graze_scene_mutant(
  face_bounds_forgotten
  BY campaign
  MODELS "a face's numbers on lanes taken for exact"
  FILE src/scene/hit_visitor-inl.hpp
  FIND [[found.bounds = {share * error, share * distance_error, is_front};]]
  REPLACE [[found.bounds = {0 * share * error, 0 * share * distance_error, is_front};]]
  FMA)

graze_scene_mutant(
  inside_counts_twice
  BY corpus
  MODELS "inside counts a triangle in several leaves in each that is met"
  FILE src/scene/inside-inl.hpp
  FIND [[verdicts.face = at_home(query_.data, box_, block, number, verdicts.face & lanes);]]
  REPLACE [[verdicts.face &= lanes;]])

graze_scene_mutant(
  split_lists_twice
  BY campaign
  MODELS "a leaf that holds two parts of a triangle lists it twice"
  FILE src/scene/build.cpp
  FIND [[leaf.end = static_cast<std::uint32_t>(last - references.begin());]]
  REPLACE [[static_cast<void>(last);]])

graze_scene_mutant(
  points_confused
  BY campaign
  MODELS "points of a leaf taken for one where their hashes are the same"
  FILE src/scene/fill.hpp
  FIND [[while (place_of[slot] != 0 &&]]
  REPLACE [[while (place_of[slot] != 0 && one.hash() == 1 &&]])

graze_scene_mutant(
  points_of_other_lanes
  BY campaign
  MODELS "the upper lanes of a vector get the lower ones' corners"
  FILE src/scene/triangles-inl.hpp
  FIND [[hn::ConcatUpperLower(d, two(2), two(0));]]
  REPLACE [[hn::ConcatUpperLower(d, two(0), two(0));]]
  FMA)

graze_scene_mutant(
  came_apart_unseen
  BY corpus
  MODELS "a refit whose points come apart that were one keeps the leaves"
  FILE src/scene/refit.cpp
  FIND [[return fits(data, lanes.size, lanes);]]
  REPLACE [[return lanes.size >= 0;]]
  CRASHES)

graze_scene_mutant(
  greatest_end_taken
  BY corpus
  MODELS "the greatest end of a range that the filter takes, in a greater one's place, rejects too"
  FILE src/scene/triangles-inl.hpp
  FIND [[if (!ray.is_t_max_greater) is_outside]]
  REPLACE [[is_outside]])
