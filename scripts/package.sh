#!/usr/bin/env bash
# Makes Debian packages in out/packages/: package.sh [--test]. --test also installs them into a new Debian root, made by
# mmdebstrap, and there builds and runs a user's program (tests/package/); it needs root rights, as apt does.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

scripts/install_dependencies.sh --python dpkg-dev fakeroot file help2man lintian
rm -rf out/packages
mkdir -p out/packages
cmake -S . -B build-package -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX=/usr -DCMAKE_SKIP_INSTALL_RPATH=ON \
  -DCMAKE_INSTALL_DOCDIR=share/doc/libompl-certificates-dev -DOMPL_CERTIFICATES_PYTHON_DIR=lib/python3/dist-packages \
  -DOMPL_CERTIFICATES_DEBIAN=ON -DOMPL_CERTIFICATES_WERROR=ON -DOMPL_CERTIFICATES_BUILD_PYTHON=ON \
  -DPython_EXECUTABLE=/usr/bin/python3 -DOMPL_CERTIFICATES_BUILD_TESTS=OFF -DOMPL_CERTIFICATES_BUILD_BENCHMARKS=OFF
cmake --build build-package
(cd build-package && cpack -B "$PWD/../out/packages" >/dev/null)
rm -rf out/packages/_CPack_Packages
ls out/packages
# CPack writes the scripts that call ldconfig; no bug of Debian's asks for these packages.
lintian --allow-root --fail-on error,warning \
  --suppress-tags maintscript-calls-ldconfig,initial-upload-closes-no-bugs out/packages/*.deb

if [[ ${1:-} == --test ]]; then
  tests/package/run.sh out/packages
fi
