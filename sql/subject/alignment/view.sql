-- The arcs of roads, and places along them.

CREATE OR REPLACE FUNCTION streetgen._arc_road_bends(geometry)
    RETURNS TABLE(start_abscissa float8, end_abscissa float8, radius float8, centre bytea, corner bytea, arc bytea)
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100 ROWS 5 AS 'MODULE_PATHNAME', 'streetgen_arc_road_bends';
COMMENT ON FUNCTION streetgen._arc_road_bends(geometry) IS
    'The arcs of a road (as of arc_road_length) in their order: metres along it where each starts and ends, radius, '
    'centre (POINT), the point where the straight lines before and after it would meet (POINT), and the arc '
    '(CIRCULARSTRING); EWKB all three.';

CREATE OR REPLACE FUNCTION streetgen._arc_road_kinks(geometry) RETURNS TABLE(angle float8, place bytea)
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100 ROWS 1 AS 'MODULE_PATHNAME', 'streetgen_arc_road_kinks';
COMMENT ON FUNCTION streetgen._arc_road_kinks(geometry) IS
    'Where the heading of a road (as of arc_road_length) jumps at the end of an arc: by how much, radians, and the '
    'place (POINT, EWKB). A thousandth of a radian is no jump, nor is what ten nanometres are of a short arc.';

CREATE OR REPLACE FUNCTION streetgen._make_alignment_views(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    srid constant integer := (SELECT m.srid FROM streetgen.model m WHERE m.name = model);
BEGIN
    PERFORM streetgen._use_model(model);
    EXECUTE streetgen._fill_template(streetgen._part('road_arc'), jsonb_build_object('srid', srid));
    COMMENT ON VIEW road_arc IS 'The bends of roads that are arcs';
    COMMENT ON COLUMN road_arc.road_arc_id IS 'key, of the road and the number of the bend';
    COMMENT ON COLUMN road_arc.road_id IS 'the road';
    COMMENT ON COLUMN road_arc.start_abscissa IS 'where the arc starts, metres along geom of the road';
    COMMENT ON COLUMN road_arc.end_abscissa IS 'where the arc ends, metres along geom of the road';
    COMMENT ON COLUMN road_arc.radius IS 'metres';
    COMMENT ON COLUMN road_arc.speed_limit IS
        'km/h up to which a car does not slip, by setting road_friction, without superelevation';
    COMMENT ON COLUMN road_arc.centre IS 'centre of the arc';
    COMMENT ON COLUMN road_arc.corner IS 'where the straight lines before and after would meet';
    COMMENT ON COLUMN road_arc.arc IS 'the arc, in the direction of the road';
END $$;
COMMENT ON FUNCTION streetgen._make_alignment_views(name) IS 'Makes the view road_arc of a model, again and again.';

CREATE OR REPLACE FUNCTION streetgen.road_at(model name, road_id bigint, metres float8,
    OUT geom geometry, OUT edge_id bigint, OUT heading float8, OUT curvature float8)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    line geometry;
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_reader(model);
    IF 'alignment' <> ALL (streetgen._subjects(model)) THEN
        RAISE EXCEPTION 'model "%" computes no roads', model USING ERRCODE = '0A000',
            HINT = format('SELECT * FROM streetgen.switch_subject(%L, ''alignment'', true) makes them.', model);
    END IF;
    SELECT geom FROM road WHERE road_id = road_at.road_id INTO line;
    IF line IS NULL THEN
        RAISE EXCEPTION 'there is no road % in model "%"', road_at.road_id, model USING ERRCODE = '22023',
            HINT = format('SELECT road_id FROM %I.road lists those that are there.', model);
    END IF;
    SELECT p.geom, p.heading, p.curvature INTO geom, heading, curvature
        FROM streetgen.arc_road_point(line, metres) p;
    -- Along the axes a road is a little longer than along its arcs.
    SELECT m.edge_id FROM road_edge m JOIN road r USING (road_id) WHERE road_id = road_at.road_id
        AND m.start_abscissa <= greatest(metres, 0) * r.length / streetgen.arc_road_length(line)
            ORDER BY position DESC LIMIT 1 INTO edge_id;
END $$;
COMMENT ON FUNCTION streetgen.road_at(name, bigint, float8) IS
    'The place (POINT) at a number of metres along a road of a model, clamped to it: the edge there, heading in '
    'degrees clockwise from the y axis, and curvature, 1/m, positive on left bends. A road that is not there, or a '
    'number that is not finite: 22023; a model without subject alignment: 0A000. NULL for NULL.';

CREATE OR REPLACE FUNCTION streetgen._alignment_view() RETURNS TABLE(name name, subject text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES ('road_arc'::name, 'alignment') $$;
COMMENT ON FUNCTION streetgen._alignment_view() IS
    'Views of roads, and the subjects whose tables they read.';
