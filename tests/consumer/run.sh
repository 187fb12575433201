#!/usr/bin/env bash
# Installs a build folder, by default build/, and builds and runs a user's program against what was installed.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
build=$(cd "${1:-$root/build}" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cmake --install "$build" --prefix "$work/installed" >/dev/null
# A package may be moved after it was installed, and must not remember where it was built.
mv "$work/installed" "$work/moved"
if grep -rlF -e "$root" -e "$build" -e "$work" "$work/moved"; then
  echo "error: these installed files name a folder of this machine" >&2
  exit 1
fi

cmake -S "$here" -B "$work/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$work/moved"
cmake --build "$work/build"
"$work/build/consumer"
