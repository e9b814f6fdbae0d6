-- People on foot: their places.

CREATE OR REPLACE FUNCTION streetgen._line_across(axis geometry, metres float8, to_left boolean) RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$ SELECT ST_MakeLine(p, ST_Translate(p, s * (ST_Y(a) - ST_Y(b)) / d, s * (ST_X(b) - ST_X(a)) / d))
        FROM (SELECT least(1, greatest(0, metres / ST_Length(axis))) AS f, least(0.01, 0.1 / ST_Length(axis)) AS e) v,
            LATERAL (SELECT ST_LineInterpolatePoint(axis, f) AS p,
                ST_LineInterpolatePoint(axis, greatest(0, f - e)) AS a,
                ST_LineInterpolatePoint(axis, least(1, f + e)) AS b) q,
            LATERAL (SELECT nullif(ST_Distance(a, b), 0) AS d, CASE WHEN to_left THEN 60 ELSE -60 END AS s) n $$;
COMMENT ON FUNCTION streetgen._line_across(geometry, float8, boolean) IS
    'A line of 60 m from a place of an axis, perpendicular to it, to the left or right; NULL where the axis turns '
    'back on itself.';

CREATE OR REPLACE FUNCTION streetgen._walked_part(axis geometry, metres float8, to_left boolean, surface geometry)
    RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$ SELECT d.geom FROM (SELECT streetgen._line_across(ST_Force2D(axis), metres, to_left) AS geom) l,
            ST_Dump(ST_CollectionExtract(ST_Intersection(l.geom, surface), 2)) d
        ORDER BY ST_Distance(d.geom, ST_StartPoint(l.geom)) LIMIT 1 $$;
COMMENT ON FUNCTION streetgen._walked_part(geometry, float8, boolean, geometry) IS
    'The first stretch of a line across an axis that lies on a surface; NULL: none within 60 m.';

CREATE OR REPLACE FUNCTION streetgen._make_driving_views(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    subjects constant text[] := streetgen._subjects(model);
BEGIN
    PERFORM streetgen._use_model(model);
    IF NOT streetgen._has_traffic(model) OR 'interconnection' <> ALL (subjects) THEN
        RETURN;
    END IF;
    EXECUTE streetgen._part('walker_crossing') || CASE WHEN 'sidewalk' = ANY (subjects)
        THEN ' UNION ALL ' || streetgen._part('walker_beside') ELSE '' END;
    COMMENT ON VIEW walker_place IS
        'Where people on foot are; one whose sidewalk or street is gone has no row';
    COMMENT ON COLUMN walker_place.walker_id IS 'who';
    COMMENT ON COLUMN walker_place.geom IS 'POINT in the middle of the sidewalk, or on the roadway';
END $$;
COMMENT ON FUNCTION streetgen._make_driving_views(name) IS
    'Makes the view of people on foot of a model with traffic, again and again.';

CREATE OR REPLACE FUNCTION streetgen._driving_view() RETURNS TABLE(name name, subject text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 2 SET search_path = pg_catalog
    AS $$ VALUES ('walker_place'::name, 'interconnection'), ('walker_place'::name, 'sidewalk') $$;
COMMENT ON FUNCTION streetgen._driving_view() IS 'Views of the room, and the subjects whose tables they read.';

CREATE OR REPLACE FUNCTION streetgen._driving_edited() RETURNS TABLE(relation name)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 2 SET search_path = pg_catalog
    AS $$ VALUES ('actor_rule'::name), ('walker') $$;
COMMENT ON FUNCTION streetgen._driving_edited() IS 'The tables of scenes that an editor may write.';
