-- Tracks are drawn by hand or imported, and the streets along which they lie follow.

CREATE OR REPLACE FUNCTION streetgen._axes_of_rail_track(model name, tracks jsonb[]) RETURNS bigint[]
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    subjects constant text[] := streetgen._subjects(model);
    beds geometry[];
    axes bigint[] := '{}';
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'rail' <> ALL (subjects) THEN
        RETURN axes;
    END IF;
    -- GeoJSON rounds. Others that end at a track have a round end there (view track_strip).
    WITH line AS (
        SELECT ST_SetSRID(ST_GeomFromGeoJSON(t ->> 'geom'), m.srid) AS geom, (t ->> 'tracks')::integer AS tracks,
            (t ->> 'level')::integer AS level
        FROM unnest(tracks) t, streetgen.model m WHERE m.name = model),
    bed AS (
        SELECT l.geom, l.tracks FROM line l
        UNION ALL SELECT tip, o.tracks FROM line l JOIN rail_track o ON o.level = l.level
                AND o.geom && ST_Expand(l.geom, 0.06),
            LATERAL (VALUES (ST_StartPoint(o.geom)), (ST_EndPoint(o.geom))) v(tip)
        WHERE ST_DWithin(tip, l.geom, 0.06))
    SELECT array_agg(ST_Buffer(geom, b.tracks * streetgen._setting_number(model, 'track_width') / 2 + 0.01))
        FROM bed b INTO beds;
    SELECT ARRAY(SELECT DISTINCT e.axis_id FROM unnest(beds) bed,
        LATERAL (SELECT edge_id, surface FROM section s WHERE s.surface && bed OFFSET 0) s JOIN edge e USING (edge_id)
        WHERE ST_Intersects(s.surface, bed)) INTO axes;
    IF 'sidewalk' = ANY (subjects) THEN
        axes := axes || ARRAY(SELECT DISTINCT e.axis_id FROM unnest(beds) bed,
            LATERAL (SELECT edge_id, surface AS ground FROM sidewalk w WHERE w.surface && bed
                UNION ALL SELECT edge_id, strip FROM sidewalk w WHERE w.strip && bed OFFSET 0) w
                JOIN edge e USING (edge_id)
            WHERE ST_Intersects(w.ground, bed));
    END IF;
    RETURN axes;
END $$;
COMMENT ON FUNCTION streetgen._axes_of_rail_track(name, jsonb[]) IS
    'The axes on whose roadway or sidewalks tracks lie or lay: a run for these finds them anew.';

CREATE OR REPLACE FUNCTION streetgen._rail_decision()
    RETURNS TABLE(relation name, anchor text, axes name[], reach text, follows jsonb, hashed boolean,
        hash_place integer, hash text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES ('rail_track'::name, 'ground', '{}'::name[], '0', '{}'::jsonb, false, NULL::integer, NULL::text) $$;
COMMENT ON FUNCTION streetgen._rail_decision() IS 'Streets follow tracks as they follow decisions about ground.';
