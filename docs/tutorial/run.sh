#!/usr/bin/env bash
# Runs the commands of docs/tutorial.md and looks for what it says in their output. It needs `raywalk` on the path.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cp "$here"/*.json "$folder"
cd "$folder"

# says FILE TEXT: that a line of the file holds this text.
says() { grep -qF -- "$2" "$1" || { printf 'tutorial: %s lacks: %s\n' "$1" "$2" >&2; exit 1; }; }
# ends_with CODE COMMAND…: that the command ends with this exit code.
ends_with() {
    local expected=$1 code=0
    shift
    "$@" || code=$?
    [ "$code" = "$expected" ] || { printf 'tutorial: %s ended with %s, not %s\n' "$*" "$code" "$expected" >&2; exit 1; }
}

# 1 The numeric example
raywalk > example.txt
says example.txt 'V_d = N_p · d = (1, 0, 0)·(-0.946, 0.315, 0.0788) = -0.946   [plane.v_d 1.3 (2)]'
says example.txt 'result: (393.054, 311.666, 370.310)'

raywalk render textbook -o textbook.png --exposure -1.2 2> said.txt
[ ! -s said.txt ]
raywalk render textbook -o clipped.png 2> said.txt
says said.txt 'warning: 97 % of the pixels (75357 of 77361) were brighter than white and clipped; --exposure -1.2 shows all'

# 2 By hand
raywalk trace textbook --pixel 160,120 --arithmetic decimal:3 -o hand.ndjson
raywalk trace textbook --pixel 160,120 -o f64.ndjson
raywalk trace hand.ndjson --format text > hand.txt
says hand.txt 'T2_A = r² − L2oc + T_A² = 9 − 178.024 + 13.244² = 6.380   [sphere.t2_a 1.3 (5d)]'
says hand.txt 'result: (394.134, 312.306, 370.850)'
raywalk textbook > textbook.txt
says textbook.txt 'I_global (red) 394.024.'
says textbook.txt 'I_global (red)   394.028                   394.028                   394.134                   393.054'

walk_by_hand() { raywalk walk --arithmetic decimal:3 --screen 140,40 --screenshot "$1" --keys "/sphere.t2_a<Enter> ; ; $2"; }
walk_by_hand found.svg ''
says found.svg 'match 3/3'
walk_by_hand operands.svg 'd'
says operands.svg 'What T2_A is made of'
walk_by_hand arithmetics.svg 'a'
says arithmetics.svg '13.24025482481689'

# 3 As a worked solution
raywalk trace hand.ndjson --format html -o solution.html
raywalk trace hand.ndjson --format markdown -o solution.md
raywalk trace hand.ndjson --format markdown --lang es -o solution-es.md
says solution.md '# Worked solution: pixel 160,120 of textbook'
says solution-es.md '394,134'

# 4 Where the two part
ends_with 1 raywalk diff hand.ndjson f64.ndjson --digits 3 > parted.txt
says parted.txt 'First divergence in C, test plane: plane.t'
says parted.txt 'traced back: plane.t ← plane.v_d ← ray.direction (its own rounding)'
raywalk trace textbook --pixel 160,120 --arithmetic decimal:3 --causes > causes.txt
says causes.txt 'off by       (+1.080, +0.640, +0.540)'
says causes.txt '(+0.243, +0.152, +0.140)'

# 5 A scene of one's own
raywalk scene check ball.json > check.txt 2> warnings.txt
says check.txt 'ball: ok, 2 objects, 1 light, 2 materials'
says warnings.txt 'lights[0]: is outside the field of view, which it lights all the same'
sed 's/"center"/"centre"/; s/"radius": 1}/"radius": -1}/' ball.json > typos.json
ends_with 2 raywalk scene check typos.json 2> typos.txt
says typos.txt 'objects[1].shape.sphere.centre: unknown key `centre`, did you mean `center`?'
says typos.txt 'objects[1].shape.sphere.radius: must be positive, found -1'
for scene in ball wrong-bubble bubble; do
    raywalk render $scene.json --size 320x240 --sampling regular:2 -q -o $scene.png
    ends_with 0 raywalk diff $scene.png "$here/$scene.png" > /dev/null
done

# 6 Something is wrong
raywalk scene check wrong-bubble.json > check.txt 2> warnings.txt
says warnings.txt 'wrong-bubble.json:14:20: materials.air.ior: should be the index of the medium itself, 1 or more'
says check.txt 'wrong-bubble: ok, 4 objects, 1 light, 4 materials'
raywalk trace wrong-bubble.json --pixel 93,40 -o wrong.ndjson
raywalk trace wrong.ndjson --format text > wrong.txt
says wrong.txt 'given η_1 = 1.500, η_2 = 0.667'
says wrong.txt 'η = η_2/η_1 = 0.667/1.500 = 0.445   [refract.eta 1.2.1]'
says wrong.txt '→ total internal reflection'
says wrong.txt 'result: (0.0905, 0.109, 0.145)'
walk_wrong() { raywalk walk wrong-bubble.json --pixel 93,40 --screen 140,40 --screenshot "$1" --keys "$2"; }
walk_wrong why.svg 'w'
says why.svg 'C T  total internal reflection'
walk_wrong there.svg 'w G <Enter>'
says there.svg 'cosφ_1'
walk_wrong stopped.svg 'b total-internal-reflection<Enter> r r'
says stopped.svg 'stopped by total-internal-reflection'
walk_wrong moved.svg 'Shift-Tab l'
says moved.svg 'pixel 94,40'

# 7 Mended
[ "$(diff wrong-bubble.json bubble.json | grep -c '^>')" = 1 ]
raywalk trace bubble.json --pixel 93,40 -o pinned.ndjson
ends_with 1 raywalk diff wrong.ndjson pinned.ndjson --digits 3 > mended.txt
says mended.txt 'First divergence in C T R R: refract.eta_2'
says mended.txt 'η_2: 0.667 against 1: an input'
says mended.txt '(0.0905, 0.109, 0.145)'
says mended.txt '(0.419, 0.502, 0.670)'

# 8 Pinned
raywalk trace bubble.json --pixel 93,40 > again.ndjson
ends_with 0 raywalk diff pinned.ndjson again.ndjson > same.txt
says same.txt 'The same: 785 values compared, none differs'

# 9 Deep enough?
raywalk trace bubble.json --pixel 93,40 --format text > deep.txt
[ "$(grep -c 'depth limit' deep.txt)" = 10 ]
raywalk render bubble.json -q -o four.png
raywalk render bubble.json --max-depth 8 -q -o eight.png
ends_with 1 raywalk diff four.png eight.png > depth.txt
says depth.txt 'pixels that differ   2985 of 19200 (15.5%)'

echo "the tutorial holds"
