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

mkdir "$work/readme"
echo '#include <ompl_certificates/planning/TeamSetup.h>
int main() { return ompl_certificates::allMethods().empty(); }' >"$work/readme/main.cpp"
{
  printf 'cmake_minimum_required(VERSION 3.22)\nproject(readme LANGUAGES CXX)\nadd_executable(your_program main.cpp)\n'
  sed -n '/^```cmake$/,/^```$/{/^```/!p}' "$root/README.md"
} >"$work/readme/CMakeLists.txt"
grep -q '^target_link_libraries(your_program' "$work/readme/CMakeLists.txt"
cmake -S "$work/readme" -B "$work/readme/build" -G Ninja -DCMAKE_PREFIX_PATH="$work/moved"
cmake --build "$work/readme/build"
"$work/readme/build/your_program"

if [[ -x "$work/moved/bin/plan_team" ]]; then
  for program in plan_team benchmark_team generate_scene certificate_experiment; do
    "$work/moved/bin/$program" --version
    # A library of ours that is found in the build folder would not be found elsewhere.
    if ! ldd "$work/moved/bin/$program" | grep -q "libompl_certificates.*$work/moved/"; then
      echo "error: $program does not use the installed libraries" >&2
      exit 1
    fi
  done
  cd "$work"
  moved/bin/generate_scene --robots 2 --obstacles 10 --seed 1 --output scene.yaml
  moved/bin/plan_team scene.yaml --planner RRTConnect --simplify --path path.csv
  head -n 1 path.csv
fi
