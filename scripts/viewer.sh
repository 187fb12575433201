#!/usr/bin/env bash
# Builds the viewer's page, viewer/dist/viewer.html, from viewer/src. Needs node and npm, which nothing else here does.
#
#     scripts/viewer.sh            build it
#     scripts/viewer.sh --check    only tell whether the page is what the sources give
#     scripts/viewer.sh --test     open plans of build/bin/certificates, or of the program that is named, in Chromium
#
# Returns 77, which ctest takes for skipped, where a check or a test lacks what it needs.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

skip()
{
  echo "skipped: $*"
  exit 77
}

mode=${1:---build}
if [[ $mode != --build ]]; then
  command -v node >/dev/null || skip "no node here"
fi
if [[ $mode == --test ]]; then
  CHROMIUM=${CHROMIUM:-$(command -v chromium || command -v chromium-browser || command -v google-chrome || true)}
  [[ -n $CHROMIUM ]] || skip "no Chromium here"
  export CHROMIUM
  CERTIFICATES=$(realpath "${2:-build/bin/certificates}")
  export CERTIFICATES
fi

# What package-lock.json names, once. Tests at the same time wait for each other.
exec 9<viewer/package-lock.json
flock 9
if [[ ! viewer/node_modules/.package-lock.json -nt viewer/package-lock.json ]]; then
  npm ci --prefix viewer --no-progress || { [[ $mode == --build ]] && exit 1 || skip "npm could not install"; }
  touch viewer/node_modules/.package-lock.json
fi
flock -u 9

cd viewer
case $mode in
  --build) node build.mjs ;;
  --check) node build.mjs --check ;;
  --test) node --test --test-reporter=spec test/*.test.mjs ;;
  *) echo "viewer.sh: what is $mode?" >&2; exit 2 ;;
esac
