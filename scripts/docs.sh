#!/usr/bin/env bash
# Makes the site, the guide and the API with it: docs.sh [FOLDER, out/docs]. The folder is ready for any static server. Fails if
# Doxygen warns of anything, or a link leads nowhere.
set -euo pipefail
folder=$(realpath -m "${1:-$(dirname "${BASH_SOURCE[0]}")/../out/docs}")
cd "$(dirname "${BASH_SOURCE[0]}")/.."

if ! command -v doxygen >/dev/null || ! command -v mkdocs >/dev/null; then
  scripts/install_dependencies.sh doxygen mkdocs-material mkdocs-material-extensions
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
if [[ -n $(ls -A "$folder" 2>/dev/null) && ! -e "$folder/.nojekyll" ]]; then
  echo "error: $folder is not empty, and no site that docs.sh has made" >&2
  exit 2
fi
rm -rf "$folder"
mkdir -p "$folder" "$work/api"
{
  cat docs/Doxyfile
  echo "OUTPUT_DIRECTORY = \"$work\""
  echo "GENERATE_TAGFILE = \"$work/tags.xml\""
  echo "PROJECT_NUMBER = $(sed -n 's/^ *VERSION \([0-9.]*\)$/\1/p' CMakeLists.txt)"
} | doxygen -

# Plans to look at, where the program that makes them is built and knows how.
views=()
# Not by a pipe: grep may end before the program, which then fails.
if [[ -x build/bin/certificates ]] && grep -q -e --view <<<"$(build/bin/certificates plan --help)"; then
  views=("$work/views")
  mkdir "$work/views"
  for scene in paper_five_discs drones_3d sixteen_robots; do
    build/bin/certificates plan "demos/scenes/$scene.yaml" --time 2 --quiet --view "$work/views/$scene.html"
  done
fi

/usr/bin/python3 scripts/docs_page.py "$work/docs" "$work/tags.xml" "${views[@]}"
cp -r "$work/api" "${views[@]}" "$work/docs/"
cp docs/mkdocs.yml "$work/"
mkdocs build -f "$work/mkdocs.yml" -d "$folder" 2>&1 | { grep -E "WARNING|ERROR" || true; }
# GitHub Pages would else leave out files whose names begin with an underscore.
touch "$folder/.nojekyll"
/usr/bin/python3 scripts/check_links.py "$folder"
echo "The site begins at $folder/index.html"
