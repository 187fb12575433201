#!/usr/bin/env bash
# Plans for the paper's five discs with and without certificates, compares the two runs, and writes a short benchmark
# log. Pictures, reports and the log go to out/.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

scene=demos/scenes/paper_five_discs.yaml
iterations=${ITERATIONS:-10000}

scripts/build.sh plan_team benchmark_team
mkdir -p out

for method in fcl shared; do
  echo
  echo "== plan_team --method $method"
  build/bin/plan_team "$scene" --planner RRTstar --range 10 --iterations "$iterations" --seed 1 --method "$method" \
    --simplify --picture "out/five_discs_$method.svg" --report "out/five_discs_$method.json" \
    || (($? == 1))  # No solution in so few iterations: the trees can be compared all the same.
done

echo
echo "== fcl and shared compared"
scripts/compare_reports.py out/five_discs_fcl.json out/five_discs_shared.json

echo
echo "== benchmark_team"
build/bin/benchmark_team "$scene" --planners RRT,RRTConnect --methods fcl,standard,shared --runs 2 --time 1 \
  --log out/benchmark.log
echo
echo "Written to out/. The log goes into a database for Planner Arena with"
echo "  ompl_benchmark_statistics out/benchmark.log -d out/benchmark.db"
