#!/usr/bin/env bash
# Runs an experiment and makes its report: on this machine, or, where Slurm answers, on its cluster. What was interrupted
# goes on where it stopped.
#
#     scripts/experiment.sh demos/experiments/paper-small.yaml out/paper-small [SNAKEMAKE_OPTION...]
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

if (($# < 2)); then
  sed -n '2,5s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2
  exit 2
fi
grid=$1 out=$2
shift 2

where=(--cores "${EXPERIMENT_CORES:-$(nproc)}")
if [[ ${EXPERIMENT_LOCAL:-} != 1 ]] && command -v sinfo >/dev/null && timeout 10 sinfo >/dev/null 2>&1; then
  where=(--profile "$here/demos/experiments/slurm")
fi
mkdir -p "$out"
exec snakemake --snakefile "$here/demos/experiments/Snakefile" --directory "$out" "${where[@]}" --rerun-incomplete \
  "$@" --config grid="$(realpath "$grid")" out="$(realpath "$out")" shards="${EXPERIMENT_SHARDS:-4}" \
  program="${EXPERIMENT_PROGRAM:-$here/build/bin/certificate_experiment}"
