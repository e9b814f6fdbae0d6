-- Drawings of objects, and what their styles mean.

CREATE OR REPLACE FUNCTION streetgen._object_drawn()
    RETURNS TABLE(place integer, subject text, query text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 2 SET search_path = pg_catalog
    AS $$ VALUES
    (54, 'object', $part$
    SELECT 950, CASE t.category WHEN 'green' THEN 'object green' ELSE 'object' END, false,
        streetgen._object_symbol(o.geom, o.angle, t.symbol, greatest(t.size, 4 * pixel)), o.street_object_id
        FROM %1$I.street_object o JOIN %1$I.object_type t USING (type), size
        WHERE pixel < 0.5 AND t.symbol NOT IN ('crossing', 'bay')$part$),
    (55, 'object', $part$
    SELECT 7, 'paint', false, stripes, street_object_id FROM %1$I.pedestrian_crossing, size WHERE pixel < 0.5
    UNION ALL SELECT 7, 'bay', false, surface, street_object_id FROM %1$I.parking_bay, size
        WHERE pixel < 0.5$part$) $$;
COMMENT ON FUNCTION streetgen._object_drawn() IS 'What streetgen.svg draws of objects.';

CREATE OR REPLACE FUNCTION streetgen._object_legend()
    RETURNS TABLE(place integer, style text, form text, near text, far text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 3 SET search_path = pg_catalog
    AS $$ VALUES
    (40, 'object', 'ground', 'object', 'object'),
    (41, 'object green', 'ground', 'tree or hedge', 'tree or hedge'),
    (42, 'bay', 'ground', 'parking bay', 'parking bay') $$;
COMMENT ON FUNCTION streetgen._object_legend() IS 'What the styles of objects mean.';
