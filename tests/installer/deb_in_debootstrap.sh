#!/bin/bash
# deb_in_debootstrap.sh PACKAGES SYSTEM: installs the Debian package with apt in a bare Debian 12, checks what it brought,
# drives the demo there, and removes it again.
set -euo pipefail
[ $# -eq 2 ] || { echo "usage: deb_in_debootstrap.sh PACKAGES SYSTEM" >&2; exit 2; }
# shellcheck source-path=SCRIPTDIR source=bare_debian.sh
. "$(dirname "$(readlink -f "$0")")/bare_debian.sh"
package=$(find "$1" -maxdepth 1 -name 'tessera_*.deb' 2>/dev/null | sort | tail -n 1) || true
[ -n "$package" ] || skip "there is no package in $1: run installer/build.sh deb"
if command -v lintian >/dev/null; then
  lintian --allow-root --fail-on error "$package"
fi
needs_root "$@"
# What apt installs stays in a copy, so that the other test finds a system without Qt.
system=$(readlink -m "$2")
bare_debian "$system"
installed=$system.installed
if [ ! -e "$installed/.complete" ]; then
  rm -rf --one-file-system "$installed"
  cp -a "$system" "$installed"
fi
enter "$installed"
cp "$package" "$installed/tmp/tessera.deb"
inside "$installed" apt-get -q update >"$installed/tmp/apt.log" 2>&1 || { tail "$installed/tmp/apt.log" >&2; exit 1; }
start=$SECONDS
inside "$installed" apt-get -q -y --no-install-recommends --reinstall install /tmp/tessera.deb \
  >"$installed/tmp/apt.log" 2>&1 || { tail -n 30 "$installed/tmp/apt.log" >&2; exit 1; }
echo "installed in $((SECONDS - start)) s: $(inside "$installed" dpkg-query -W | wc -l) packages"

for file in usr/share/applications/tessera.desktop usr/share/mime/packages/tessera.xml \
  usr/share/icons/hicolor/48x48/apps/tessera.png usr/share/man/man1/tessera.1.gz \
  usr/lib/udev/rules.d/70-tessera-serial.rules usr/share/tessera/sites/paper.tessera.json usr/share/tessera/firmware/tessera-vehicle.bin; do
  [ -s "$installed/$file" ] || { echo "$file is missing" >&2; exit 1; }
done
inside "$installed" tessera --version
inside "$installed" tessera-cli site check /usr/share/tessera/sites/paper.tessera.json
drives_the_demo "$installed" tessera
inside "$installed" apt-get -q -y remove tessera >"$installed/tmp/apt.log" 2>&1
[ ! -e "$installed/usr/bin/tessera" ] || { echo "the program is still there after its removal" >&2; exit 1; }
