#!/usr/bin/env bash
# Makes the API site with the pages of docs/ in it: docs.sh [FOLDER, out/docs]. Fails if Doxygen warns of anything.
set -euo pipefail
folder=$(realpath -m "${1:-$(dirname "${BASH_SOURCE[0]}")/../out/docs}")
cd "$(dirname "${BASH_SOURCE[0]}")/.."

command -v doxygen >/dev/null || scripts/install_dependencies.sh doxygen
mkdir -p "$folder"
{
  cat docs/Doxyfile
  echo "OUTPUT_DIRECTORY = \"$folder\""
  echo "PROJECT_NUMBER = $(sed -n 's/^ *VERSION \([0-9.]*\)$/\1/p' CMakeLists.txt)"
} | doxygen -
echo "The site begins at $folder/index.html"
