#!/usr/bin/env bash
# The log of a region, written in shards and asked in SQL: DuckDB (https://duckdb.org) over all shards at once, and over Parquet.
#
#     bash docs/scale/duckdb.sh [SCENE [X0,Y0,X1,Y1 [SHARDS]]]
#
# Needs `raywalk` and `duckdb` on the path. Shards are logs by themselves, so nothing has to be merged for questions; Parquet takes a
# fraction of the room and of the time of each further question.
set -euo pipefail

scene=${1:-total-reflection}
region=${2:-100,80,180,120}
shards=${3:-3}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

for shard in $(seq "$shards"); do
    raywalk trace "$scene" --region "$region" --shard "$shard/$shards" --quiet --output "$folder/$shard.ndjson.gz"
    # The nodes of a pixel are numbered from 0, so an event is known by its pixel and its number there. Lines are read in their order.
    duckdb -c "
        COPY (
            WITH lines AS (
                SELECT row_number() OVER () AS line, \"at\", node, path, enter, mark, note, value
                FROM read_json('$folder/$shard.ndjson.gz', format = 'newline_delimited', columns = {
                    \"at\": 'BIGINT', node: 'BIGINT', path: 'VARCHAR', enter: 'JSON', mark: 'JSON', note: 'VARCHAR', value: 'JSON'})
            )
            SELECT
                last_value((enter->>'\$.pixel[0]')::INT IGNORE NULLS) OVER before AS x,
                last_value((enter->>'\$.pixel[1]')::INT IGNORE NULLS) OVER before AS y,
                \"at\" AS number, node, path, enter->>'\$.ray.kind' AS ray, mark->>'\$.nearest.object' AS nearest, note, value
            FROM lines WHERE node IS NOT NULL
            WINDOW before AS (ORDER BY line ROWS UNBOUNDED PRECEDING)
        ) TO '$folder/$shard.parquet' (FORMAT parquet)" >/dev/null
done
ls -l "$folder" | awk 'NR > 1 { print $5, $9 }'

echo "Rays of each kind, over all shards:"
duckdb -c "SELECT ray, count(*) AS rays FROM '$folder/*.parquet' WHERE ray IS NOT NULL GROUP BY ray ORDER BY rays DESC, ray"
echo "The pixels with most events:"
duckdb -c "SELECT x, y, count(*) AS events FROM '$folder/*.parquet' GROUP BY x, y ORDER BY events DESC, y, x LIMIT 5"

# The same counts as the log of the whole region has, which is what the shards are joined to.
raywalk trace "$scene" --region "$region" --quiet --output "$folder/whole.ndjson"
raywalk merge "$folder"/*.ndjson.gz -o "$folder/merged.ndjson"
cmp "$folder/whole.ndjson" "$folder/merged.ndjson"
in_parquet=$(duckdb -noheader -list -c "SELECT count(*), count(ray), count(DISTINCT (x, y)) FROM '$folder/*.parquet'")
in_whole=$(grep -c '"node":' "$folder/whole.ndjson")\|$(grep -c '"enter":{"ray"' "$folder/whole.ndjson")\|$(grep -c '"enter":{"pixel"' "$folder/whole.ndjson")
printf 'events|rays|pixels in Parquet: %s; in the log of the region: %s\n' "$in_parquet" "$in_whole"
[ "$in_parquet" = "$in_whole" ]
