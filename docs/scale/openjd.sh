#!/usr/bin/env bash
# Runs shards.openjd.yaml on this machine by the command of Open Job Description (`pip install openjd-cli`), and compares.
#
#     bash docs/scale/openjd.sh [SCENE]
#
# Needs `raywalk` and `openjd` on the path.
set -euo pipefail

scene=${1:-figure-6}
job=$(dirname "$0")/shards.openjd.yaml
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

openjd check "$job"
openjd run "$job" --step Merge --run-dependencies \
    --job-param "Scene=$scene" --job-param "Size=160x120" --job-param "Shards=3" --job-param "Folder=$folder" >"$folder/log" || {
    cat "$folder/log"
    exit 1
}
grep -i 'session ended\|status\|success' "$folder/log" | tail -3 || true
raywalk render "$scene" --size 160x120 --quiet -o "$folder/whole.png"
cmp "$folder/picture.png" "$folder/whole.png"
echo "the job's picture is that of one run, byte for byte"
