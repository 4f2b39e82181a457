#!/bin/bash
# Makes the packages from a release build; see --help.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.."

usage() {
  cat <<'TEXT'
usage: installer/build.sh [--build FOLDER] [deb] [tar]

Builds the programs for release in build/package (or FOLDER) and puts into build/packages
  deb  tessera_VERSION-1_amd64.deb, for Debian 12
  tar  tessera-VERSION-linux-x86_64.tar.xz, with Qt's libraries beside the programs, for machines without Qt
Without a word: both. Needs what './dev build' needs, and dpkg-dev, patchelf and xz-utils.
Exit code 1 when something failed, 2 for a wrong command line, 3 when a tool is missing.
TEXT
}

build=build/package
kinds=()
while [ $# -gt 0 ]; do
  case $1 in
    -h | --help) usage; exit 0 ;;
    --build) [ $# -ge 2 ] || { usage >&2; exit 2; }; build=$2; shift ;;
    deb | tar) kinds+=("$1") ;;
    *) usage >&2; exit 2 ;;
  esac
  shift
done
[ ${#kinds[@]} -gt 0 ] || kinds=(deb tar)

lacking=()
command -v cmake >/dev/null || lacking+=(cmake)
command -v dpkg-shlibdeps >/dev/null || lacking+=(dpkg-dev)
command -v arm-none-eabi-g++ >/dev/null || lacking+=(gcc-arm-none-eabi libnewlib-arm-none-eabi libstdc++-arm-none-eabi-newlib)
command -v patchelf >/dev/null || lacking+=(patchelf)
command -v xz >/dev/null || lacking+=(xz-utils)
[ ${#lacking[@]} -eq 0 ] || { echo "installer/build.sh: please install: ${lacking[*]}" >&2; exit 3; }

export CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1 LC_ALL=C.UTF-8
# Permissions in the packages come from the files here.
umask 022
packages=$PWD/build/packages
mkdir -p "$packages"
# Without the dependency cpack would first build everything; what is packed is built below.
[ -f "$build/CMakeCache.txt" ] ||
  cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_UNITY_BUILD=ON -DBUILD_TESTING=OFF \
    -DTESSERA_ARM_FIRMWARE=ON -DCMAKE_SKIP_INSTALL_ALL_DEPENDENCY=ON
nice cmake --build "$build" -j "${TESSERA_JOBS:-$(nproc)}" \
  --target tessera tessera-cli tessera-world tessera_arm_firmware tessera_installed_files

for kind in "${kinds[@]}"; do
  case $kind in
    deb) (cd "$build" && cpack -G DEB -B "$packages" && rm -rf "$packages/_CPack_Packages") ;;
    tar) installer/relocatable.sh "$build" "$packages" ;;
  esac
done
echo "packages are in build/packages:"
find "$packages" -maxdepth 1 -type f \( -name '*.deb' -o -name '*.tar.xz' \) -printf '  %f  %s bytes\n' | sort
