# How a planted bug becomes a program that must be caught: the mutated file shadows the kernel's own on the include path, what depends on
# it is compiled again, and all the rest is the unmutated kernel's objects.
set(kernel_dir ${PROJECT_SOURCE_DIR}/kernel)
set(kernel_includes ${kernel_dir}/include ${kernel_dir}/src ${PROJECT_SOURCE_DIR})
file(GLOB_RECURSE kernel_sources CONFIGURE_DEPENDS RELATIVE ${kernel_dir} ${kernel_dir}/src/*.cpp)
# The last one calls the kernel's inline functions.
set(mutable_sources ${kernel_sources} ../fuzz/kernel_calls.cpp)

# graze_kernel_objects(NAME [OPTIONS flag...] INCLUDES dir... SOURCES file...): objects with the library's flags, but cheaper to build.
# Not linked with graze::graze: nothing of the library itself may come in.
function(graze_kernel_objects name)
  cmake_parse_arguments(arg "" "" "OPTIONS;INCLUDES;SOURCES" ${ARGN})
  add_library(${name} OBJECT ${arg_SOURCES})
  target_include_directories(${name} PRIVATE ${arg_INCLUDES})
  target_compile_options(${name} PRIVATE -O1 -ffp-contract=off -Wno-psabi ${arg_OPTIONS})
endfunction()

# An object library for each source, so that a mutant takes only those that it leaves alone.
function(graze_unmutated_objects)
  foreach(source ${mutable_sources})
    string(MAKE_C_IDENTIFIER "unmutated_${source}" name)
    graze_kernel_objects(${name} INCLUDES ${kernel_includes} SOURCES ${kernel_dir}/${source})
  endforeach()
endfunction()

# Sets `result` to whether the kernel's file `source` is `file` or includes it, directly or not.
function(graze_depends_on source file result)
  set(seen)
  set(open ${source})
  while(open)
    list(POP_FRONT open current)
    if(current STREQUAL file)
      set(${result} TRUE PARENT_SCOPE)
      return()
    endif()
    list(APPEND seen ${current})
    file(STRINGS ${kernel_dir}/${current} lines REGEX "^#include \"")
    foreach(line IN LISTS lines)
      string(REGEX REPLACE "^#include \"([^\"]*)\".*" "\\1" included "${line}")
      foreach(folder include src)
        if(EXISTS ${kernel_dir}/${folder}/${included} AND NOT ${folder}/${included} IN_LIST seen)
          list(APPEND open ${folder}/${included})
        endif()
      endforeach()
    endforeach()
  endwhile()
  set(${result} FALSE PARENT_SCOPE)
endfunction()

# Writes the kernel's file with the one occurrence of a text replaced.
function(graze_write_mutated name file find replace path)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${kernel_dir}/${file})
  file(READ ${kernel_dir}/${file} text)
  string(FIND "${text}" "${find}" first)
  string(FIND "${text}" "${find}" last REVERSE)
  if(first EQUAL -1 OR NOT first EQUAL last)
    message(FATAL_ERROR "mutant ${name}: this text does not stand exactly once in kernel/${file}; "
                        "bring tests/mutants/table.cmake up to date:\n${find}")
  endif()
  string(REPLACE "${find}" "${replace}" mutated "${text}")
  # Only what has changed is written, or every configuration would build all mutants again.
  file(CONFIGURE OUTPUT ${path} CONTENT "${mutated}" @ONLY)
endfunction()

# graze_mutant(NAME MODELS sentence FILE file FIND text REPLACE text [FMA] [OPTIONS flags]): the program mutant_NAME, and the test that it
# is caught. FMA: only for processors that have it; OPTIONS make all sources be compiled again.
function(graze_mutant name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "FMA" "MODELS;FILE;FIND;REPLACE;OPTIONS" "")
  set(overlay ${CMAKE_CURRENT_BINARY_DIR}/${name})
  graze_write_mutated(${name} ${arg_FILE} "${arg_FIND}" "${arg_REPLACE}" ${overlay}/${arg_FILE})
  separate_arguments(options UNIX_COMMAND "${arg_OPTIONS}")
  set(mutated)
  set(objects $<TARGET_OBJECTS:mutant_runner>)
  foreach(source ${mutable_sources})
    graze_depends_on(${source} ${arg_FILE} is_mutated)
    if(source STREQUAL arg_FILE)
      list(APPEND mutated ${overlay}/${source})
    elseif(is_mutated OR options)
      list(APPEND mutated ${kernel_dir}/${source})
    else()
      string(MAKE_C_IDENTIFIER "unmutated_${source}" unmutated)
      list(APPEND objects $<TARGET_OBJECTS:${unmutated}>)
    endif()
  endforeach()
  graze_kernel_objects(mutated_${name} OPTIONS ${options} INCLUDES ${overlay}/include ${overlay}/src ${kernel_includes}
                       SOURCES ${mutated})
  add_executable(mutant_${name} ${objects} $<TARGET_OBJECTS:mutated_${name}>)
  target_link_libraries(mutant_${name} PRIVATE graze_judge graze_families)
  add_test(NAME "mutants: ${name} is caught" COMMAND mutant_${name})
  set_tests_properties("mutants: ${name} is caught" PROPERTIES TIMEOUT 120 SKIP_RETURN_CODE 77)
endfunction()
