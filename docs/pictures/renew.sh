#!/bin/bash
# Copies the pictures that the documents show from those that the tests took: build/pictures, after ./dev test.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")"
for view in start-en-light drive-en-light charts-en-dark events-zh-light route-zh-dark zones-en-light register-en-light wizard-0-en-light \
  help-zh-light; do
  cp "../../build/pictures/1x/$view.png" .
done
