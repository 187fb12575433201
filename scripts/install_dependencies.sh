#!/usr/bin/env bash
# Installs what the build, the tests and the demos need and this machine lacks, on Debian 12 and Ubuntu 22.04 or 24.04.
# Further packages can be named as arguments; --experiments stands for those of docs/experiments.md, --cluster for those
# that its test with Slurm needs, and --python for those of the Python module. Does nothing, and needs no network, when
# everything is there.
set -euo pipefail

packages=(
  ccache cmake g++ ninja-build python3
  libompl-dev libfcl-dev libccd-dev libeigen3-dev libqhull-dev
  # The last two are named by the CMake package of libompl-dev, which does not depend on them.
  libboost-dev libboost-serialization-dev libboost-filesystem-dev libboost-system-dev
  libyaml-cpp-dev libpugixml-dev libpng-dev liburdfdom-dev liboctomap-dev nlohmann-json3-dev libcli11-dev
  libgtest-dev libbenchmark-dev libnanoflann-dev
)

for argument in "$@"; do
  case $argument in
    --experiments) packages+=(python3-pandas python3-matplotlib python3-yaml snakemake ompl-demos) ;;
    --python)
      packages+=(python3-dev python3-venv python3-pip python3-setuptools python3-wheel python3-numpy pybind11-dev)
      ;;
    --cluster) packages+=(munge slurmctld slurmd slurm-client) ;;
    *) packages+=("$argument") ;;
  esac
done

if ! command -v apt-get >/dev/null; then
  echo "No apt-get here: install the equivalents of ${packages[*]}" >&2
  exit 0
fi

missing=()
for package in "${packages[@]}"; do
  if [[ $(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null) != installed ]]; then
    missing+=("$package")
  fi
done
if ((${#missing[@]} == 0)); then
  echo "All dependencies are installed."
  exit 0
fi

echo "Installing ${missing[*]}"
as_root=()
if ((EUID != 0)); then
  as_root=(sudo)
fi
"${as_root[@]}" apt-get update -qq
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "${missing[@]}"
