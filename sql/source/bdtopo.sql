-- BD TOPO of IGN to axes.

CREATE OR REPLACE FUNCTION streetgen._bdtopo_column() RETURNS TABLE(name text, columns text[], becomes text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 20 SET search_path = pg_catalog
    AS $$
    -- V3 (as a table, as a shapefile) before V2.
    VALUES ('id', '{cleabs,id,ogc_fid,gid,fid}'::text[], 'The identity in the source.'),
    ('width', '{largeur_de_chaussee,largeur}', 'The width of the roadway from kerb to kerb.'),
    ('lane_count', '{nombre_de_voies,nb_voies}', 'The number of general and bus lanes.'),
    ('sens', '{sens_de_circulation,sens}', 'The direction of the traffic.'),
    ('speed', '{vitesse_moyenne_vl,vit_moy_vl}', 'The speed.'),
    ('importance', '{importance}', 'The importance.'),
    ('level', '{position_par_rapport_au_sol,pos_sol}', 'The level; a ford is on the ground.'),
    ('class', '{nature}', 'The class; Rond-point is a roundabout.'),
    ('name', '{nom_voie_ban_gauche,nom_collaboratif_gauche,nom_1_gauche,nom_coll_g,nom_1_g,nom_rue_g,nom_voie_g}',
        'The name of the street.'),
    ('ref', '{cpx_numero,numero}', 'The number of the route.'),
    ('fictif', '{fictif}', 'A fictitious axis is no street.'),
    ('bus', '{reserve_aux_bus,bus}',
        'A bus lane of the direction that it names; else of that of the traffic. It is one of its lanes; the only one '
        'where cars may not drive, or the width has no room for theirs beside it.'),
    ('cycle', '{bande_cyclable,cyclable}', 'A cycle lane of the direction that it names.'),
    ('cycle_right', '{amenagement_cyclable_droit,amgt_cy_d}',
        'Bande cyclable is a cycle lane at the kerb on the right of the drawing. Tracks, ways shared with people on '
        'foot and gutters are no lanes of the roadway. What else it says is named.'),
    ('cycle_right_way', '{sens_amenagement_cyclable_droit,sens_cy_d}',
        'The direction of that cycle lane; else that of the lanes beside it. One against these, or without its '
        'lane, is named.'),
    ('cycle_left', '{amenagement_cyclable_gauche,amgt_cy_g}', 'As amenagement_cyclable_droit, on the left.'),
    ('cycle_left_way', '{sens_amenagement_cyclable_gauche,sens_cy_g}', 'As sens_amenagement_cyclable_droit.'),
    ('access', '{acces_vehicule_leger,acces_vl}',
        'Who may drive: nobody, or who has a permit. Where it is free or one pays a toll all may.'),
    ('height_limit', '{restriction_de_hauteur,restr_h}', 'The height of vehicles that may pass, metres.') $$;
COMMENT ON FUNCTION streetgen._bdtopo_column() IS
    'The columns of BD TOPO that an import looks at: a name for each, what tables call it, the first one going before '
    'others, and what becomes of it.';

CREATE OR REPLACE FUNCTION streetgen._bdtopo_expression(columns text[], present text[]) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    SELECT quote_ident(there) || '::text' FROM unnest(columns) WITH ORDINALITY c(known, place), unnest(present) there
    -- A shapefile of other hands has ten letters of a name.
    WHERE lower(there) = known OR lower(there) = left(known, 10) AND 1 = (SELECT count(*)
        FROM streetgen._bdtopo_column() c WHERE lower(there) IN (SELECT left(name, 10) FROM unnest(c.columns) name))
    ORDER BY lower(there) = known DESC, place LIMIT 1 $$;
COMMENT ON FUNCTION streetgen._bdtopo_expression(text[], text[]) IS
    'The column of a table that has one of these names, in any case, or is shortened to ten letters of one alone.';

CREATE OR REPLACE FUNCTION streetgen._bdtopo_says(said text) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN coalesce(said, '') !~* '^\s*(non|sans objet|nc|aucun.*)?\s*$';
COMMENT ON FUNCTION streetgen._bdtopo_says(text) IS 'Whether a column of BD TOPO says that there is something.';

CREATE OR REPLACE FUNCTION streetgen._bdtopo_way(said text, usual text) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE WHEN NOT streetgen._bdtopo_says(said) THEN NULL
        WHEN said ~* 'deux|double|bidirectionnel' THEN 'both' WHEN said ~* 'inverse' THEN 'reverse'
        WHEN said ~* 'direct' THEN 'direct' ELSE usual END;
COMMENT ON FUNCTION streetgen._bdtopo_way(text, text) IS
    'The direction of a lane that BD TOPO names: direct, reverse or both, the usual one where it names none, NULL '
    'where there is no lane.';

CREATE OR REPLACE FUNCTION streetgen._bdtopo_direction(said text) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE WHEN said ILIKE '%inverse%' THEN 'reverse' WHEN said ILIKE '%direct%' AND said NOT ILIKE '%double%'
        OR said ILIKE 'sens unique' THEN 'direct' ELSE 'both' END;
COMMENT ON FUNCTION streetgen._bdtopo_direction(text) IS
    'The direction of the traffic in the words of BD TOPO: direct, reverse or both.';

CREATE OR REPLACE FUNCTION streetgen._bdtopo_bus_way(said text, usual text) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN streetgen._bdtopo_way(said,
        CASE WHEN said ~* 'bus|couloir|voie|site propre|réserv|^\s*oui\s*$' THEN usual END);
COMMENT ON FUNCTION streetgen._bdtopo_bus_way(text, text) IS
    'streetgen._bdtopo_way of what is reserved for buses, which may name no direction; NULL for words of other things.';

CREATE OR REPLACE FUNCTION streetgen._bdtopo_cycle_way(said text, usual text) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN streetgen._bdtopo_way(said, CASE WHEN said ~* 'bande|cycl|v[ée]lo|^\s*oui\s*$' THEN usual END);
COMMENT ON FUNCTION streetgen._bdtopo_cycle_way(text, text) IS
    'streetgen._bdtopo_way of a cycle lane, which may name no direction; NULL for words of other things.';

CREATE OR REPLACE FUNCTION streetgen._bdtopo_kerb(design text, said text, kerb text, traffic text, driving_side text,
    OUT near text, OUT far text, OUT unread text, OUT unread_way text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    SELECT CASE WHEN lane AND runs IN (beside, 'both') THEN beside END,
        CASE WHEN lane AND runs IN (across, 'both') AND traffic = across THEN across END,
        CASE WHEN lane AND runs IN (across, 'both') AND traffic <> across
                THEN 'a cycle lane at this kerb runs in the direction of the lanes beside it'
            WHEN NOT lane AND streetgen._bdtopo_says(design) AND design !~* '^(double sens.*)?piste|^voie verte|mixte|'
                'goulotte|rampe|escalier|accotement|jalonnement|v[ée]lo ?rue|non mat[ée]rialis[ée]'
                THEN 'it says no lane of the roadway' END,
        CASE WHEN NOT streetgen._bdtopo_says(said) THEN NULL WHEN NOT streetgen._bdtopo_says(design)
                THEN 'no cycle lane is said at this kerb'
            WHEN way IS NULL THEN 'it says no direction' END
    FROM (SELECT coalesce(design ~* 'bande', false) AS lane, streetgen._bdtopo_way(said, NULL) AS way,
            -- The direction of the lanes at this kerb, on a street of both, and the other one.
            CASE kerb WHEN driving_side THEN 'direct' ELSE 'reverse' END AS beside,
            CASE kerb WHEN driving_side THEN 'reverse' ELSE 'direct' END AS across) k,
        LATERAL (SELECT coalesce(way, CASE WHEN traffic = 'both' THEN beside
            WHEN design ~* '^double sens' THEN CASE traffic WHEN 'direct' THEN 'reverse' ELSE 'direct' END
            ELSE traffic END) AS runs) r $$;
COMMENT ON FUNCTION streetgen._bdtopo_kerb(text, text, text, text, text) IS
    'The cycle lane at a kerb (left or right of the drawing): the direction in which it is at the near kerb, and that '
    'in which it is at the far one, each direct, reverse or none; and why what was designed there, or its direction, '
    'is no such lane. Tracks are none. The traffic is direct, reverse or both.';

CREATE OR REPLACE FUNCTION streetgen._bdtopo_kinds(driving integer, of_buses boolean, bus boolean, near_cycle boolean,
    far_cycle boolean, driving_side text) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE WHEN of_buses AND driving = 1 THEN replace(coalesce(streetgen.lane_kinds(driving, NULL, false,
            driving_side, near_cycle, far_cycle, false, false), 'general'), 'general', 'bus')
        ELSE streetgen.lane_kinds(driving, NULL, bus, driving_side, near_cycle, far_cycle, false, false) END;
COMMENT ON FUNCTION streetgen._bdtopo_kinds(integer, boolean, boolean, boolean, boolean, text) IS
    'streetgen.lane_kinds of one direction, whose one lane may be for buses.';

CREATE OR REPLACE FUNCTION streetgen._bdtopo_rows(driving_side text, lane_width float8)
    RETURNS TABLE(geom geometry, width float8, lane_count integer, direction text, speed float8, importance integer,
        name text, ref text, level integer, class text, roundabout_tag text, lanes_both integer, kind_forward text,
        kind_backward text, access text, height_limit float8, source_ref text, label text, left_out text, unread text[])
    LANGUAGE sql STABLE PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
SELECT s.geom, metres, said_lanes::integer, direction, kmh,
    CASE WHEN s.importance ~ '^\d' THEN substring(s.importance FROM '^\d')::integer END,
    -- NC: not classified; NR: not known; SN: without a number.
    CASE WHEN s.name !~* '^\s*(NC|NR|SN)?\s*$' THEN s.name END,
    CASE WHEN s.ref !~* '^\s*(NC|NR|SN)?\s*$' THEN btrim(s.ref) END,
    CASE WHEN s.level ~ '^-?\d' THEN greatest(-50, least(50, substring(s.level FROM '^-?\d{1,3}')::integer))
        ELSE 0 END,
    s.class, CASE s.class WHEN 'Rond-point' THEN s.class END,
    CASE WHEN num_nonnulls(kinds_forward, kinds_backward) > 0 THEN nullif(middle, 0) END, kinds_forward, kinds_backward,
    CASE WHEN s.access ~* 'impossible' THEN 'no' WHEN s.access ~* 'restreint|ayants droit' THEN 'private' END,
    height, s.id, coalesce(s.id, 'number ' || row_number() OVER ()),
    CASE WHEN s.fictif ~* '^\s*(oui|true|t)\s*$' THEN 'fictitious axis' END,
    array_remove(ARRAY[CASE WHEN s.width <> '' AND metres IS NULL THEN 'width' END,
        CASE WHEN s.lane_count <> '' AND said_lanes IS NULL THEN 'lane_count' END,
        CASE WHEN s.sens <> '' AND s.sens !~* 'double|direct|inverse|^sens unique$|^sans objet$|^nc$'
            THEN 'direction' END,
        CASE WHEN s.speed <> '' AND kmh IS NULL THEN 'speed' END,
        CASE WHEN s.height_limit <> '' AND height IS NULL THEN 'height limit' END,
        CASE WHEN s.importance !~* '^\s*(\d|nc|$)' THEN 'importance' END,
        CASE WHEN s.level !~* '^\s*(-?\d|gu[ée] ou radier|nc|$)' THEN 'level' END,
        CASE WHEN s.fictif !~* '^\s*(oui|true|t|non|false|f)?\s*$' THEN 'fictif' END,
        CASE WHEN s.access !~* 'impossible|restreint|ayants droit|libre|p[ée]age|^\s*(nc)?\s*$' THEN 'access' END],
        NULL)
FROM pg_temp._import_line s,
     LATERAL (SELECT streetgen._within(streetgen._metres(s.width), 0, 200) AS metres,
         streetgen._within(streetgen._kmh(s.speed), 0, 400) AS kmh,
         streetgen._within(streetgen._metres(s.height_limit), 1, 30) AS height,
         streetgen._within(streetgen._number(s.lane_count), 0, 30) AS said_lanes) said,
     LATERAL (SELECT coalesce(greatest(said_lanes::integer, 1), 1) AS lanes,
                     -- What names no direction means that of the traffic: of one lane all of it.
                     said_lanes = 1 AND streetgen._bdtopo_bus_way(s.bus, 'all') = 'all' AS of_buses,
                     streetgen._bdtopo_bus_way(s.bus, direction) AS bus_way,
                     streetgen._bdtopo_cycle_way(s.cycle, direction) AS cycle_way) d,
     LATERAL (SELECT coalesce(bus_way IN ('direct', 'both'), false) AS bus_forward,
         coalesce(bus_way IN ('reverse', 'both'), false) AS bus_backward,
         coalesce('direct' IN (right_near, left_near) OR cycle_way IN ('direct', 'both'), false) AS near_forward,
         coalesce('reverse' IN (right_near, left_near) OR cycle_way IN ('reverse', 'both'), false)
             AS near_backward,
         coalesce('direct' IN (right_far, left_far), false) AS far_forward,
         coalesce('reverse' IN (right_far, left_far), false) AS far_backward) w,
     -- A bus lane against a one-way street takes one of its lanes.
     -- One lane in all, unless buses have one of their own, is of both directions.
     LATERAL (SELECT direction = 'both' AND said_lanes = 1 AND NOT bus_forward
         AND NOT bus_backward AS of_both) b,
     -- An odd lane is that of the buses, else in the middle.
     LATERAL (SELECT CASE WHEN direction = 'both' AND lanes >= 3 AND NOT bus_forward AND NOT bus_backward
         THEN lanes % 2 ELSE 0 END AS middle) m,
     LATERAL (SELECT CASE direction WHEN 'both' THEN CASE WHEN of_both THEN 0
             ELSE greatest((lanes - middle + bus_forward::integer) / 2, 1) END
         WHEN 'direct' THEN CASE WHEN bus_backward THEN greatest(lanes - 1, 1) ELSE lanes END ELSE 0 END AS forward,
                     CASE direction WHEN 'both' THEN CASE WHEN of_both THEN 0
             ELSE greatest((lanes - middle + bus_backward::integer) / 2, 1) END
         WHEN 'reverse' THEN CASE WHEN bus_forward THEN greatest(lanes - 1, 1) ELSE lanes END ELSE 0 END AS backward) n,
     -- Buses have the one lane of a direction where cars may not drive, or lanes of both have no room.
     LATERAL (SELECT coalesce(s.access ~* 'impossible', false) OR coalesce(metres, 200)
         < streetgen._narrowest_of_several(lane_width) * (forward + backward + (bus_forward AND forward = 1)::integer
             + (bus_backward AND backward = 1)::integer) AS alone) c,
     LATERAL (SELECT streetgen._bdtopo_kinds(forward, of_buses OR bus_forward AND alone, bus_forward, near_forward,
             far_forward, driving_side) AS kinds_forward,
         streetgen._bdtopo_kinds(backward, of_buses OR bus_backward AND alone, bus_backward, near_backward,
             far_backward, driving_side) AS kinds_backward) k
$$;
COMMENT ON FUNCTION streetgen._bdtopo_rows(text, float8) IS
    'The rows of the import that the lines of a BD TOPO table become, where one drives on a side, left or right, and '
    'lanes are usually so wide, metres.';

CREATE OR REPLACE FUNCTION streetgen._bdtopo_unread()
    RETURNS TABLE(source_ref text, tag text, value text, reason text)
    LANGUAGE sql STABLE PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
    SELECT s.id, u.columns[1], u.value, u.reason
    FROM pg_temp._import_line s, LATERAL (SELECT c.columns, w.* FROM streetgen._bdtopo_column() c JOIN (VALUES
            ('bus', s.bus, CASE WHEN streetgen._bdtopo_says(s.bus)
                AND streetgen._bdtopo_bus_way(s.bus, direction) IS NULL THEN 'it says no lane of buses' END),
            ('cycle', s.cycle, CASE WHEN NOT streetgen._bdtopo_says(s.cycle)
                    OR streetgen._bdtopo_way(s.cycle, NULL) IS NOT NULL THEN NULL
                WHEN streetgen._bdtopo_cycle_way(s.cycle, direction) IS NULL THEN 'it says no cycle lane'
                ELSE 'it says no direction' END),
            ('cycle_right', s.cycle_right, right_unread), ('cycle_right_way', s.cycle_right_way, right_unread_way),
            ('cycle_left', s.cycle_left, left_unread), ('cycle_left_way', s.cycle_left_way, left_unread_way))
            w(name, value, reason) USING (name)) u
    WHERE u.reason IS NOT NULL AND coalesce(s.bus, s.cycle, s.cycle_right, s.cycle_right_way,
        s.cycle_left, s.cycle_left_way) IS NOT NULL $$;
COMMENT ON FUNCTION streetgen._bdtopo_unread() IS
    'What the lines of a BD TOPO table say of lanes that were not made, or not as it is said, with the reason.';

CREATE OR REPLACE FUNCTION streetgen.import_bdtopo(model name, source regclass)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    present text[] := (SELECT array_agg(attname::text ORDER BY attnum) FROM pg_attribute WHERE attrelid = source
        AND attnum > 0 AND NOT attisdropped);
    shape text := (SELECT attname FROM pg_attribute a JOIN pg_type t ON t.oid = a.atttypid WHERE attrelid = source
        AND t.typname = 'geometry' AND NOT attisdropped ORDER BY attnum LIMIT 1);
    driving_side text;
    found jsonb;
BEGIN
    PERFORM streetgen._take_classes(model), streetgen._check_given('source', source::text);
    driving_side := streetgen._driving_side(model);
    SELECT jsonb_object_agg(name, streetgen._bdtopo_expression(columns, present)) INTO found
        FROM streetgen._bdtopo_column();
    IF shape IS NULL OR found ->> 'class' IS NULL OR coalesce(found ->> 'width', found ->> 'lane_count') IS NULL THEN
        RAISE EXCEPTION 'table % is no BD TOPO road table', source USING ERRCODE = '22023',
            DETAIL = format('It has %s, and wants nature and largeur or largeur_de_chaussee beside a geometry.',
                array_to_string(present, ', ')),
            HINT = 'streetgen.import_axes, or data/streetgen load with --mapping, takes any line table whose columns '
                'a mapping names, such as {"width": "breite"}.';
    END IF;
    EXECUTE format('CREATE TEMPORARY TABLE _import_line ON COMMIT DROP AS SELECT s.*, direction, r.near AS right_near, '
        'r.far AS right_far, r.unread AS right_unread, r.unread_way AS right_unread_way, l.near AS left_near, '
        'l.far AS left_far, l.unread AS left_unread, l.unread_way AS left_unread_way '
        'FROM (SELECT %I AS geom, %s FROM %s) s, streetgen._bdtopo_direction(sens) direction, '
        'streetgen._bdtopo_kerb(cycle_right, cycle_right_way, ''right'', direction, %L) r, '
        'streetgen._bdtopo_kerb(cycle_left, cycle_left_way, ''left'', direction, %4$L) l', shape,
        (SELECT string_agg(format('%s AS %I', coalesce(found ->> key, 'NULL::text'), key), ', ')
        FROM jsonb_object_keys(found) key), source, driving_side);
    -- What the table has no column for it does not mention.
    RETURN QUERY SELECT * FROM streetgen._import(model, source::text, format('SELECT geom, %s, source_ref, label, '
        'left_out, unread FROM streetgen._bdtopo_rows(%L, %L)', (SELECT string_agg(name, ', ')
        FROM (VALUES ('width', '{width}'::text[]), ('lane_count', '{lane_count}'), ('direction', '{sens}'),
            ('speed', '{speed}'), ('importance', '{importance}'), ('name', '{name}'), ('ref', '{ref}'),
            ('level', '{level}'),
            ('class', '{class}'), ('roundabout_tag', '{class}'), ('kind_forward', '{bus,cycle,cycle_right,cycle_left}'),
            ('kind_backward', '{bus,cycle,cycle_right,cycle_left}'), ('access', '{access}'),
            ('height_limit', '{height_limit}'),
            ('lanes_both', '{bus,cycle,cycle_right,cycle_left}')) c(name, wants)
        WHERE jsonb_strip_nulls(found) ?| wants), driving_side, streetgen._setting_number(model, 'lane_width')));
    CREATE TEMPORARY TABLE _import_unread ON COMMIT DROP AS
        SELECT * FROM streetgen._bdtopo_unread();
    RETURN QUERY SELECT * FROM streetgen._tell_unread_lanes(model, source::text);
    RETURN QUERY SELECT 'column with a shortened name that several have, not read', there, 1::bigint, NULL::text[]
        FROM unnest(present) there WHERE 1 < (SELECT count(DISTINCT c.name)
            FROM streetgen._bdtopo_column() c, unnest(c.columns) known
            WHERE left(known, 10) = lower(there) AND known <> lower(there))
            AND quote_ident(there) || '::text' NOT IN (SELECT value FROM jsonb_each_text(jsonb_strip_nulls(found)));
    DROP TABLE pg_temp._import_line, pg_temp._import_unread;
END $$;
COMMENT ON FUNCTION streetgen.import_bdtopo(name, regclass) IS
    'Imports a BD TOPO road table, version 2 or 3 by its column names: width, lanes, direction, speed, importance, '
    'position against the ground, nature, street name, number of the route, bus and cycle lanes, limits of height. '
    'Fictitious axes are left out and counted; a width, speed, limit or number of lanes that means nothing is unknown, '
    'and reported. A table that is no BD TOPO, or bad rows: 22023; then the model stays as it was.';
