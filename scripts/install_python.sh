#!/usr/bin/env bash
# Installs what the Python module needs and this machine lacks, and the module itself into a virtual environment:
# out/python, or the folder that is named as the first argument. On Debian 12 and Ubuntu 22.04 or 24.04; no package index is needed.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

folder=${1:-out/python}
scripts/install_dependencies.sh --python
# These systems keep their own Python for their packages, so ours gets an environment that sees them.
/usr/bin/python3 -m venv --system-site-packages "$folder"
"$folder/bin/pip" install --no-build-isolation --no-index .
"$folder/bin/python" -c 'import ompl_certificates; print("ompl_certificates", ompl_certificates.__version__)'
