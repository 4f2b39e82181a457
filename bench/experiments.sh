#!/bin/bash
# The tables of docs/experiments.md. usage: bench/experiments.sh FOLDER-OF-PROGRAMS [real|lockstep]
# real: firmware in QEMU, in real time (about eight minutes); lockstep: native vehicles, virtual time (a minute).
set -euo pipefail
root=$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")
bin=$(readlink -f "${1:?usage: bench/experiments.sh FOLDER-OF-PROGRAMS [real|lockstep]}")
part=${2:-all}
table() { python3 "$root/bench/experiments.py" --cli "$bin/tessera-cli" "$@"; }

if [ "$part" != lockstep ]; then
  printf '\n== Firmware in QEMU, through a pty, in real time\n'
  table --vehicle qemu --seeds 5 --jobs 3 --out "$root/out/experiments/qemu"
fi
if [ "$part" != real ]; then
  printf '\n== Native vehicles, virtual time\n'
  table --vehicle native --seeds 20 --jobs 2 --out "$root/out/experiments/native" -- --lockstep
  printf '\n== The same, the air as its data sheet says (k = 1)\n'
  table --vehicle native --seeds 20 --jobs 2 --out "$root/out/experiments/air-1" -- --lockstep --air-factor 1
  printf '\n== The same, the slowest air seen in the field (k = 3.2)\n'
  table --vehicle native --seeds 20 --jobs 2 --out "$root/out/experiments/air-3.2" -- --lockstep --air-factor 3.2
  printf '\n== The same, air rate 2.4 kbit/s as modules are delivered\n'
  table --vehicle native --seeds 20 --jobs 2 --out "$root/out/experiments/air-2400" -- --lockstep --air-rate 2400
  printf '\n== The same, one packet in five lost\n'
  table --vehicle native --seeds 20 --jobs 2 --out "$root/out/experiments/loss" -- --lockstep --loss 0.2
  printf "\n== The publication's controller at 2.4 kbit/s: aims at the next control point, knows nothing of the delay\n"
  table --vehicle native --seeds 20 --jobs 2 --out "$root/out/experiments/aimer" -- --lockstep --air-rate 2400 \
    --controller control-points --limit 600
  printf '\n== The locator of the publication, for comparison\n'
  table --vehicle native --seeds 20 --jobs 2 --out "$root/out/experiments/tag-centre" -- --lockstep --estimator tag-centre
fi
