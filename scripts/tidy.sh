#!/usr/bin/env bash
# Runs clang-tidy with the checks of .clang-tidy, all of them errors, over src/ and the headers that it includes, which
# takes some ten minutes on two cores, or over the files that are named as arguments. With --changed [COMMIT] over those
# that have changed since COMMIT: by default since the branch left main, on main itself since the last release, but within
# the last 50 commits. These are at most 10, those that changed last, in some two minutes; it says which it leaves out.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

most_commits=50
most_files=10

# Where the changes begin that nobody has looked at
default_base() {
  local ref base
  for ref in origin/main main; do
    if base=$(git merge-base "$ref" HEAD 2>/dev/null) && [[ "$base" != $(git rev-parse HEAD) ]]; then
      echo "$base"
      return
    fi
  done
  base=$(git rev-list --first-parent --max-count=$((most_commits + 1)) HEAD | tail -n 1)
  if ref=$(git describe --tags --abbrev=0 HEAD~1 2>/dev/null) && git merge-base --is-ancestor "$base" "$ref"; then
    base=$ref
  fi
  echo "$base"
}

files=("$@")
if (($# == 0)); then
  files=(src/*/*.cpp)
elif [[ "$1" == --changed ]]; then
  base=$(git rev-parse --verify --end-of-options "${2:-$(default_base)}^{commit}")
  # The last change first; for a header, the source of the same name.
  readarray -t files < <(git log --format= --name-only "$base..HEAD" -- src include |
    sed 's|^include/ompl_certificates/|src/|; s|\.h$|.cpp|' | awk '!seen[$0]++' | while read -r file; do
    if [[ "$file" == *.cpp && -e "$file" ]]; then
      echo "$file"
    fi
  done)
  echo "Since $(git log -1 --format='%h, %s' "$base"): ${#files[@]} files"
  if ((${#files[@]} > most_files)); then
    echo "Left out, for they changed first: ${files[*]:most_files}"
    files=("${files[@]:0:most_files}")
  fi
fi
if ((${#files[@]} == 0)); then
  echo "Nothing to look at."
  exit 0
fi

scripts/install_dependencies.sh clang clang-tidy
# Clang cannot read GCC's precompiled headers, and looks at one file at a time. Nothing is built: cmake only tells how
# files are compiled, those of tests and programs, too.
cmake -S . -B build-tidy -G Ninja -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON \
  -DCMAKE_UNITY_BUILD=OFF \
  -DOMPL_CERTIFICATES_BUILD_DEMOS=ON -DOMPL_CERTIFICATES_BUILD_TESTS=ON -DOMPL_CERTIFICATES_BUILD_BENCHMARKS=ON \
  >/dev/null
printf '%s\0' "${files[@]}" | xargs -0 -n 1 -P 2 clang-tidy --quiet --warnings-as-errors='*' -p build-tidy
