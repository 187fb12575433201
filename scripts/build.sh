#!/usr/bin/env bash
# Installs what is missing and builds into build/: everything, or the targets that are named as arguments.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

scripts/install_dependencies.sh
cmake -S . -B build -G Ninja -DOMPL_CERTIFICATES_WERROR=ON
cmake --build build ${1:+--target "$@"}
