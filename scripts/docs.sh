#!/usr/bin/env bash
# Makes the site, the guide and the API with it: docs.sh [FOLDER, out/docs]. The folder is ready for any static server. Fails if
# Doxygen warns of anything, or a link leads nowhere; then the folder stays as it was.
set -euo pipefail
folder=$(realpath -m "${1:-$(dirname "${BASH_SOURCE[0]}")/../out/docs}")
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# The mark of what this script may replace
mark=.made-by-docs.sh
if [[ -e "$folder/.git" || ( -n $(ls -A "$folder" 2>/dev/null) && ! -e "$folder/$mark" ) ]]; then
  echo "error: $folder is not empty, and not only a site that docs.sh has made" >&2
  exit 2
fi

if ! command -v doxygen >/dev/null || ! command -v mkdocs >/dev/null; then
  scripts/install_dependencies.sh doxygen mkdocs-material mkdocs-material-extensions
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/api"
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
mkdocs build -f "$work/mkdocs.yml" -d "$work/site" 2>&1 | { grep -E "WARNING|ERROR" || true; }
# GitHub Pages would else leave out files whose names begin with an underscore.
touch "$work/site/.nojekyll" "$work/site/$mark"
/usr/bin/python3 scripts/check_links.py "$work/site"
rm -rf "$folder"
mkdir -p "$(dirname "$folder")"
mv "$work/site" "$folder"
echo "The site begins at $folder/index.html"
