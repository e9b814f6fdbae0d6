-- The cost of a line as a road.

CREATE OR REPLACE FUNCTION streetgen.path_cost(model name, line geometry, network text)
    RETURNS TABLE(term text, cost float8)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 8 SET search_path = pg_catalog, public
    AS $$
DECLARE
    along geometry;
    site streetgen.road_site;
    elements float8[];
    grades float8[];
    ends float8[];
BEGIN
    PERFORM streetgen._require_reader(model), streetgen._require_design(model);
    along := ST_RemoveRepeatedPoints(streetgen._in_model(model, line, 'the line', '{LINESTRING}',
        'ST_LineMerge makes one line of parts that meet.'), 0.001);
    site := streetgen._road_site(model, ST_Expand(along, 500), streetgen._road_rules(model, network));
    elements := ARRAY(SELECT v FROM streetgen._horizontal_alignment(ST_Force2D(along)::bytea,
        array_fill(0::float8, ARRAY[ST_NPoints(along)]), array_fill(0::float8, ARRAY[ST_NPoints(along)]),
        array_fill(0::float8, ARRAY[ST_NPoints(along)])) e,
        unnest(ARRAY[e.abscissa, e.x, e.y, e.heading, e.length, e.curvature_start, e.curvature_end])
            WITH ORDINALITY u(v, k) ORDER BY e.abscissa, k);
    IF ST_Zmflag(along) >= 2 THEN
        grades := ARRAY(SELECT v FROM (SELECT nth, z, coalesce(sum(run) OVER (ORDER BY nth), 0) AS s
            FROM (SELECT p.path[1] AS nth, ST_Z(p.geom) AS z,
                ST_Distance(p.geom, lag(p.geom) OVER (ORDER BY p.path[1])) AS run FROM ST_DumpPoints(along) p) r) q,
            unnest(ARRAY[s, z, 0]) WITH ORDINALITY u(v, k) ORDER BY nth, k);
    ELSE
        ends := streetgen._ground_heights(site.tiles, ARRAY[ST_X(ST_StartPoint(along)), ST_X(ST_EndPoint(along))],
            ARRAY[ST_Y(ST_StartPoint(along)), ST_Y(ST_EndPoint(along))]);
        IF 'NaN' = ANY (ends) THEN
            RAISE EXCEPTION 'an end of the line has no terrain under it' USING ERRCODE = '22023',
                HINT = 'data/streetgen terrain FILE MODEL loads heights.';
        END IF;
        grades := ARRAY(SELECT v FROM streetgen._road_profile(site, elements, ends, '{}', '{}', '{}') p,
            unnest(ARRAY[p.abscissa, p.height, p.radius]) WITH ORDINALITY u(v, k) ORDER BY p.abscissa, k);
    END IF;
    RETURN QUERY SELECT e.what, e.cost FROM streetgen._road_estimate(site, elements, grades) e
        WHERE e.what NOT LIKE 'is %';
END $$;
COMMENT ON FUNCTION streetgen.path_cost(name, geometry, text) IS
    'What a line (LINESTRING, of any SRID) would cost as a road of a network (highway, secondary, rural), by the '
    'settings of the model, a row a term: pavement, land, fill, cut, bridge, tunnel, zones, use. A line with heights '
    'is built at them; for others the heights of least cost are found as for links. Another geometry or network, '
    'no terrain at its ends: 22023; a model without a design: 55000. NULL for NULL: no row.';
