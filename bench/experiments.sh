#!/bin/bash
# All tables and charts of docs/experiments.md; see --help.
set -euo pipefail
exec python3 "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/renew.py" "$@"
