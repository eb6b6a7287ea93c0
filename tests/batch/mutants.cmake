# Planted bugs in the batches, which batches of random length must find. Compiled for one instruction set of four lanes, the cheapest
# that has tails; FMA: for one with multiply-adds, where this processor has them.
if(CMAKE_CXX_FLAGS MATCHES "-fsanitize" OR NOT CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  return()
endif()
include(${PROJECT_SOURCE_DIR}/tests/mutants/mutant.cmake)

get_target_property(batch_sources graze_batch SOURCES)

function(graze_batch_mutant name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "FMA" "MODELS;FILE;FIND;REPLACE" "")
  graze_choose_instructions()
  set(overlay ${CMAKE_CURRENT_BINARY_DIR}/${name})
  graze_write_mutated(${name} ${arg_FILE} "${arg_FIND}" "${arg_REPLACE}" ${overlay})
  set(sources)
  foreach(source ${batch_sources})
    if(EXISTS ${overlay}/${source})
      list(APPEND sources ${overlay}/${source})
    else()
      list(APPEND sources ${kernel_dir}/${source})
    endif()
  endforeach()
  add_executable(mutant_batch_${name} random_batches.cpp ${PROJECT_SOURCE_DIR}/fuzz/batch_check.cpp
                                      ${PROJECT_SOURCE_DIR}/fuzz/random_batch.cpp ${sources})
  target_include_directories(mutant_batch_${name} PRIVATE ${overlay}/include ${overlay}/src ${kernel_includes})
  target_compile_options(mutant_batch_${name} PRIVATE -O1 -ffp-contract=off -Wno-psabi ${instructions})
  target_compile_definitions(mutant_batch_${name} PRIVATE HWY_COMPILE_ONLY_STATIC)
  target_link_libraries(mutant_batch_${name} PRIVATE graze_case_text graze_families graze::graze hwy::hwy)
  add_test(NAME "batch: ${name} is caught" COMMAND mutant_batch_${name} 200000)
  set_tests_properties("batch: ${name} is caught" PROPERTIES TIMEOUT 120 PASS_REGULAR_EXPRESSION "batch [0-9]+ of seed")
endfunction()

graze_batch_mutant(
  lane_off_by_one
  MODELS "what was in doubt written to the next lane"
  FILE src/batch/doubts.hpp
  FIND [[std::uint64_t(is_hit) << bit;]]
  REPLACE [[std::uint64_t(is_hit) << (bit ^ 1);]])

graze_batch_mutant(
  tail_too_short
  MODELS "the last lane left out of a tail"
  FILE src/batch/lanes-inl.hpp
  FIND [[first, count * sizeof(T));]]
  REPLACE [[first, (count - 1) * sizeof(T));]])

graze_batch_mutant(
  edge_constant
  MODELS "the bound of the weights' errors too small by 2^8"
  FILE src/batch/sheared_triangles-inl.hpp
  FIND [[edge_error = T(sheared_error) *]]
  REPLACE [[edge_error = T(0x1p-8) * T(sheared_error) *]])

graze_batch_mutant(
  unit_sphere_constant
  MODELS "the bound of a discriminant's error too small by 2^8"
  FILE src/batch/unit_spheres-inl.hpp
  FIND [[bound = T(unit_sphere_error) *]]
  REPLACE [[bound = T(0x1p-8) * T(unit_sphere_error) *]])

graze_batch_mutant(
  radii_of_words_unseen
  MODELS "whole words decided with an invalid radius among them"
  FILE src/batch/unit_spheres-inl.hpp
  FIND [[ || !certainty.radii.holds()]]
  REPLACE [[]])

graze_batch_mutant(
  doubt_of_words_unseen
  MODELS "whole words decided with a doubtful lane among them"
  FILE src/batch/unit_spheres-inl.hpp
  FIND [[!certainty.decisions.holds() || ]]
  REPLACE [[]])

graze_batch_mutant(
  lattice_without_center FMA
  MODELS "a center that lies between the steps of the lattice"
  FILE src/batch/on_lattice-inl.hpp
  FIND [[positions.include(center), ]]
  REPLACE [[]])

graze_batch_mutant(
  lattice_without_ray FMA
  MODELS "an origin that lies between the steps of the lattice"
  FILE src/batch/on_lattice-inl.hpp
  FIND [[last * 0x1p53]]
  REPLACE [[last * 0x1p93]])

graze_batch_mutant(
  deposited_at_neighbour FMA
  MODELS "what is known of a gathered lane given to the next"
  FILE src/batch/on_lattice.cpp
  FIND [[verdicts.hit[0] >> at,]]
  REPLACE [[verdicts.hit[0] >> (at ^ 1),]])

graze_batch_mutant(
  lattice_too_fine FMA
  MODELS "a lattice of so many steps that products are rounded"
  FILE src/batch/on_lattice-inl.hpp
  FIND [[fineness = 0x1p28;]]
  REPLACE [[fineness = 0x1p16;]])

graze_batch_mutant(
  nearest_tie
  MODELS "of equal hits the last"
  FILE src/batch/nearest.cpp
  FIND [[lane(shapes, best.index)) >= 0]]
  REPLACE [[lane(shapes, best.index)) > 0]])
