-- The partition of the ground beside streets, by name: footways and areas of the street take it from each other.

--{wanted_ground
-- Areas come before lines of their kind: turn 0, then 1. Areas of kinds that win come before all that do not.
area_ground AS NOT MATERIALIZED (
    SELECT a.street_area_id AS id, a.kind, a.level, array_position(streetgen._area_kinds(), a.kind) - CASE WHEN a.kind
            = ANY (string_to_array((SELECT value FROM setting WHERE name = 'area_wins'), ','))
            THEN cardinality(streetgen._area_kinds()) ELSE 0 END AS rank, 0 AS turn,
        a.surface AS paved, a.geom, ST_CollectionExtract(ST_MakeValid(a.geom), 3) AS surface
    FROM street_area a WHERE a.kind <> 'roadway'),
line_ground AS NOT MATERIALIZED (
    SELECT f.footway_id AS id, f.use, f.level, array_position(streetgen._area_kinds(), f.use) AS rank, 1 AS turn,
        f.width, f.paved, f.geom, f.surface
    FROM ({footway_ground}) f)

--{footway_ground
SELECT f.footway_id, u.use, f.level, w.width, f.surface AS paved, f.geom,
    ST_Buffer(ST_Force2D(f.geom), w.width / 2, 'endcap=flat quad_segs=4') AS surface
FROM footway f LEFT JOIN axis_class c ON c.class = f.kind, LATERAL (SELECT coalesce(c.use, 'walk') AS use) u,
    LATERAL (SELECT coalesce(f.width, c.width, value::float8) AS width FROM setting
        WHERE name = 'mapped_sidewalk_minimal') w
WHERE u.use = ANY (streetgen._footway_uses())

--{ground_beside
-- Surfaces within a box about g; before: what g gives way to.
        SELECT s.surface, true AS before FROM roadway s WHERE s.surface && {box} AND s.level = g.level
        UNION ALL SELECT w.surface, true FROM sidewalk w JOIN kerb k USING (edge_id, side, part)
            WHERE w.surface && {box} AND k.level = g.level
        UNION ALL SELECT o.surface, (o.rank, o.turn, o.id) < (g.rank, g.turn, g.id) FROM area_ground o
            WHERE o.geom && {box} AND o.level = g.level AND (o.turn, o.id) <> (g.turn, g.id)
        UNION ALL SELECT o.surface, (o.rank, o.turn, o.id) < (g.rank, g.turn, g.id) FROM line_ground o
            WHERE o.geom && ST_Expand(g.surface, 10) AND o.surface && {box} AND o.level = g.level
                AND (o.turn, o.id) <> (g.turn, g.id)

--{tracks_beside
        UNION ALL SELECT t.surface, true FROM (SELECT surface FROM track_strip t
            WHERE t.geom && ST_Expand({box}, 8) AND t.level = g.level OFFSET 0) t WHERE t.surface && {box}

--{footway_surface
CREATE OR REPLACE VIEW footway_surface WITH (security_invoker = true) AS
WITH {wanted_ground}
SELECT g.id AS footway_id, g.use, g.level, g.width, g.paved, g.geom,
    ST_Multi(r.surface)::geometry(MultiPolygon, {srid}) AS surface
FROM line_ground g, LATERAL (
    SELECT ST_Union(surface, 0.0001) AS surface FROM (
{ground_at_box}) o WHERE before) b,
    LATERAL (SELECT CASE WHEN b.surface IS NULL THEN g.surface
        ELSE ST_CollectionExtract(ST_Difference(g.surface, b.surface, 0.0001), 3) END AS surface) r
WHERE ST_Area(r.surface) > 0.01

--{area_surface
CREATE OR REPLACE VIEW area_surface WITH (security_invoker = true) AS
WITH {wanted_ground}
SELECT g.id AS street_area_id, g.kind, g.level, g.paved, g.geom,
    ST_Multi(r.surface)::geometry(MultiPolygon, {srid}) AS surface
FROM area_ground g, LATERAL (
    SELECT ST_Union(surface, 0.0001) FILTER (WHERE before) AS surface,
        ST_Union(surface, 0.0001) FILTER (WHERE NOT before) AS after FROM (
{ground_near_box}) o) b,
    LATERAL (SELECT ST_UnaryUnion(ST_Collect(ARRAY[g.surface, b.surface, b.after]), 0.0001) AS geom) whole,
    -- A hole too small to be one goes to the first of the areas about it.
    LATERAL (SELECT ST_Union(hole) AS surface
        FROM (SELECT p.geom AS hole FROM ST_Dump(whole.geom) w, ST_DumpRings(w.geom) p WHERE p.path[1] > 0
            AND ST_Area(p.geom) < (SELECT value::float8 FROM setting WHERE name = 'max_hole_area')
            AND ST_DWithin(p.geom, g.surface, 0.001)) h
        WHERE NOT EXISTS (SELECT FROM area_ground o WHERE o.geom && hole AND o.level = g.level
            AND (o.rank, o.id) < (g.rank, g.id) AND ST_DWithin(o.surface, hole, 0.001))) f,
    LATERAL (SELECT CASE WHEN b.surface IS NULL THEN g.surface
        ELSE ST_CollectionExtract(ST_Difference(g.surface, b.surface, 0.0001), 3) END AS surface) d,
    LATERAL (SELECT CASE WHEN f.surface IS NULL THEN d.surface
        ELSE ST_CollectionExtract(ST_Union(d.surface, f.surface, 0.0001), 3) END AS surface) r
WHERE ST_Area(r.surface) > 0.01

--{surveyed_roadway
CASE WHEN (SELECT 'roadway' = ANY (string_to_array(value, ',')) FROM setting WHERE name = 'area_wins')
        AND kerb_by_hand IS NULL
        AND NOT ((width_by_hand OR source IS NULL) AND num_nonnulls(width, width_end, roadway_offset) > 0)
    THEN (SELECT streetgen._kerbs_by_area(ST_Force2D(a.geom)::bytea,
            array_agg(s.geom::bytea ORDER BY s.street_area_id))
        FROM {areas_beside}) END

--{area_used
CASE WHEN surveyed IS NOT NULL
    THEN (SELECT ST_Multi(ST_CollectionExtract(ST_Collect(ST_MakeValid(s.geom) ORDER BY s.street_area_id), 3))
        FROM {areas_beside}) END

--{areas_beside
(SELECT street_area_id, streetgen._area_beside(geom, a.geom) AS geom FROM street_area
    WHERE kind = 'roadway' AND level = a.level AND geom && ST_Expand(a.geom, 32)) s WHERE NOT ST_IsEmpty(s.geom)
