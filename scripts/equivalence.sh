#!/usr/bin/env bash
# Plans the same problems with all methods and compares trees, costs and paths: they must be equal, node for node.
set -euo pipefail
root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"

usage() {
  cat <<END
usage: scripts/equivalence.sh [options] [SCENE.yaml ...]

  --planners A,B,...   planners (RRT,RRTConnect,RRTstar,EST,KPIECE1)
  --methods A,B,...    methods, the first is what the others are compared with (fcl,standard,basic,partial,shared)
  --seeds A,B,...      seeds (1,2)
  --iterations N       iterations of each plan (2000)
  --jobs N             plans at a time (1)
  --timeout SECONDS    of each plan (120)
  --plan-team PROGRAM  plan_team (build/bin/plan_team)

Without scenes: all in demos/scenes/ and in ../shared/scenes/db-cbs/, if there.
Exits with 1 if anything differs, or if a plan could not be made. A scene that is refused with all planners does not count.
END
}

planners=RRT,RRTConnect,RRTstar,EST,KPIECE1
methods=fcl,standard,basic,partial,shared
seeds=1,2
iterations=2000
jobs=1
limit=120
plan_team="$root/build/bin/plan_team"
scenes=()

# Plans one problem with all methods and prints a line: verdict, scene, planner, seed, and what there is to say.
compare() {
  local scene=$1 planner=$2 seed=$3 name folder first="" expected="" verdict=equal note=""
  name=$(basename "$scene" .yaml)
  folder=$(mktemp -d "$EQUIVALENCE_DIR/plan.XXXXXX")
  for method in ${EQUIVALENCE_METHODS//,/ }; do
    local code=0 result
    timeout "$EQUIVALENCE_LIMIT" "$EQUIVALENCE_PLAN_TEAM" "$scene" --planner "$planner" --method "$method" \
      --seed "$seed" --iterations "$EQUIVALENCE_ITERATIONS" --quiet \
      --report "$folder/$method.json" --path "$folder/$method.path" >/dev/null 2>"$folder/errors" || code=$?
    if ((code == 2)) && [[ -z "$first" ]]; then
      verdict=refused
      note=$(head -n 1 "$folder/errors")
      break
    elif ((code > 1)); then
      verdict=FAILED
      note="$method: exit code $code $(head -n 1 "$folder/errors")"
      break
    fi
    result="$(sed -nE 's/^ *"(digest|states|edges|cost|solved)": (.*[^,]),?$/\1 \2/p' "$folder/$method.json" | sort)"
    if [[ -z "$result" || "$result" != *digest* ]]; then
      verdict=FAILED
      note="$method: no digest in the report"
      break
    fi
    # Exit code and path belong to the answer, too; a path is there only if the goal was reached.
    result+=$'\n'"code $code"$'\n'"path $(cat "$folder/$method.path" 2>/dev/null | cksum || true)"
    if [[ -z "$first" ]]; then
      first=$method
      expected=$result
      note=$(sed -n 's/^states //p' <<<"$result")" states, cost "$(sed -n 's/^cost //p' <<<"$result")
    elif [[ "$result" != "$expected" ]]; then
      [[ "$verdict" == DIFFERENT ]] || note=""
      verdict=DIFFERENT
      note+="$method is not $first: $({ diff <(echo "$expected") <(echo "$result") || true; } | tr -s '\n' ' ') "
    fi
  done
  rm -rf "$folder"
  printf '%s\t%s\t%s\t%s\t%s\n' "$verdict" "$name" "$planner" "$seed" "$note"
}

if [[ "${1:-}" == --compare ]]; then
  compare "$2" "$3" "$4"
  exit
fi

while (($#)); do
  case "$1" in
    --planners) planners=$2; shift ;;
    --methods) methods=$2; shift ;;
    --seeds) seeds=$2; shift ;;
    --iterations) iterations=$2; shift ;;
    --jobs) jobs=$2; shift ;;
    --timeout) limit=$2; shift ;;
    --plan-team) plan_team=$2; shift ;;
    -h | --help) usage; exit ;;
    -*) usage >&2; exit 2 ;;
    *) scenes+=("$1") ;;
  esac
  shift
done

if [[ ! -x "$plan_team" ]]; then
  echo "equivalence.sh: there is no $plan_team: build it first, with scripts/build.sh" >&2
  exit 2
fi
if ((${#scenes[@]} == 0)); then
  for folder in "$root/demos/scenes" "$root/../shared/scenes/db-cbs"; do
    if [[ -d "$folder" ]]; then
      scenes+=("$folder"/*.yaml)
    else
      echo "skipped, not there: $folder"
    fi
  done
fi

EQUIVALENCE_DIR=$(mktemp -d)
trap 'rm -rf "$EQUIVALENCE_DIR"' EXIT
export EQUIVALENCE_DIR EQUIVALENCE_METHODS=$methods EQUIVALENCE_ITERATIONS=$iterations
export EQUIVALENCE_LIMIT=$limit EQUIVALENCE_PLAN_TEAM=$plan_team
results="$EQUIVALENCE_DIR/results"

for scene in "${scenes[@]}"; do
  for planner in ${planners//,/ }; do
    for seed in ${seeds//,/ }; do
      printf '%s\0%s\0%s\0' "$scene" "$planner" "$seed"
    done
  done
done >"$EQUIVALENCE_DIR/tasks"
tasks=$(tr -cd '\0' <"$EQUIVALENCE_DIR/tasks" | wc -c)
xargs -0 -n 3 -P "$jobs" "$BASH" "$root/scripts/equivalence.sh" --compare <"$EQUIVALENCE_DIR/tasks" >"$results" || true

echo "${methods//,/, } with $iterations iterations, seeds ${seeds//,/, }"
echo
{
  printf 'scene\tplanner\tequal\tdifferent\tstates\tnote\n'
  sort -t $'\t' -k2,2 -k3,3 -k4,4n "$results" | awk -F '\t' '
    $1 == "refused" { if (!seen[$2]++) print $2 "\t-\t-\t-\t-\trefused: " $5; next }
    {
      key = $2 "\t" $3
      if (!(key in total)) order[++count] = key
      ++total[key]
      if ($1 == "equal") { ++equal[key]; states[key] += $5 }
      else if (!(key in note)) note[key] = $1 ", seed " $4 ": " $5
      else ++more[key]
    }
    END {
      for (i = 1; i <= count; ++i) {
        key = order[i]
        others = key in more ? " and " more[key] " more" : ""
        print key "\t" equal[key] + 0 "\t" total[key] - equal[key] "\t" states[key] + 0 "\t" note[key] others
      }
    }'
} | awk -F '\t' '{ printf "%-34s %-12s %6s %10s %9s  %s\n", $1, $2, $3, $4, $5, $6 }'

number() {
  awk -F '\t' -v verdict="$1" '$1 == verdict { ++n } END { print n + 0 }' "$results"
}
echo
awk -F '\t' '$1 == "equal" { all += $5 + 0; small += $5 + 0 < 10 } END {
  printf "Trees compared have %d states; %d of them have fewer than 10, which tells little.\n", all, small }' "$results"
echo "$(number equal) equal, $(number DIFFERENT) different, $(number FAILED) failed, $(number refused) refused;" \
  "each with the methods $methods"
if ((3 * $(wc -l <"$results") != tasks)); then
  echo "equivalence.sh: some comparisons came to no result" >&2
  exit 1
fi
partly=$(awk -F '\t' '$1 == "refused" { refused[$2] } $1 != "refused" { planned[$2] } END {
  for (scene in refused) n += scene in planned
  print n + 0 }' "$results")
if ((partly > 0)); then
  echo "equivalence.sh: $partly scenes were refused with some of the planners" >&2
  exit 1
fi
(($(number DIFFERENT) + $(number FAILED) == 0 && $(number equal) > 0))
