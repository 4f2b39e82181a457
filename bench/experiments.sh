#!/bin/bash
# The tables of docs/experiments.md; see --help.
set -euo pipefail

usage() {
  cat <<'TEXT'
usage: bench/experiments.sh FOLDER-OF-PROGRAMS [real|lockstep]

  real      firmware in QEMU, in real time: about a quarter of an hour
  lockstep  native vehicles in virtual time: about two minutes
Without a second word: both. Exit code 1 when runs did not finish, 2 for a wrong command line.
TEXT
}
case ${1:-} in
  -h | --help) usage; exit 0 ;;
esac
part=${2:-all}
case $#:$part in
  1:all | 2:real | 2:lockstep) ;;
  *) usage >&2; exit 2 ;;
esac
root=$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")
bin=$(readlink -f "$1")
[ -x "$bin/tessera-cli" ] || { printf 'experiments.sh: there is no tessera-cli in %s; ./dev build makes it\n' "$1" >&2; exit 2; }
failed=0
table() { python3 "$root/bench/experiments.py" --cli "$bin/tessera-cli" "$@" || failed=1; }
three() {
  table --site "$root/resources/sites/three.tessera.json" --drive 1=one --drive 2=two --drive 3=three --speeds 0.12 "$@"
}

if [ "$part" != lockstep ]; then
  printf '\n== Firmware in QEMU, through a pty, in real time\n'
  table --vehicle qemu --seeds 5 --jobs 2 --out "$root/out/experiments/qemu"
  printf '\n== Three vehicles on one channel, firmware in QEMU, through a pty, in real time\n'
  three --vehicle qemu --seeds 1 --jobs 1 --out "$root/out/experiments/three-qemu"
fi
if [ "$part" != real ]; then
  printf '\n== Native vehicles, virtual time\n'
  table --vehicle native --seeds 20 --out "$root/out/experiments/native" -- --lockstep
  printf '\n== The same, the air as its data sheet says (k = 1)\n'
  table --vehicle native --seeds 20 --out "$root/out/experiments/air-1" -- --lockstep --air-factor 1
  printf '\n== The same, the slowest air seen in the field (k = 3.2)\n'
  table --vehicle native --seeds 20 --out "$root/out/experiments/air-3.2" -- --lockstep --air-factor 3.2
  printf '\n== The same, air rate 2.4 kbit/s as modules are delivered\n'
  table --vehicle native --seeds 20 --out "$root/out/experiments/air-2400" -- --lockstep --air-rate 2400
  printf '\n== The same, one packet in five lost\n'
  table --vehicle native --seeds 20 --out "$root/out/experiments/loss" -- --lockstep --loss 0.2
  printf "\n== The publication's controller at 2.4 kbit/s: aims at the next control point, knows nothing of the delay\n"
  table --vehicle native --seeds 20 --baseline --out "$root/out/experiments/aimer" -- --lockstep --air-rate 2400 \
    --controller control-points --limit 600
  printf '\n== Regulated Pure Pursuit, tuned to L = 0.3 m, at 2.4 kbit/s\n'
  table --vehicle native --seeds 20 --baseline --out "$root/out/experiments/pursuit" -- --lockstep --air-rate 2400 \
    --controller regulated-pure-pursuit
  printf '\n== Controllers on a unicycle without radio\n'
  if [ -x "$bin/bench_drive" ]; then "$bin/bench_drive"; else printf 'bench_drive is not built here\n'; fi
  printf '\n== The locator of the publication, for comparison\n'
  table --vehicle native --seeds 20 --baseline --out "$root/out/experiments/tag-centre" -- --lockstep --estimator tag-centre
  limits() { title=$1 folder=$2; shift 2; printf '\n== %s\n' "$title"; table --vehicle native --seeds 20 --limits --out "$root/out/experiments/$folder" "$@"; }
  limits 'Limits: 12 cm/s, polls at 10 Hz, air at 19.2 kbit/s' limit-fast --speeds 0.12 -- --lockstep
  for air in '' '--air 2400 --air-factor 1' '--air 2400 --air-factor 1 --compass-spots 0'; do
    # shellcheck disable=SC2086  # the options are words of their own
    limits "A hundred seeds, ${air:-air at 19.2 kbit/s}" limit-hundred --speeds 0.12 --seeds 100 -- --lockstep $air
    python3 "$root/bench/split_errors.py" "$root/resources/sites/paper.tessera.json" "$root/out/experiments/limit-hundred" || failed=1
  done
  limits 'The same, compass noise 2 degrees, speed noise 5 %' limit-noise-5 --speeds 0.12 -- --lockstep --compass-noise 2 --speed-noise 0.05
  limits 'The same, speed noise 10 %' limit-noise-10 --speeds 0.12 -- --lockstep --compass-noise 2 --speed-noise 0.1
  limits 'The same, speed noise 10 % that is as good as white at 10 Hz' limit-noise-white --speeds 0.12 -- --lockstep \
    --compass-noise 2 --speed-noise 0.1 --speed-noise-time 0.05
  limits 'Polled every 0.2 s, air at 2.4 kbit/s, k = 1' limit-slow --speeds 0.12 -- --lockstep --air 2400 --air-factor 1 --poll 0.2
  limits 'The same, a fifth of the reads lost, 5 degrees of compass bias, slip' limit-rough --speeds 0.12 -- \
    --lockstep --air 2400 --air-factor 1 --poll 0.2 --detection 0.72 --compass-bias 5 --slip 0.1
  limits '50 cm/s' limit-quick --speeds 0.50 -- --lockstep
  for name in kalman tag-centre; do
    limits "The first of these with $name" "limit-$name" --speeds 0.12 --baseline -- --lockstep --estimator $name
  done
  limits 'Carried in the middle of the drive, a hundred seeds' limit-carried --speeds 0.12 --seeds 100 --baseline -- --lockstep --carry 20
  printf '\n== Floors and routes of many kinds\n'
  table --vehicle native --floors --speeds 0.12 --seeds 20 --baseline --out "$root/out/experiments/floors" -- --lockstep
  printf '\n== Three vehicles on one channel\n'
  three --vehicle native --seeds 5 --out "$root/out/experiments/three" -- --lockstep
fi
exit $failed
