#!/usr/bin/env bash
# Feeds broken scenes, .cfg files, meshes, clouds, octomaps, files of arms and of certificates to their readers:
# fuzz.sh [SECONDS each, 60 [SEED [INPUTS]]]. A number of inputs, of one seed, makes a run that can be repeated, if the
# time suffices for them.
# Two readers are fed at a time. What they print is in out/fuzz/<reader>.log, and printed when they end.
# What ends a reader otherwise than by ompl::Exception, takes over 20 s or over 2 GB of memory is kept in out/fuzz/,
# with the inputs that later runs start from.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

seconds=${1:-60}
seed=${2:-0}  # 0: another one each time
inputs=${3:--1}  # -1: as many as there is time for
corpora=(tests/fuzz/corpus/*/)
scripts/build_sanitized.sh $(basename -a "${corpora[@]}" | sed s/^/fuzz_/)

# Leaks inside Boost that exceptions cause are its own and end with the program; they are not looked for.
export ASAN_OPTIONS=detect_leaks=0:quarantine_size_mb=16
fuzz()
{
  local corpus=$1 target
  target=$(basename "$corpus")
  local seeds=("$corpus") failed=0
  if [[ "$target" == yaml ]]; then
    seeds+=(demos/scenes)
  fi
  echo "==== $target begins, for at most $seconds s"
  # The outer limit is for libFuzzer, which needs very long to tell where the memory of an input went.
  timeout --kill-after=10 $((seconds + 120)) \
    build-sanitize/bin/fuzz_"$target" "out/fuzz/$target" "${seeds[@]}" -artifact_prefix="out/fuzz/$target-" -detect_leaks=0 \
    -max_total_time="$seconds" -runs="$inputs" -seed="$seed" -timeout=20 -rss_limit_mb=2048 -malloc_limit_mb=512 \
    -max_len=4096 -print_final_stats=1 -verbosity=0 >"out/fuzz/$target.log" 2>&1 || failed=1
  printf '\n==== %s has ended\n%s\n' "$target" "$(cat "out/fuzz/$target.log")"
  return "$failed"
}
export -f fuzz
export seconds seed inputs
for corpus in "${corpora[@]}"; do
  mkdir -p "out/fuzz/$(basename "$corpus")"
done
printf '%s\0' "${corpora[@]}" | xargs -0 -n 1 -P 2 bash -c 'set -euo pipefail; fuzz "$1"' fuzz
