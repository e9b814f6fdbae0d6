-- Footways are drawn by hand or imported, and the sidewalks of the streets beside them follow.

CREATE OR REPLACE FUNCTION streetgen._axes_of_footway(model name, footways jsonb[]) RETURNS bigint[]
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    crossed constant boolean := 'object' = ANY (streetgen._subjects(model));
    reach float8;
    axes bigint[] := '{}';
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'footway' = ANY (streetgen._subjects(model)) THEN
        -- GeoJSON rounds, and is read once. A kerb that gave way lies half of the least width before a footway.
        SELECT max(CASE name WHEN 'mapped_sidewalk_minimal' THEN value::float8 / 2 ELSE value::float8 END) + 0.01
            INTO reach FROM setting WHERE name IN ('mapped_sidewalk_distance', 'mapped_sidewalk_minimal');
        SELECT ARRAY(SELECT DISTINCT e.axis_id FROM (SELECT max(greatest(width, width_end) / 2
                    + abs(roadway_offset)) AS half FROM edge) widest, unnest(footways) f,
            LATERAL (SELECT ST_SetSRID(ST_GeomFromGeoJSON(f ->> 'geom'), m.srid) AS geom FROM streetgen.model m
                WHERE m.name = model OFFSET 0) l,
            LATERAL (SELECT * FROM edge e WHERE e.geom && ST_Expand(l.geom, reach + widest.half) OFFSET 0) e
            -- One that leads over a street maps no sidewalk, and makes a crossing.
            WHERE (f ->> 'role' IS DISTINCT FROM 'crossing' OR crossed AND ST_DWithin(e.geom, l.geom, 2))
                AND ST_DWithin(e.geom, l.geom, reach + greatest(e.width, e.width_end) / 2 + abs(e.roadway_offset)))
            INTO axes;
        -- Cycle tracks take the ground of sidewalks.
        axes := axes || ARRAY(SELECT DISTINCT e.axis_id FROM unnest(footways) f
                JOIN axis_class c ON c.class = f ->> 'kind' AND c.use = 'cycle',
            LATERAL (SELECT ST_SetSRID(ST_GeomFromGeoJSON(f ->> 'geom'), m.srid) AS geom,
                    coalesce((f ->> 'width')::float8, c.width, s.value::float8) / 2 + 0.01 AS half
                FROM streetgen.model m, setting s WHERE (m.name, s.name) = (model, 'mapped_sidewalk_minimal')
                OFFSET 0) l,
            LATERAL (SELECT edge_id FROM sidewalk w WHERE w.surface && ST_Expand(l.geom, half)
                    AND ST_DWithin(w.surface, l.geom, half)
                UNION SELECT edge_id FROM sidewalk w WHERE w.strip && ST_Expand(l.geom, half)
                    AND ST_DWithin(w.strip, l.geom, half) OFFSET 0) w JOIN edge e USING (edge_id)
            WHERE e.axis_id <> ALL (axes));
    END IF;
    IF crossed THEN
        -- A crossing that stands at the border of its street has the paint of the footway over it, too.
        axes := axes || ARRAY(SELECT DISTINCT o.axis_id FROM unnest(footways) f,
            LATERAL (SELECT ST_SetSRID(ST_GeomFromGeoJSON(f ->> 'geom'), m.srid) AS geom FROM streetgen.model m
                WHERE m.name = model OFFSET 0) l,
            LATERAL (SELECT * FROM street_object o WHERE o.geom && ST_Expand(l.geom, 1.01)
                AND ST_DWithin(o.geom, l.geom, 1.01) OFFSET 0) o
                JOIN pedestrian_crossing c USING (street_object_id)
            WHERE o.method = 'relative' AND o.axis_id <> ALL (axes));
    END IF;
    RETURN axes;
END $$;
COMMENT ON FUNCTION streetgen._axes_of_footway(name, jsonb[]) IS
    'The axes beside or over which footways lie or lay: a run for these finds their sidewalks and crossings anew.';

CREATE OR REPLACE FUNCTION streetgen._axes_of_footway_kerb(model name, kerbs jsonb[]) RETURNS bigint[]
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF '{footway,object}' <@ streetgen._subjects(model) THEN
        RETURN ARRAY(SELECT DISTINCT o.axis_id FROM unnest(kerbs) k, LATERAL (
                SELECT ST_SetSRID(ST_GeomFromGeoJSON(k ->> 'geom'), m.srid) AS geom FROM streetgen.model m
                WHERE m.name = model OFFSET 0) l,
            LATERAL (SELECT street_object_id FROM pedestrian_crossing c WHERE c.surface && ST_Expand(l.geom, 7)
                AND ST_DWithin(c.surface, l.geom, 7) OFFSET 0) c JOIN street_object o USING (street_object_id)
        WHERE o.method = 'relative');
    END IF;
    RETURN '{}';
END $$;
COMMENT ON FUNCTION streetgen._axes_of_footway_kerb(name, jsonb[]) IS
    'The axes with a crossing beside which kerbs of footways lie or lay: a run for these draws the crossings anew.';

CREATE OR REPLACE FUNCTION streetgen._footway_decision()
    RETURNS TABLE(relation name, anchor text, axes name[], reach text, follows jsonb, hashed boolean,
        hash_place integer, hash text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 3 SET search_path = pg_catalog
    AS $$ VALUES
    ('footway'::name, 'ground', '{}'::name[], '0', '{}'::jsonb, false, NULL::integer, NULL::text),
    ('footway_kerb', 'ground', '{}', '0', '{}', false, NULL, NULL),
    ('street_area', 'ground', '{}', '0', '{}', false, NULL, NULL) $$;
COMMENT ON FUNCTION streetgen._footway_decision() IS
    'Streets follow footways and kerbs on them as they follow decisions about ground; areas are edited as these are.';
