#!/usr/bin/env bash
# Questions to a log, asked with jq (https://jqlang.org): a log is one JSON object a line.
#
#     bash docs/recipes/log-questions-jq.sh [SCENE [X0,Y0,X1,Y1]]
#
# Needs `raywalk` and `jq` on the path.
set -euo pipefail

scene=${1:-glass-and-mirror}
region=${2:-140,100,180,140}
log=$(mktemp)
trap 'rm -f "$log"' EXIT

raywalk trace "$scene" --region "$region" --output "$log"

echo "How many rays of each kind are there?"
jq -r '.enter.ray.kind // empty' "$log" | sort | uniq -c | sort -rn

echo
echo "Which objects are met first, and how often?"
jq -r '.mark.nearest.object // empty' "$log" | sort | uniq -c | sort -rn

echo
echo "What was left out, and why?"
jq -r '.mark.skipped // empty | "\(.what): \(.why)"' "$log" | sort | uniq -c | sort -rn

echo
echo "Where is light reflected totally? (pixels, and how often there)"
jq -r 'if .enter.pixel then "pixel \(.enter.pixel | join(","))" elif .mark.total_internal_reflection then "here" else empty end' "$log" |
    awk '$1 == "pixel" { pixel = $2 } $1 == "here" { count[pixel]++ } END { for (pixel in count) print pixel, count[pixel] }' | sort -t, -k2,2n -k1,1n | head

echo
echo "Which values of T_A, the nearest approach to a sphere, are the largest?"
jq -r 'select(.note == "sphere.t_a") | .value' "$log" | sort -g | tail -3

# The brightest pixel, and the call that shows why it is.
echo
echo "Which pixel is the brightest in red?"
jq -rn --slurpfile header <(head -1 "$log") '
    reduce (inputs | select(.enter.pixel or .result)) as $event ({};
        if $event.enter.pixel then .here = $event.enter.pixel
        elif $event.result.color[0] > (.most // -1) then .most = $event.result.color[0] | .pixel = .here else . end)
    | "\(.pixel | join(",")): \(.most)   raywalk walk \($header[0].scene.name) --pixel \(.pixel | join(","))"' "$log"

# As many pixels as the region has, and as many results.
pixels=$(jq -c 'select(.enter.pixel)' "$log" | wc -l)
results=$(jq -c 'select(.result)' "$log" | wc -l)
[ "$pixels" = "$results" ]
printf '\n%s pixels, each with its result\n' "$pixels"
