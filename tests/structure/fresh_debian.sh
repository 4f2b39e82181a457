#!/bin/bash
# Tries the promise of the README: on a fresh Debian 12 a clone needs './dev run' and './dev test' and nothing before.
# Makes a bare system with debootstrap, clones the committed state into it and runs there, as root and without sudo, with
# next to no environment. Takes the package mirror and any proxy from this machine's apt settings.
set -euo pipefail

usage() {
  cat <<'TEXT'
usage: fresh_debian.sh [--keep] FOLDER [COMMAND...]

Runs each COMMAND (default: './dev run' and './dev test') in a fresh bookworm made in FOLDER, which must not exist yet and
is removed at the end unless --keep is given. In a FOLDER kept from an earlier run the commands run on a new clone. Needs root, debootstrap, git and about 3 GB.
TEXT
}

keep=0
[ "${1:-}" = --keep ] && { keep=1; shift; }
case ${1:---help} in -h | --help) usage; exit 0 ;; esac
root=$(readlink -m "$1")
shift
commands=("$@")
[ ${#commands[@]} -gt 0 ] || commands=("./dev run" "./dev test")
repository=$(cd "$(dirname "$0")/../.." && pwd)

[ "$(id -u)" -eq 0 ] || { echo "fresh_debian.sh: only root can make a system of its own" >&2; exit 3; }
for tool in debootstrap git unshare; do
  command -v "$tool" >/dev/null || { echo "fresh_debian.sh: please install $tool" >&2; exit 3; }
done

# Only folders that this script made are used again, and removed.
if [ -e "$root" ] && [ ! -e "$root/.made-by-fresh-debian" ]; then
  echo "fresh_debian.sh: $root exists and is not one of mine" >&2
  exit 2
fi

# All mounts live in a namespace of their own and go away with it.
if [ "${FRESH_DEBIAN_INSIDE:-}" != yes ]; then
  status=0
  command=("$(readlink -f "$0")" "$root" "${commands[@]}")
  FRESH_DEBIAN_INSIDE=yes unshare --mount --pid --fork "${command[@]}" || status=$?
  [ $keep -eq 1 ] || rm -rf --one-file-system "$root"
  exit $status
fi

if [ ! -x "$root/bin/bash" ]; then
  # shellcheck disable=SC2016  # apt-get itself fills in what stands in $()
  mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' | grep -m 1 '/debian/*$' || true)
  start=$SECONDS
  mkdir -p "$root" && touch "$root/.made-by-fresh-debian"
  debootstrap --variant=minbase bookworm "$root" "${mirror:-http://deb.debian.org/debian}" >"$root.debootstrap.log" 2>&1 ||
    { tail -n 20 "$root.debootstrap.log" >&2; exit 1; }
  rm -f "$root.debootstrap.log"
  rm -f "$root/etc/apt/sources.list"
  cp -r /etc/apt/sources.list.d/debian.sources "$root/etc/apt/sources.list.d/" 2>/dev/null ||
    cp /etc/apt/sources.list "$root/etc/apt/sources.list"
  apt-config dump | grep -iE '^Acquire::(https?|ftp)::' >"$root/etc/apt/apt.conf.d/90host" || true
  printf '#!/bin/sh\nexit 101\n' >"$root/usr/sbin/policy-rc.d" && chmod +x "$root/usr/sbin/policy-rc.d"
  echo "made a bare Debian 12 in $((SECONDS - start)) s: $(chroot "$root" dpkg-query -W | wc -l) packages"
fi
cp -L /etc/resolv.conf /etc/hosts "$root/etc/"
mount --make-rprivate /
mount -t proc proc "$root/proc"
mount -t tmpfs -o mode=1777 tmpfs "$root/tmp"
mount --rbind /dev "$root/dev"

rm -rf "$root/root/tessera"
git -c safe.directory='*' clone --quiet "file://$repository" "$root/root/tessera"
status=0
for command in "${commands[@]}"; do
  echo "== $command"
  start=$SECONDS
  # shellcheck disable=SC2086  # a command line, to be split
  env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root TERM=dumb \
    chroot "$root" /bin/bash -c "cd /root/tessera && exec $command" </dev/null || status=$?
  echo "== $command: exit code $status after $((SECONDS - start)) s"
  [ $status -eq 0 ] || break
done
exit $status
