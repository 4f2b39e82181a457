#!/bin/bash
# relocatable.sh BUILD PACKAGES: a folder that runs from anywhere on machines without Qt, as one tar.xz. All libraries
# come along except those of the C library, which must be the machine's own; Debian 12's is 2.36.
set -euo pipefail
[ $# -eq 2 ] || { echo "usage: relocatable.sh BUILD PACKAGES" >&2; exit 2; }
build=$1
packages=$2
version=$(sed -n 's/^CMAKE_PROJECT_VERSION:STATIC=//p' "$build/CMakeCache.txt")
name=tessera-$version-linux-$(uname -m)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
root=$work/$name

cmake --install "$build" --prefix "$root" --strip >/dev/null
# What belongs to an installation by the system's packages only.
rm -rf "$root/lib/udev" "$root/share/man"

# Qt looks for plugins and translations where qt.conf beside the program says.
plugins=$(qtpaths6 --query QT_INSTALL_PLUGINS 2>/dev/null || echo "/usr/lib/$(uname -m)-linux-gnu/qt6/plugins")
translations=$(qtpaths6 --query QT_INSTALL_TRANSLATIONS 2>/dev/null || echo /usr/share/qt6/translations)
printf '[Paths]\nPrefix=..\nPlugins=plugins\nLibraries=lib\nTranslations=translations\n' >"$root/bin/qt.conf"
for plugin in platforms/libqxcb platforms/libqoffscreen platforms/libqminimal sqldrivers/libqsqlite \
  iconengines/libqsvgicon imageformats/libqsvg imageformats/libqico \
  platforminputcontexts/libibusplatforminputcontextplugin platforminputcontexts/libcomposeplatforminputcontextplugin; do
  install -D -m 644 "$plugins/$plugin.so" "$root/plugins/$plugin.so"
done
# Where it is installed: windows that draw themselves on Wayland. Without it they appear through XWayland.
for plugin in platforms/libqwayland-generic wayland-shell-integration/libxdg-shell \
  wayland-decoration-client/libbradient; do
  [ ! -f "$plugins/$plugin.so" ] || install -D -m 644 "$plugins/$plugin.so" "$root/plugins/$plugin.so"
done
install -D -m 644 -t "$root/translations" "$translations"/qtbase_zh_CN.qm

# Libraries: all that programs and plugins lead to.
mkdir -p "$root/lib" "$root/share/doc/tessera/libraries"
mapfile -t objects < <(find "$root/bin" "$root/plugins" -type f ! -name qt.conf)
mapfile -t libraries < <(ldd "${objects[@]}" | sed -n 's/.* => \(\/[^ ]*\) .*/\1/p' | sort -u |
  grep -vE '/(ld-linux[^/]*|lib(c|m|dl|rt|pthread|resolv|util|nsl|anl|BrokenLocale))\.so\.[0-9]+$')
if ldd "${objects[@]}" | grep 'not found'; then
  echo "relocatable.sh: the libraries above are missing on this machine" >&2
  exit 1
fi
for library in "${libraries[@]}"; do
  install -m 644 "$library" "$root/lib/$(basename "$library")"
  # Their licences come along.
  # (dpkg knows some files by the path that they had before /lib became a link to /usr/lib.)
  file=$(readlink -f "$library")
  package=$({ dpkg -S "$file" || dpkg -S "${file#/usr}"; } 2>/dev/null | head -n 1 | cut -d: -f1) || true
  if [ -n "$package" ]; then
    cp -L "/usr/share/doc/$package/copyright" "$root/share/doc/tessera/libraries/$package"
  else
    echo "relocatable.sh: no package owns $library; its licence is not included" >&2
  fi
done
strip --strip-unneeded "$root"/lib/*.so* 2>/dev/null || true

# Each finds the others from where it lies itself.
for object in "$root"/bin/*; do
  [ "${object##*/}" = qt.conf ] || patchelf --set-rpath "\$ORIGIN/../lib" "$object"
done
for object in "$root"/lib/*; do patchelf --set-rpath "\$ORIGIN" "$object"; done
find "$root/plugins" -name '*.so' -exec patchelf --set-rpath "\$ORIGIN/../../lib" {} +

cat >"$root/README.txt" <<TEXT
Tessera $version for Linux on $(uname -m), with all libraries that it needs beside those of the C library (2.36 or newer).

Start bin/tessera. It needs no installation; the folder may lie anywhere. Chinese needs a font with Chinese letters
(for example fonts-noto-cjk), which desktops set to Chinese have.
For USB serial adapters your account must be allowed to use them; on Debian and Ubuntu: sudo adduser \$USER dialout

The programs are under the GNU General Public License, version 3 or later; share/doc/tessera holds the licences of
all parts.
TEXT

mkdir -p "$packages"
tar -C "$work" --sort=name --owner=0 --group=0 --numeric-owner --mtime="@${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct)}" \
  -cf - "$name" | xz -6 -T0 >"$packages/$name.tar.xz.part"
mv "$packages/$name.tar.xz.part" "$packages/$name.tar.xz"
