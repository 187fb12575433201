#!/usr/bin/env bash
# Runs clang-tidy with the checks of .clang-tidy, all of them errors, over src/ and the headers that it includes, which
# takes some ten minutes on two cores, or over the files that are named as arguments, or with --changed over those that
# the last commit has changed.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

files=("$@")
if (($# == 0)); then
  files=(src/*/*.cpp)
elif [[ "$1" == --changed ]]; then
  if ! git rev-parse --quiet --verify HEAD~1 >/dev/null; then
    echo "No commit before this one is known here."
    exit 0
  fi
  # For a header, the source of the same name.
  readarray -t files < <(git diff --name-only --diff-filter=d HEAD~1 -- src include |
    sed 's|^include/ompl_certificates/|src/|; s|\.h$|.cpp|' | sort -u | while read -r file; do
    if [[ "$file" == *.cpp && -e "$file" ]]; then
      echo "$file"
    fi
  done)
fi
if ((${#files[@]} == 0)); then
  echo "Nothing to look at."
  exit 0
fi

scripts/install_dependencies.sh clang clang-tidy
# Clang cannot read GCC's precompiled headers.
cmake -S . -B build-tidy -G Ninja -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON \
  -DOMPL_CERTIFICATES_BUILD_DEMOS=OFF -DOMPL_CERTIFICATES_BUILD_TESTS=OFF -DOMPL_CERTIFICATES_BUILD_BENCHMARKS=OFF \
  >/dev/null
printf '%s\0' "${files[@]}" | xargs -0 -n 1 -P 2 clang-tidy --quiet --warnings-as-errors='*' -p build-tidy
