# refused.sh INCLUDE_FOLDER COMPILER FLAG...: each header that computes must be refused under these flags, and say why.
set -eu
include=$1
shift
for header in "$include"/graze/*.hpp; do
  name=graze/${header##*/}
  case "$name" in
    graze/types.hpp | graze/answer.hpp | graze/textbook.hpp) continue ;;  # plain data; formulas that promise nothing
  esac
  if message=$(echo "#include \"$name\"" | "$@" -std=c++20 -I "$include" -fsyntax-only -x c++ - 2>&1); then
    echo "$name is accepted under $*"
    exit 1
  fi
  case "$message" in
    *"graze: compile without -ffast-math"*) echo "$name is refused" ;;
    *)
      echo "$name is refused, but without its message: $message"
      exit 1
      ;;
  esac
done
