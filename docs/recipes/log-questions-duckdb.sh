#!/usr/bin/env bash
# Questions to the log of a whole region, asked in SQL with DuckDB (https://duckdb.org).
#
#     bash docs/recipes/log-questions-duckdb.sh [SCENE [X0,Y0,X1,Y1]]
#
# Needs `raywalk` and `duckdb` on the path. The last part checks the counts with those of a rendering.
set -euo pipefail

scene=${1:-total-reflection}
region=${2:-100,80,180,140}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
log=$folder/region.ndjson.gz

raywalk trace "$scene" --region "$region" --output "$log"

# A table of the events that the questions are about. Numbers of nodes begin anew in each pixel, so a pixel's number belongs to the key.
duckdb "$folder/log.db" <<SQL
CREATE TABLE events AS
SELECT
    count(enter->>'pixel') OVER (ROWS UNBOUNDED PRECEDING) AS pixel,
    node, enter, mark, note, path
FROM read_json('$log', format = 'newline_delimited', columns = {
    node: 'BIGINT', enter: 'JSON', mark: 'JSON', note: 'VARCHAR', path: 'VARCHAR'})
WHERE node IS NOT NULL;

CREATE VIEW pixels AS
SELECT pixel, (enter->>'\$.pixel[0]')::INT AS x, (enter->>'\$.pixel[1]')::INT AS y FROM events WHERE (enter->>'pixel') IS NOT NULL;

CREATE VIEW rays AS
SELECT pixel, node, path, enter->>'\$.ray.kind' AS kind FROM events WHERE (enter->>'ray') IS NOT NULL;

-- What each ray meets first.
CREATE VIEW met AS
SELECT rays.*, events.mark->>'\$.nearest.object' AS object
FROM rays JOIN events USING (pixel, node) WHERE (events.mark->>'nearest') IS NOT NULL;
SQL

ask() {
    printf '\n%s\n' "$1"
    duckdb "$folder/log.db" -c "$2"
}

ask "How many rays of each kind are there?" \
    "SELECT kind, count(*) AS rays FROM rays GROUP BY kind ORDER BY rays DESC, kind"

ask "Which object costs the most rays? (those that set off from it: its shadows, mirror images and what is seen through it)" \
    "SELECT met.object, count(*) AS rays
     FROM rays JOIN met ON rays.pixel = met.pixel AND met.path = regexp_replace(rays.path, ' [^ ]+$', '')
     WHERE rays.path LIKE '% %' GROUP BY met.object ORDER BY rays DESC, met.object"

ask "Which object is tested most often, and how often in vain?" \
    "SELECT entered.enter->>'\$.test.object' AS object, count(*) AS tests, count(*) FILTER ((marked.mark->>'miss') IS NOT NULL) AS misses
     FROM events AS entered JOIN events AS marked USING (pixel, node)
     WHERE (entered.enter->>'test') IS NOT NULL
       AND ((marked.mark->>'miss') IS NOT NULL OR (marked.mark->>'hit') IS NOT NULL)
     GROUP BY object ORDER BY tests DESC, object"

ask "In which pixels, and in which object, is light reflected totally?" \
    "SELECT x, y, rays.path, met.object
     FROM events JOIN rays USING (pixel, node) JOIN met USING (pixel, node) JOIN pixels USING (pixel)
     WHERE (events.mark->>'total_internal_reflection') IS NOT NULL ORDER BY y, x, rays.path LIMIT 10"

# The same counts as a rendering has. (Where pixels share samples, with shared:N and adaptive, a rendering needs fewer rays: each pixel's log
# has all of its own.)
counted=$(duckdb "$folder/log.db" -noheader -list -c \
    "SELECT count(*) FILTER (kind = 'camera'), count(*) FILTER (kind = 'reflected'), count(*) FILTER (kind = 'transmitted'),
            count(*) FILTER (kind = 'shadow') FROM rays")
stated=$(raywalk render "$scene" --crop "$region" --output "$folder/region.pfm" --quiet --stats json |
    sed 's/.*"camera":\([0-9]*\),"reflected":\([0-9]*\),"transmitted":\([0-9]*\),"shadow":\([0-9]*\),"total".*/\1|\2|\3|\4/')
printf '\nrays in the log: %s; in a rendering: %s (camera|reflected|transmitted|shadow)\n' "$counted" "$stated"
if raywalk trace "$scene" --pixel "${region%,*,*}" | head -1 | grep -q '"sampling":{"\(shared\|adaptive\)"'; then
    echo "pixels share samples: the counts differ"
else
    [ "$counted" = "$stated" ]
fi
