#!/usr/bin/env bash
# Builds everything and runs all tests. Arguments go to ctest, such as -R geometry.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

scripts/build.sh
ctest --test-dir build --output-on-failure --no-tests=error -j2 "$@"
