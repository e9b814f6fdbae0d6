-- How a car stands at a place of a link.

CREATE OR REPLACE FUNCTION streetgen._link_frame(network bytea, link bigint, metres float8, wheelbase float8,
    OUT x float8, OUT y float8, OUT height float8, OUT heading float8, OUT curvature float8, OUT steering float8,
    OUT grade float8)
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100 AS 'MODULE_PATHNAME', 'streetgen_link_frame';
COMMENT ON FUNCTION streetgen._link_frame(bytea, bigint, float8, float8) IS
    'How a car stands whose rear axle is at a place of a link of a network, as streetgen.link_at has it, angles in '
    'radians. Bytes that are no network, an unknown link, a place off it: 22023.';

CREATE OR REPLACE FUNCTION streetgen._link_at(model name, link bigint, place float8, wheelbase float8)
    RETURNS TABLE(geom geometry, heading float8, curvature float8, steering float8, grade float8)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 1 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_reader(model), streetgen._check_given('link', link::text, 'metres', place::text,
        'wheelbase', wheelbase::text), streetgen._require_subject(model, 'interconnection');
    RETURN QUERY SELECT ST_SetSRID(CASE WHEN f.height IS NULL THEN ST_MakePoint(f.x, f.y)
                ELSE ST_MakePoint(f.x, f.y, f.height) END, (SELECT m.srid FROM streetgen.model m WHERE m.name = model)),
            degrees(f.heading), f.curvature, degrees(f.steering), f.grade
        FROM streetgen._link_frame(streetgen._network_near_links(model, ARRAY[link]), link, place, wheelbase) f;
END $$;
COMMENT ON FUNCTION streetgen._link_at(name, bigint, float8, float8) IS 'What streetgen.link_at gives.';

-- An argument and a column may have one name in LANGUAGE sql alone.
CREATE OR REPLACE FUNCTION streetgen.link_at(model name, link bigint, metres float8, wheelbase float8 DEFAULT 2.7)
    RETURNS TABLE(geom geometry, heading float8, curvature float8, steering float8, grade float8)
    LANGUAGE sql STABLE PARALLEL UNSAFE ROWS 1 SET search_path = pg_catalog
    AS $$ SELECT * FROM streetgen._link_at($1, $2, $3, $4) $$;
COMMENT ON FUNCTION streetgen.link_at(name, bigint, float8, float8) IS
    'How a car stands whose rear axle is at a place of a link, metres along it in the direction of its traffic: geom '
    'is the POINT, with a height where the model knows heights. heading: degrees counter-clockwise from east. '
    'curvature: 1/m, positive to the left. steering: the angle of the front wheels of a car with wheelbase metres '
    'between its axles, degrees, positive to the left. grade: metres of height a metre, positive uphill; NULL: heights '
    'are unknown. The course is smooth where lanes and movements meet. A car of streetgen.simulate or table car is at '
    'the place of its front, not of its rear axle. An unknown link, a place off the link, NaN, a '
    'wheelbase out of 0.1 to 30 m: 22023; NULL: 22004; a model without subject interconnection: 55000; an unknown '
    'model: 3F000; not a reader of the model: 42501. Wilkie, Sewall and Lin, sections 3.1 and 6.4.';
