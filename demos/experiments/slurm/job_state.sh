#!/usr/bin/env bash
# Tells Snakemake how a job of Slurm is: running, success or failed.
set -uo pipefail

if answer=$(scontrol --oneliner show job "$1" 2>&1); then
  state=$(grep -o 'JobState=[A-Z_]*' <<<"$answer" | head -n 1)
  case "${state#JobState=}" in
    COMPLETED) echo success ;;
    PENDING | CONFIGURING | RUNNING | COMPLETING | SUSPENDED | REQUEUED | RESIZING) echo running ;;
    *) echo failed ;;
  esac
elif [[ $answer == *"Invalid job id"* ]]; then
  # The controller has forgotten it; its accounting, where there is one, has not. What failed is run again and finds
  # the trials that are done.
  state=$(sacct --noheader --parsable2 --allocations --format=State --jobs "$1" 2>/dev/null | head -n 1)
  if [[ $state == COMPLETED ]]; then echo success; else echo failed; fi
else
  # The controller does not answer: it may come back.
  echo running
fi
