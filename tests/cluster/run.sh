#!/usr/bin/env bash
# Runs an experiment through Slurm on this machine alone, kills a job and the controller in the middle, and checks that the
# results equal those of a local run, trial by trial. Needs root, and the programs named below; else it is skipped (77).
#
#     tests/cluster/run.sh [GRID.yaml]
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
grid=${1:-$here/demos/experiments/paper-small.yaml}

for program in snakemake munged mungekey slurmctld slurmd sbatch scontrol ompl_benchmark_statistics; do
  if ! PATH=$PATH:/usr/sbin command -v "$program" >/dev/null; then
    echo "skipped: no $program"
    exit 77
  fi
done
if ((EUID != 0)) || ! /usr/bin/python3 -c 'import pandas, matplotlib' 2>/dev/null; then
  echo "skipped: needs root, pandas and matplotlib"
  exit 77
fi
PATH=$PATH:/usr/sbin

work=$(mktemp -d)
chmod 755 "$work"
pids=()
cleanup()
{
  local code=$?
  set +e
  [[ -n ${SLURM_CONF:-} ]] && timeout 10 scancel --state=RUNNING,PENDING --user=root >/dev/null 2>&1
  for pid in "${pids[@]}"; do kill "$pid" 2>/dev/null; done
  for pid in "${pids[@]}"; do wait "$pid" 2>/dev/null; done
  if ((code == 0)); then rm -rf "$work"; else echo "what happened is in $work" >&2; fi
  exit "$code"
}
trap cleanup EXIT

fail()
{
  echo "FAILED: $*" >&2
  exit 1
}

# Wait up to $1 seconds for a command to succeed.
await()
{
  local end=$((SECONDS + $1))
  shift
  until "$@" >/dev/null 2>&1; do
    ((SECONDS < end)) || fail "still not: $*"
    sleep 0.2
  done
}

start_controller()
{
  slurmctld -D -f "$SLURM_CONF" >>"$work/slurmctld.out" 2>&1 &
  controller=$!
  pids+=("$controller")
}

echo "== Slurm on this machine alone"
mkdir -p "$work/munge" "$work/state" "$work/spool"
mungekey --create --keyfile "$work/munge/key"
munged --foreground --force --key-file="$work/munge/key" --socket="$work/munge/socket" \
  --pid-file="$work/munge/pid" --log-file="$work/munge/log" --seed-file="$work/munge/seed" >"$work/munged.out" 2>&1 &
pids+=($!)
await 20 test -S "$work/munge/socket"
node=$(hostname -s)
port=$((20000 + RANDOM % 10000))
cat >"$work/slurm.conf" <<CONF
ClusterName=alone
SlurmctldHost=$node(127.0.0.1)
SlurmctldPort=$port
SlurmdPort=$((port + 1))
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$work/munge/socket
CredType=cred/munge
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
SlurmctldLogFile=$work/slurmctld.log
SlurmdLogFile=$work/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
ReturnToService=2
SwitchType=switch/none
NodeName=$node NodeAddr=127.0.0.1 CPUs=$(nproc) RealMemory=4000 State=UNKNOWN
PartitionName=all Nodes=$node Default=YES MaxTime=INFINITE State=UP
CONF
export SLURM_CONF=$work/slurm.conf
start_controller
slurmd -D -f "$SLURM_CONF" >"$work/slurmd.out" 2>&1 &
pids+=($!)
is_idle() { [[ $(sinfo --noheader --format=%t) == idle* ]]; }
await 60 is_idle
sinfo

echo "== through Slurm"
# The profile's times are for clusters; here nothing has to wait for a file system.
"$here/scripts/experiment.sh" "$grid" "$work/slurm" --latency-wait 5 >"$work/snakemake.log" 2>&1 &
experiment=$!
pids+=("$experiment")
some_trials() { (($(find "$work/slurm/results/trials" -name '*.json' | wc -l) >= 3)); }
await 300 some_trials
job=$(squeue --noheader --states=RUNNING --format=%A | head -n 1)
[[ -n $job ]] || fail "no job is running"
scancel --signal=KILL --full "$job"
echo "killed job $job"
was_killed() { ! squeue --noheader --states=RUNNING --jobs="$job" --format=%A | grep -q "$job"; }
await 60 was_killed
kill -KILL "$controller"
wait "$controller" 2>/dev/null || true
echo "killed the controller"
[[ $(scontrol ping || true) == *DOWN* ]] || fail "the controller is still there"
sleep 5
start_controller
# A controller that lost its last seconds may find a job running twice; then it drains the node and holds the job, until
# an administrator sets it right.
administrate()
{
  while sleep 5; do
    scontrol update nodename="$node" state=resume || true
    squeue --noheader --states=PENDING --format=%A | xargs --no-run-if-empty --max-args=1 scontrol release || true
  done >/dev/null 2>&1
}
administrate &
pids+=($!)
wait "$experiment" || fail "the experiment: $(tail -n 20 "$work/snakemake.log")"
grep -q "Error executing rule shard" "$work/snakemake.log" || fail "no job was seen to fail"
grep -q "Trying to restart job" "$work/snakemake.log" || fail "no job was started again"

echo "== locally"
"${EXPERIMENT_PROGRAM:-$here/build/bin/certificate_experiment}" "$grid" --out "$work/local" >"$work/local.log" 2>&1 ||
  fail "the local run: $(tail -n 20 "$work/local.log")"

echo "== compared"
"$here/demos/experiments/compare_trials.py" "$work/local" "$work/slurm/results" || fail "the results differ"
for file in report.html experiment.db tables/records.csv figures/figure6_RRT_checks.png; do
  [[ -s $work/slurm/$file ]] || fail "no $file"
done
echo "passed"
