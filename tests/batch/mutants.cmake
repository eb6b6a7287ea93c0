# Planted bugs in the batches, which batches of random length must find. Compiled for one instruction set of four lanes: the cheapest
# that has tails.
if(CMAKE_CXX_FLAGS MATCHES "-fsanitize" OR NOT CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  return()
endif()
include(${PROJECT_SOURCE_DIR}/tests/mutants/mutant.cmake)

function(graze_batch_mutant name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "MODELS;FILE;FIND;REPLACE" "")
  set(overlay ${CMAKE_CURRENT_BINARY_DIR}/${name})
  graze_write_mutated(${name} ${arg_FILE} "${arg_FIND}" "${arg_REPLACE}" ${overlay}/${arg_FILE})
  set(sources)
  foreach(source hits intersect nearest spheres triangles)
    if(EXISTS ${overlay}/src/batch/${source}.cpp)
      list(APPEND sources ${overlay}/src/batch/${source}.cpp)
    else()
      list(APPEND sources ${kernel_dir}/src/batch/${source}.cpp)
    endif()
  endforeach()
  add_executable(mutant_batch_${name} random_batches.cpp ${PROJECT_SOURCE_DIR}/fuzz/batch_check.cpp
                                      ${PROJECT_SOURCE_DIR}/fuzz/random_batch.cpp ${sources})
  target_sources(mutant_batch_${name} PRIVATE ${kernel_dir}/src/exact/order.cpp)
  target_include_directories(mutant_batch_${name} PRIVATE ${overlay}/include ${overlay}/src ${kernel_includes})
  target_compile_options(mutant_batch_${name} PRIVATE -O1 -ffp-contract=off -Wno-psabi -msse4.2 -maes -mpclmul)
  target_compile_definitions(mutant_batch_${name} PRIVATE HWY_COMPILE_ONLY_STATIC)
  target_link_libraries(mutant_batch_${name} PRIVATE graze_case_text graze_families graze::graze hwy::hwy)
  add_test(NAME "batch: ${name} is caught" COMMAND mutant_batch_${name} 200000)
  set_tests_properties("batch: ${name} is caught" PROPERTIES TIMEOUT 120 PASS_REGULAR_EXPRESSION "batch [0-9]+ of seed")
endfunction()

graze_batch_mutant(
  lane_off_by_one
  MODELS "what was in doubt written to the next lane"
  FILE src/batch/hits.cpp
  FIND [[<< bit;]]
  REPLACE [[<< (bit ^ 1);]])

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
  FIND [[edge_error = 16 *]]
  REPLACE [[edge_error = T(0x1p-8) * 16 *]])

graze_batch_mutant(
  nearest_tie
  MODELS "of equal hits the last"
  FILE src/batch/nearest.cpp
  FIND [[lane(shapes, best.index)) >= 0]]
  REPLACE [[lane(shapes, best.index)) > 0]])
