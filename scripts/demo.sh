#!/usr/bin/env bash
# Builds the demo, which takes some minutes the first time. Then plans for three teams with stock OMPL and FCL and with
# this library, in about a minute. Prints a table of what each took and whether the trees are equal. Pictures of the plans
# go to out/. Options go to the program; --help lists them.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

scripts/build.sh certificates
echo
exec build/bin/certificates compare "$@"
