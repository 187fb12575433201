#!/usr/bin/env bash
# Builds this repository and a package of ament's in one colcon workspace, and runs what comes out. Debian 12 has both tools;
# with a ROS 2 sourced, those of ROS are used.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source=$(cd "$here/../.." && pwd)
"$source/scripts/install_dependencies.sh" $([[ ${ROS_DISTRO:-} ]] || printf "%s " colcon python3-colcon-{bash,cmake,library-path,package-selection,recursive-crawl,ros} ament-cmake)

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/src"
ln -s "$source" "$work/src/ompl_certificates"
cp -r "$here/colcon" "$work/src/ament_consumer"
cp "$source/tests/consumer/main.cpp" "$work/src/ament_consumer/"
cd "$work"
colcon build --packages-up-to ament_consumer --cmake-args -G Ninja -DOMPL_CERTIFICATES_BUILD_TESTS=OFF \
  -DOMPL_CERTIFICATES_BUILD_DEMOS=OFF -DOMPL_CERTIFICATES_BUILD_BENCHMARKS=OFF -DPython3_EXECUTABLE=/usr/bin/python3
# shellcheck disable=SC1091
(set +u && . install/setup.bash && "install/ament_consumer/lib/ament_consumer/consumer")
