#!/bin/bash
# Takes the pictures that the documents show: runs the tests that take one of every view, and keeps those named below, with
# at most 256 colours each where pngquant is installed. usage: renew.sh [BUILD-FOLDER], default build
set -euo pipefail
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
build=$(readlink -f "${1:-$here/../../build}")

# At 100 % and at 200 %.
once=(start-en-light start-zh-dark drive-en-light three-en-light charts-en-dark events-zh-light journal-en-light route-zh-dark
  route-fault-en-light zones-en-light empty-en-light empty-lay-zh-light layTiles-en-light tile-types-en-light import-zh-light
  register-en-light find-en-dark length-en-light revisions-en-light tilecheck-marks-en-light locating-live-en-light
  calibrate-live-zh-light wizard-0-en-light radio-en-light site-zh-light help-zh-light chosen-tiles-en-light map-picture-en-light
  plan-en-light steps-en-light compass-live-en-light iron-en-light)
twice=(drive-zh-dark zones-en-light wizard-2-zh-light)

for scale in 1 2; do
  env QT_SCALE_FACTOR=$scale QT_QPA_PLATFORM=offscreen TESSERA_PICTURES="$build/pictures/${scale}x" \
    "$build/tests/desktop_pictures" --gtest_brief=1
done
for view in "${once[@]}"; do cp "$build/pictures/1x/$view.png" "$here/"; done
for view in "${twice[@]}"; do cp "$build/pictures/2x/$view.png" "$here/$view-200.png"; done
if command -v pngquant >/dev/null; then
  for view in "${once[@]}" "${twice[@]/%/-200}"; do
    # Code 98: the result would be larger, 99: not good enough; then the picture stays as it is.
    pngquant --force --skip-if-larger --quality 80-100 --speed 1 --ext .png "$here/$view.png" || [ $? -ge 98 ]
  done
fi
