#!/bin/bash
# tar_in_chroot.sh PACKAGES SYSTEM: unpacks the relocatable archive in a Debian 12 without Qt and drives the demo there.
set -euo pipefail
[ $# -eq 2 ] || { echo "usage: tar_in_chroot.sh PACKAGES SYSTEM" >&2; exit 2; }
# shellcheck source-path=SCRIPTDIR source=bare_debian.sh
. "$(dirname "$(readlink -f "$0")")/bare_debian.sh"
archive=$(find "$1" -maxdepth 1 -name 'tessera-*-linux-*.tar.xz' 2>/dev/null | sort | tail -n 1) || true  # no folder: no archive
[ -n "$archive" ] || skip "there is no archive in $1: run installer/build.sh tar"
needs_root "$@"
system=$(readlink -m "$2")
bare_debian "$system"
enter "$system"
if inside "$system" sh -c 'ls /usr/lib/*/libQt6Core.so* 2>/dev/null'; then
  skip "$system has Qt from an earlier test; remove it to try the archive"
fi
# A place with a blank in its name, as people have them.
place="$system/opt/some place"
rm -rf "$place"
mkdir -p "$place"
tar -C "$place" -xf "$archive"
folder=$(basename "$archive" .tar.xz)
inside "$system" "/opt/some place/$folder/bin/tessera" --version
inside "$system" "/opt/some place/$folder/bin/tessera-cli" site check "/opt/some place/$folder/share/tessera/sites/paper.tessera.json"
[ -s "$place/$folder/share/tessera/firmware/tessera-vehicle.bin" ] || { echo "the vehicle's firmware is missing" >&2; exit 1; }
drives_the_demo "$system" "/opt/some place/$folder/bin/tessera"
rm -rf "$place"
