-- Parking bays, tracks and cycle tracks take the ground of the sidewalks on which they lie.

CREATE OR REPLACE FUNCTION streetgen._strip_without(strip geometry, holes geometry[]) RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    -- No slit of rounding stays between two of them, and no sliver beside them.
    SELECT CASE WHEN ST_Area(strip) - ST_Area(rest) > 0.01 THEN rest END
    FROM (SELECT coalesce(ST_Multi(ST_Collect(geom)), ST_SetSRID('MULTIPOLYGON EMPTY'::geometry, ST_SRID(strip)))
            AS rest
        FROM ST_Dump(ST_Difference(strip, ST_Buffer(ST_Buffer(ST_Collect(holes), 0.01, 'join=mitre'), -0.01,
            'join=mitre')))
        WHERE ST_Dimension(geom) = 2 AND 2 * ST_Area(geom) > 0.05 * ST_Perimeter(geom) OFFSET 0) r $$;
COMMENT ON FUNCTION streetgen._strip_without(geometry, geometry[]) IS
    'What others leave of the strip of a sidewalk (MULTIPOLYGON); pieces narrower than 5 cm are none. NULL: they take '
    'no more than a square decimetre.';

CREATE OR REPLACE FUNCTION streetgen._sidewalk_holes(of_model text, subjects text[], standing boolean) RETURNS jsonb
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT CASE WHEN takers <> '' THEN jsonb_build_object(
            'surface', CASE WHEN standing THEN 'coalesce(s.surface, b.cut, w.surface)'
                ELSE 'coalesce(b.cut, w.surface)' END,
            'strip', CASE WHEN standing THEN 'CASE WHEN s.surface IS NOT NULL THEN s.strip WHEN b.cut IS NOT NULL '
                'THEN w.surface END' ELSE 'CASE WHEN b.cut IS NOT NULL THEN w.surface END' END,
            'holes', streetgen._fill_template(CASE WHEN standing THEN streetgen._part('sidewalk_stands') ELSE '' END
                || replace(streetgen._part('sidewalk_holes'), '{takers}', takers), jsonb_build_object(
                'of_model', of_model, 'stays', CASE WHEN 'footway' = ANY (subjects)
                    THEN streetgen._part('sidewalk_stays') ELSE '' END,
                'cut_anew', CASE WHEN standing THEN 's.surface IS NULL AND ' ELSE '' END)))
        ELSE jsonb_build_object('surface', 'w.surface', 'strip', 'NULL::geometry', 'holes', '') END
    FROM concat_ws(E'\n        UNION ALL ',
        CASE WHEN 'object' = ANY (subjects) THEN streetgen._part('sidewalk_bays') END,
        CASE WHEN 'rail' = ANY (subjects) THEN streetgen._part('sidewalk_tracks') END,
        CASE WHEN 'footway' = ANY (subjects) THEN streetgen._part('sidewalk_cycle_tracks') END) takers $$;
COMMENT ON FUNCTION streetgen._sidewalk_holes(text, text[], boolean) IS
    'What the queries of sidewalks say of bays, tracks and cycle tracks, by the subjects of a model: of_model stands '
    'before the names of tables, with its point. standing: a sidewalk whose strip stays is not cut anew.';

CREATE OR REPLACE FUNCTION streetgen._make_sidewalk_functions(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
DECLARE
    subjects constant text[] := streetgen._subjects(model);
BEGIN
    IF '{object,rail,footway}' && subjects THEN
        PERFORM streetgen._compose_function(model, '_cut_sidewalks(sidewalks bigint[])', 'void',
            streetgen._fill_template(streetgen._part('cut_sidewalks'), streetgen._sidewalk_holes('', subjects, false)),
            '_cut_sidewalks(bigint[])', 'Takes from sidewalks (NULL: all) what bays, tracks and cycle tracks lie on',
            'VOLATILE SET jit = off SET streetgen.computes = ''on'''),
            streetgen._compose_function(model, '_sidewalks_on(ground geometry[])', 'bigint[]',
            streetgen._part('sidewalks_on'), '_sidewalks_on(geometry[])', 'The sidewalks on ground where bays came, '
                'went or moved (NULL: all, as NULL)', 'STABLE SET jit = off');
    ELSE
        PERFORM streetgen._drop_own_functions(model, '{_cut_sidewalks,_sidewalks_on}');
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._make_sidewalk_functions(name) IS
    'Makes the functions of a model by which sidewalks follow parking bays, tracks and cycle tracks; none where it '
    'computes none of them.';
