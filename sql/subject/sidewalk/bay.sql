-- Parking bays take the ground of the sidewalks on which they lie.

CREATE OR REPLACE FUNCTION streetgen._without_bays(strip geometry, bays geometry[]) RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    -- No slit of rounding stays between two bays, and no sliver beside them.
    SELECT CASE WHEN ST_Area(strip) - ST_Area(rest) > 0.01 THEN rest END
    FROM (SELECT coalesce(ST_Multi(ST_Collect(geom)), ST_SetSRID('MULTIPOLYGON EMPTY'::geometry, ST_SRID(strip)))
            AS rest
        FROM ST_Dump(ST_Difference(strip, ST_Buffer(ST_Buffer(ST_Collect(bays), 0.01, 'join=mitre'), -0.01,
            'join=mitre')))
        WHERE ST_Dimension(geom) = 2 AND 2 * ST_Area(geom) > 0.05 * ST_Perimeter(geom) OFFSET 0) r $$;
COMMENT ON FUNCTION streetgen._without_bays(geometry, geometry[]) IS
    'What bays leave of the strip of a sidewalk (MULTIPOLYGON); pieces narrower than 5 cm are none. NULL: they take no '
    'more than a square decimetre.';

CREATE OR REPLACE FUNCTION streetgen._sidewalk_holes(of_model text, with_bays boolean, standing boolean) RETURNS jsonb
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT CASE WHEN with_bays THEN jsonb_build_object(
            'surface', CASE WHEN standing THEN 'coalesce(s.surface, b.cut, w.surface)'
                ELSE 'coalesce(b.cut, w.surface)' END,
            'strip', CASE WHEN standing THEN 'CASE WHEN s.surface IS NOT NULL THEN s.strip WHEN b.cut IS NOT NULL '
                'THEN w.surface END' ELSE 'CASE WHEN b.cut IS NOT NULL THEN w.surface END' END,
            'bays', streetgen._fill_template(CASE WHEN standing THEN streetgen._part('sidewalk_stands') ELSE '' END
                || streetgen._part('sidewalk_bays'), jsonb_build_object('of_model', of_model,
                'cut_anew', CASE WHEN standing THEN 's.surface IS NULL AND ' ELSE '' END)))
        ELSE jsonb_build_object('surface', 'w.surface', 'strip', 'NULL::geometry', 'bays', '') END $$;
COMMENT ON FUNCTION streetgen._sidewalk_holes(text, boolean, boolean) IS
    'What the queries of sidewalks say of bays: of_model stands before the names of tables, with its point. standing: '
    'a sidewalk whose strip stays is not cut anew.';

CREATE OR REPLACE FUNCTION streetgen._make_sidewalk_cut(model name) RETURNS void
    LANGUAGE sql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._compose_function(model, '_cut_sidewalks(ground geometry[])', 'void',
        streetgen._fill_template(streetgen._part('cut_sidewalks'), streetgen._sidewalk_holes('', true, false)),
        '_cut_sidewalks(geometry[])', 'Takes from sidewalks what bays lie on, near ground where bays came, went or '
            'moved (NULL: everywhere)', 'VOLATILE SET jit = off SET streetgen.computes = ''on''') $$;
COMMENT ON FUNCTION streetgen._make_sidewalk_cut(name) IS
    'Makes the function of a model by which sidewalks follow parking bays.';
