#!/usr/bin/env bash
# A picture in shards on all cores of a machine, or of several, by GNU parallel (https://www.gnu.org/software/parallel).
#
#     bash docs/scale/parallel.sh [SCENE [SHARDS]]
#
# Needs `raywalk` and `parallel` on the path. For other machines give parallel their names (--sshlogin) and a folder that all of them
# share. One shard is ended in the middle of its work, to show what happens then.
set -euo pipefail

scene=${1:-figure-6}
shards=${2:-4}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export scene shards folder

render() {
    local part=$folder/$1.part
    set -- raywalk render "$scene" --size 240x180 --sampling sobol:8 --threads 1 --quiet --resume --shard "$1/$shards" -o "$part"
    if [ "$part" = "$folder/2.part" ] && [ ! -e "$folder/was-killed" ]; then
        # A machine that dies, once.
        touch "$folder/was-killed"
        "$@" &
        until [ -e "$part.checkpoint" ] || [ -e "$part" ]; do sleep 0.01; done
        kill -KILL $! && wait $!
    else
        "$@"
    fi
}
export -f render

# A shard that fails doesn't stop the others.
parallel --no-notice --joblog "$folder/jobs" render ::: $(seq "$shards") || echo "parallel: $? failed"
cut -f 1,4,7,8,9 "$folder/jobs"

# Those that failed are begun again, and go on from their checkpoints (--resume). What is whole isn't rendered again in any case.
parallel --no-notice --joblog "$folder/jobs" --resume-failed render ::: $(seq "$shards")

raywalk merge "$folder"/*.part -o "$folder/merged.png"
raywalk render "$scene" --size 240x180 --sampling sobol:8 --quiet -o "$folder/whole.png"
cmp "$folder/merged.png" "$folder/whole.png"
ls "$folder"/*.checkpoint 2>/dev/null && exit 1
echo "$shards shards make the picture of one run, byte for byte"
