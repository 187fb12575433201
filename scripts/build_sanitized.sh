#!/usr/bin/env bash
# Builds with clang's sanitizers of addresses and undefined behaviour into build-sanitize/: the library, its tests and
# the fuzz targets, or the targets that are named as arguments.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# The second is Debian 12's, with libFuzzer and the sanitizers, which clang only recommends.
scripts/install_dependencies.sh clang libclang-rt-14-dev
# Optimized a little, since the tests are long, and with line numbers alone, since all that gdb could want makes
# compilers slow.
cmake -S . -B build-sanitize -G Ninja -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=Debug \
  -DCMAKE_CXX_FLAGS_DEBUG="-O1 -g1" -DOMPL_CERTIFICATES_SANITIZE=address,undefined \
  -DOMPL_CERTIFICATES_BUILD_FUZZERS=ON -DOMPL_CERTIFICATES_WERROR=ON -DOMPL_CERTIFICATES_BUILD_DEMOS=OFF \
  -DOMPL_CERTIFICATES_BUILD_BENCHMARKS=OFF
cmake --build build-sanitize ${1:+--target "$@"}
