-- OpenDRIVE: sidewalks as the outermost lanes of roads.

CREATE OR REPLACE FUNCTION streetgen._opendrive_sidewalks(computed boolean) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT CASE WHEN NOT computed THEN $part$,
sidewalk_lane AS (SELECT NULL::bigint AS road_id, NULL::text AS side, NULL::text AS text WHERE false)$part$
    ELSE $part$,
-- One that lies along less than half of its road is none of its lanes.
sidewalk_lane AS MATERIALIZED (
    SELECT d.road_id, s.side, '<lane id="' || CASE s.side WHEN 'left' THEN lefts + 1
            ELSE lefts - cardinality(lanes) - 1 END || '" type="sidewalk" level="false"><width sOffset="0" a="'
        || streetgen._opendrive_number(s.width, 5) || '" b="0" c="0" d="0"/>'
        || '<roadMark sOffset="0" type="none" color="standard" laneChange="none"/><height sOffset="0" inner="'
        || raised || '" outer="' || raised || '"/></lane>' AS text
    FROM (SELECT edge_id, side, max(width) AS width, sum(ST_Area(surface)) AS area FROM %1$I.sidewalk
            WHERE node_id IS NULL AND side IN ('left', 'right') GROUP BY edge_id, side) s
        JOIN (SELECT edge_id, min(road_id) AS leftmost, max(road_id) AS rightmost FROM drawn GROUP BY edge_id) e
            USING (edge_id)
        JOIN drawn d ON d.road_id = CASE s.side WHEN 'left' THEN leftmost ELSE rightmost END,
        (SELECT k.raised FROM streetgen._mesh_kind() k WHERE k.kind = 'sidewalk') k
    WHERE s.width > 0 AND area >= s.width * total / 2)$part$ END $$;
COMMENT ON FUNCTION streetgen._opendrive_sidewalks(boolean) IS
    'Query sidewalk_lane of a file of OpenDRIVE, after streetgen._opendrive_roads(): the sidewalk on a side of a road '
    'as a lane, raised by a kerb; nothing of a model that computes none.';
