#!/usr/bin/env bash
# Builds the Python module into build/python/ and tests it: pytest, mypy, the examples and the notebook, and flake8, since
# Debian has no ruff. Where a ruff is installed, it looks, too.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

scripts/install_dependencies.sh --python python3-pytest mypy flake8 python3-matplotlib \
  jupyter-nbconvert python3-ipykernel
python=/usr/bin/python3
cmake -S . -B build -G Ninja -DOMPL_CERTIFICATES_WERROR=ON -DOMPL_CERTIFICATES_BUILD_PYTHON=ON \
  -DPython_EXECUTABLE="$python"
cmake --build build --target ompl_certificates_python

export PYTHONPATH="$PWD/build/python"
"$python" -m flake8 --max-line-length 120 python setup.py scripts/python_stub.py
if command -v ruff >/dev/null; then
  ruff check python setup.py scripts/python_stub.py
fi
"$python" -m mypy
"$python" -m pytest -q
mkdir -p out
for example in python/examples/[0-9]*.py; do
  echo "== $example"
  "$python" "$example"
done
"$python" -m nbconvert --to html --execute --ExecutePreprocessor.timeout=120 --ExecutePreprocessor.kernel_name=python3 \
  --output-dir out python/examples/05_pictures.ipynb
