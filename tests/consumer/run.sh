#!/usr/bin/env bash
# Installs a build folder, by default build/, builds and runs a user's program against what was installed, also by the
# lines of CMake that README.md gives, and runs the installed programs.
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

# What is wrong with a component is said.
refused()
{
  if cmake -S "$here" -B "$work/refused" -DCMAKE_PREFIX_PATH="$work/moved" "${@:2}" >"$work/refused.log" 2>&1 ||
    ! tr -s '\n ' ' ' <"$work/refused.log" | grep -qF "$1"; then
    cat "$work/refused.log"
    echo "error: not refused because of: $1" >&2
    exit 1
  fi
  rm -rf "$work/refused"
}
refused 'Component "scen": there is no such component' -DCOMPONENTS=scen
refused 'Component "pictures": not found here: pugixml' "-DCOMPONENTS=octomap;pictures" -DCMAKE_DISABLE_FIND_PACKAGE_pugixml=ON

for page in README docs/install; do
  project="$work/$(basename "$page")"
  mkdir "$project"
  echo '#include <ompl_certificates/planning/TeamSetup.h>
int main() { return ompl_certificates::allMethods().empty(); }' >"$project/main.cpp"
  {
    printf 'cmake_minimum_required(VERSION 3.22)\nproject(page LANGUAGES CXX)\nadd_executable(your_program main.cpp)\n'
    sed -n '/^```cmake$/,/^```$/{/^```/!p}' "$root/$page.md"
  } >"$project/CMakeLists.txt"
  grep -q '^target_link_libraries(your_program' "$project/CMakeLists.txt"
  # The scene library is not in each build.
  if [[ $page == docs/install && ! -x "$work/moved/bin/certificates" ]]; then
    continue
  fi
  cmake -S "$project" -B "$project/build" -G Ninja -DCMAKE_PREFIX_PATH="$work/moved"
  cmake --build "$project/build"
  "$project/build/your_program"
done

if [[ -x "$work/moved/bin/certificates" ]]; then
  for program in certificates plan_team benchmark_team generate_scene certificate_experiment; do
    "$work/moved/bin/$program" --version
    # A library of ours that is found in the build folder would not be found elsewhere.
    # Not by a pipe: grep may end before ldd, which then fails.
    libraries=$(ldd "$work/moved/bin/$program")
    if ! grep -q "libompl_certificates.*$work/moved/" <<< "$libraries"; then
      echo "error: $program does not use the installed libraries" >&2
      exit 1
    fi
  done
  cd "$work"
  moved/bin/certificates generate --robots 2 --obstacles 10 --seed 1 --output scene.yaml
  moved/bin/certificates plan scene.yaml --planner RRTConnect --simplify --path path.csv
  head -n 1 path.csv
fi
