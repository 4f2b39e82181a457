# Sourced by the tests of this folder: a bare Debian 12 in a folder of its own, made once and used by all of them.
# shellcheck shell=bash

skip() { echo "skipped: $*" >&2; exit 77; }

# bare_debian ROOT: makes it unless it is there. Takes the package mirror and any proxy from this machine's apt settings.
bare_debian() {
  local root=$1 mirror
  if [ -e "$root" ] && [ ! -e "$root/.made-by-installer-test" ]; then
    echo "$root exists and is not one of mine" >&2
    exit 2
  fi
  [ ! -x "$root/usr/bin/bash" ] || [ ! -e "$root/.complete" ] || return 0
  rm -rf --one-file-system "$root"
  # shellcheck disable=SC2016  # apt-get itself fills in what stands in $()
  mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' | grep -m 1 '/debian/*$' || true)
  mkdir -p "$root" && touch "$root/.made-by-installer-test"
  debootstrap --variant=minbase bookworm "$root" "${mirror:-http://deb.debian.org/debian}" >"$root.log" 2>&1 ||
    { tail -n 20 "$root.log" >&2; exit 1; }
  rm -f "$root.log" "$root/etc/apt/sources.list"
  cp -r /etc/apt/sources.list.d/debian.sources "$root/etc/apt/sources.list.d/" 2>/dev/null ||
    cp /etc/apt/sources.list "$root/etc/apt/sources.list"
  apt-config dump | grep -iE '^Acquire::(https?|ftp)::' >"$root/etc/apt/apt.conf.d/90host" || true
  printf '#!/bin/sh\nexit 101\n' >"$root/usr/sbin/policy-rc.d" && chmod +x "$root/usr/sbin/policy-rc.d"
  touch "$root/.complete"
}

# needs_root: runs this script once more in a mount namespace, whose mounts go away with it.
needs_root() {
  [ "$(id -u)" -eq 0 ] || skip "only root can make a system of its own"
  local tool
  for tool in debootstrap unshare chroot; do
    command -v "$tool" >/dev/null || skip "please install $tool"
  done
  [ "${BARE_DEBIAN_INSIDE:-}" = yes ] || BARE_DEBIAN_INSIDE=yes exec unshare --mount --pid --fork "$0" "$@"
}

# enter ROOT: what programs expect of a running system.
enter() {
  cp -L /etc/resolv.conf /etc/hosts "$1/etc/"
  mount --make-rprivate /
  mount -t proc proc "$1/proc"
  mount -t tmpfs -o mode=1777 tmpfs "$1/tmp"
  mount --rbind /dev "$1/dev"
}

# inside ROOT COMMAND...: with next to no environment.
inside() {
  local root=$1
  shift
  env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root TERM=dumb DEBIAN_FRONTEND=noninteractive \
    chroot "$root" "$@" </dev/null
}

# drives_the_demo ROOT PROGRAM: an ordinary user opens the demo floor without a display and drives the route to its end.
drives_the_demo() {
  local root=$1 program=$2 status=0
  inside "$root" sh -c 'id tester >/dev/null 2>&1 || useradd --create-home tester'
  inside "$root" su tester -c "rm -rf ~/.local ~/.config ~/out; cd ~ && QT_QPA_PLATFORM=offscreen timeout 300 \
    '$program' --demo --drive paper --speed 0.3 --until-finished --out out" || status=$?
  echo "$program --demo --drive paper --until-finished: exit code $status"
  [ $status -eq 0 ] || return 1
  inside "$root" sh -c 'ls -l /home/tester/out'
}
