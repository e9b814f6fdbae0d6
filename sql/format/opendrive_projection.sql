-- OpenDRIVE: coordinates on a transverse Mercator projection about the origin of a file.

CREATE OR REPLACE FUNCTION streetgen._opendrive_origin(model name, options jsonb)
    RETURNS TABLE(x float8, y float8, z float8, digits integer, tolerance float8, projection text, local boolean,
        convergence float8)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1 SET search_path = pg_catalog, public
    AS $$
BEGIN
    IF options ->> 'georeference' IS DISTINCT FROM 'local' THEN
        RETURN QUERY SELECT o.x, o.y, o.z, o.digits, o.tolerance, trim(r.proj4text), false, 0::float8
            FROM streetgen._export_origin(model, options) o LEFT JOIN spatial_ref_sys r USING (srid);
    ELSE
        RETURN QUERY SELECT 0::float8, 0::float8, o.z, o.digits, o.tolerance, p.projection, true,
                -ST_Azimuth(ST_Transform(place, p.projection),
                    ST_Transform(ST_Translate(place, 0, 100), p.projection))
            FROM streetgen._export_origin(model, options) o, ST_SetSRID(ST_Point(o.x, o.y), o.srid) place,
                ST_Transform(place, 4326) earth, LATERAL (SELECT '+proj=tmerc +lat_0='
                    || streetgen._decimal(ST_Y(earth), 11) || ' +lon_0=' || streetgen._decimal(ST_X(earth), 11)
                    || ' +k=1 +x_0=0 +y_0=0 +datum=WGS84 +units=m +no_defs' AS projection) p;
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._opendrive_origin(name, jsonb) IS
    'The place from which a file of OpenDRIVE counts coordinates and heights, with digits, tolerance and the text of '
    'PROJ: that of the model, or where local one about that place, whose x and y are 0 then. convergence: radians by '
    'which headings are greater than in the model.';

CREATE OR REPLACE FUNCTION streetgen._course_places(alignment float8[]) RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    SELECT ST_MakeLine(array_agg(place ORDER BY n))
    FROM (SELECT n, ST_Point(alignment[7 * n - 5], alignment[7 * n - 4]) AS place
        FROM generate_series(1, cardinality(alignment) / 7) n
        UNION ALL SELECT cardinality(alignment) / 7 + 1, ST_Point(p.x, p.y)
        FROM streetgen._alignment_point(alignment, NULL, 1e9) p) places $$;
COMMENT ON FUNCTION streetgen._course_places(float8[]) IS
    'The places at which the elements of an alignment begin, and the one where the last ends.';

CREATE OR REPLACE FUNCTION streetgen._course_through(alignment float8[], places geometry) RETURNS float8[]
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    WITH element AS (
        SELECT n, alignment[7 * n - 3] AS heading, alignment[7 * n - 2] AS length, alignment[7 * n - 1] AS bend,
            alignment[7 * n] AS bend_end, f.place, ST_Distance(f.place, t.place) / ST_Distance(f.was, t.was) AS scale,
            ST_Azimuth(f.was, t.was) - ST_Azimuth(f.place, t.place) AS turn
        FROM streetgen._course_places(alignment) own, generate_series(1, cardinality(alignment) / 7) n,
            LATERAL (SELECT ST_PointN(places, n) AS place, ST_PointN(own, n) AS was) f,
            LATERAL (SELECT ST_PointN(places, n + 1) AS place, ST_PointN(own, n + 1) AS was) t)
    SELECT array_agg(v ORDER BY n, k)
    FROM (SELECT *, coalesce(sum(length * scale) OVER (ORDER BY n ROWS BETWEEN UNBOUNDED PRECEDING AND 1 PRECEDING), 0)
            AS station FROM element) e,
        unnest(ARRAY[station, ST_X(place), ST_Y(place), heading + turn, length * scale, bend / scale, bend_end / scale])
            WITH ORDINALITY u(v, k) $$;
COMMENT ON FUNCTION streetgen._course_through(float8[], geometry) IS
    'An alignment whose elements begin and end in other places: each is moved, turned and scaled.';

CREATE OR REPLACE FUNCTION streetgen._projected_geometries(model name, options jsonb)
    RETURNS TABLE(kind text, id bigint, geom geometry)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10000 SET search_path = pg_catalog, public
    AS $$
DECLARE
    projection text;
BEGIN
    PERFORM streetgen._use_model(model);
    projection := (SELECT o.projection FROM streetgen._opendrive_origin(model, options) o WHERE o.local);
    IF projection IS NULL THEN
        RETURN;
    END IF;
    -- PROJ reads the text of a projection once for all: that takes as long as a thousand geometries.
    RETURN QUERY WITH written_edge AS MATERIALIZED (SELECT streetgen._written_edges(model, options) AS edge_id),
    source AS MATERIALIZED (
        SELECT *, row_number() OVER () AS n FROM (
            SELECT 'edge' AS kind, edge_id AS id, e.geom FROM edge e JOIN written_edge USING (edge_id)
            UNION ALL SELECT 'lane', lane_id, l.geom FROM lane l JOIN written_edge USING (edge_id)
            UNION ALL SELECT 'surface', lane_id, surface FROM lane JOIN written_edge USING (edge_id)
            UNION ALL SELECT 'way', streetgen._file_id(way_kind, way_id, part), w.geom
            FROM streetgen._connecting_ways(model, options) w
            UNION ALL SELECT 'head', streetgen._file_id('lane', lane_id, along_axis::integer), h.geom
            FROM streetgen._signal_heads(model) h
            UNION ALL SELECT 'marking', marking_id, m.geom FROM marking m
            UNION ALL SELECT 'marking surface', marking_id, m.surface FROM marking m WHERE m.kind <> 'arrow'
            UNION ALL SELECT 'course', edge_id, ST_SetSRID(streetgen._course_places(alignment), o.srid)
            FROM streetgen._export_origin(model, options) o, streetgen._opendrive_courses(model, options)
            UNION ALL SELECT 'object', street_object_id, o.geom FROM streetgen._opendrive_objects(model) o
            UNION ALL SELECT 'object surface', street_object_id, surface FROM streetgen._opendrive_objects(model)) g
        WHERE NOT ST_IsEmpty(g.geom)),
    part AS (
        SELECT p.path[1] AS n, (array_agg(p.geom))[1] AS one, ST_Collect(p.geom) AS several
        FROM (SELECT ST_Transform(ST_Collect(ST_Force2D(s.geom) ORDER BY n), projection) AS geom FROM source s) c,
            ST_Dump(c.geom) p
        GROUP BY p.path[1])
    SELECT s.kind, s.id, CASE ST_GeometryType(s.geom) WHEN ST_GeometryType(p.one) THEN p.one ELSE p.several END
    FROM source s JOIN part p USING (n);
END $$;
COMMENT ON FUNCTION streetgen._projected_geometries(name, jsonb) IS
    'The geometries that a file of OpenDRIVE is made of, by what they are of: edge, lane, its surface, '
    'way, head, marking and its surface, course, object and its surface. They are there where '
    'coordinates count on a projection of their own, and on that.';
