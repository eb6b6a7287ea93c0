# install.sh CMAKE BUILD_FOLDER PREFIX CONFIG: installs into an empty prefix, so that nothing of an earlier run can help.
set -eu
rm -rf "$3"
"$1" --install "$2" --prefix "$3" --config "$4"
