#!/bin/bash -eu
# Builds the fuzz targets as OSS-Fuzz and ClusterFuzzLite want them: $OUT gets each fuzzer with its seeds and its dictionary.
# They set CXX, CXXFLAGS, LIB_FUZZING_ENGINE, SRC, WORK and OUT. GMP and MPFR are linked statically: where fuzzers run there are
# none.
static_library() { "$CXX" -print-file-name="lib$1.a"; }

# Nor is there Highway, which the target of scenes is linked with.
targets=$(find "$SRC/graze/fuzz/corpus" -mindepth 1 -maxdepth 1 -type d ! -name scene -printf '%f\n' | sort)
cmake -S "$SRC/graze" -B "$WORK/graze" -DCMAKE_BUILD_TYPE=RelWithDebInfo -DCMAKE_CXX_FLAGS_RELWITHDEBINFO=-g1 -DBUILD_TESTING=OFF \
  -DGRAZE_FUZZING_ENGINE="$LIB_FUZZING_ENGINE" -DGRAZE_GMP_LIBRARY="$(static_library gmp)" \
  -DGRAZE_GMPXX_LIBRARY="$(static_library gmpxx)" -DGMP_LIBRARY_RELEASE="$(static_library gmp)" \
  -DGMP_LIBRARY_DEBUG="$(static_library gmp)" -DGMPXX_LIBRARIES="$(static_library gmpxx)" \
  -DMPFR_LIBRARIES="$(static_library mpfr)"
# shellcheck disable=SC2046,SC2086
cmake --build "$WORK/graze" --parallel "$(nproc)" --target $(printf 'fuzz_%s ' $targets)
for target in $targets; do
  cp "$WORK/graze/bin/fuzz_$target" "$OUT/"
  zip -q -j "$OUT/fuzz_${target}_seed_corpus.zip" "$SRC/graze/fuzz/corpus/$target/"*
  if [ -f "$SRC/graze/fuzz/targets/$target.dict" ]; then cp "$SRC/graze/fuzz/targets/$target.dict" "$OUT/fuzz_$target.dict"; fi
done
