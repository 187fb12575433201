#!/usr/bin/env bash
# Installs the packages of a folder, by default out/packages/, into a new Debian and uses them there: the programs, the first
# example for Python, and a user's project. Needs root rights, mmdebstrap and Debian's mirror. Some 1.2 GB in /tmp, for minutes.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source=$(cd "$here/../.." && pwd)
packages=$(cd "${1:-$source/out/packages}" && pwd)
"$source/scripts/install_dependencies.sh" mmdebstrap

# What runs in the new root, one step after the other, so that no package finds what only another one asks for.
within=$(mktemp)
trap 'rm -f "$within"' EXIT
cat >"$within" <<'END'
set -eu
export DEBIAN_FRONTEND=noninteractive
install()
{
  echo "==== apt-get install $*"
  apt-get install -qq -y --no-install-recommends "$@" >/tmp/apt.log 2>&1 || { tail -n 20 /tmp/apt.log; exit 1; }
}
cd /test
install ./ompl-certificates-tools_*.deb ./libompl-certificates0*.deb
certificates --version
plan_team --version
certificates plan demos/scenes/paper_five_discs.yaml --planner RRTConnect --time 20 --path /tmp/path.csv --quiet
test -s /tmp/path.csv
test -s /usr/share/man/man1/certificates.1.gz
test -s /usr/share/man/man1/plan_team.1.gz

install ./python3-ompl-certificates_*.deb
python3 python/examples/01_plan.py

install cmake g++ make ./libompl-certificates-dev_*.deb
cmake -S tests/consumer -B /tmp/consumer "-DCOMPONENTS=neighbors;octomap;scene;pictures"
cmake --build /tmp/consumer
/tmp/consumer/consumer

apt-get purge -qq -y 'libompl-certificates*' >/dev/null
if find / -xdev -name '*ompl*certificates*' -not -path '/test/*' -not -path '/tmp/*' | grep .; then
  echo "error: these files stay behind" >&2
  exit 1
fi
END

mmdebstrap --quiet --mode=root --variant=apt --format=null \
  --customize-hook="mkdir \"\$1/test\"" \
  --customize-hook="cp '$packages'/*.deb \"\$1/test/\"; cp '$within' \"\$1/test/run\"" \
  --customize-hook="cd '$source' && cp -r --parents demos/scenes tests/consumer python/examples \"\$1/test/\"" \
  --customize-hook='chroot "$1" sh /test/run' \
  "$(. /etc/os-release && echo "$VERSION_CODENAME")" -
echo "The packages work in a new root."
