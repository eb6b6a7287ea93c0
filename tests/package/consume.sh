# consume.sh CMAKE FOLDER CMAKE_OPTION...: builds the consumer in an emptied folder, runs it, and compares what it prints.
# The build type is one that cmake adds no flags for, so that only those of the test count.
set -eu
cmake=$1
folder=$2
shift 2
source=$(cd "$(dirname "$0")" && pwd)
rm -rf "$folder"
"$cmake" -S "$source/consumer" -B "$folder" -D CMAKE_BUILD_TYPE=Plain "$@"
"$cmake" --build "$folder"
program=$(find "$folder" -type f -name consumer -perm -u+x)
"$program" >"$folder/printed.txt"
diff "$source/consumer/expected.txt" "$folder/printed.txt"
