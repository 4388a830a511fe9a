#!/usr/bin/env bash
# The pictures of docs/gallery.md that no test makes are what the program renders today.
set -euo pipefail
pictures=$(cd "$(dirname "$0")/../pictures" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

raywalk render table-top --size 560x420 --sampling adaptive:threshold=0.02,depth=4 -q -o "$folder/table-top.png"
raywalk render glass-and-mirror --size 480x360 --sampling adaptive:threshold=0.02,depth=3 -q -o "$folder/glass-and-mirror.png"
raywalk render glass-and-mirror --digits --size 200x150 -q -o "$folder/digits.png"
for name in table-top glass-and-mirror digits; do
    raywalk diff "$folder/$name.png" "$pictures/$name.png"
done
raywalk trace figure-6 --pixel 160,120 --format svg | cmp - "$pictures/ray-tree.svg"
raywalk trace total-reflection --pixel 100,110 --view vectors --path 'C T' | cmp - "$pictures/vectors.svg"
raywalk trace polished-surface --pixel 105,95 --view zones | cmp - "$pictures/zones.svg"
