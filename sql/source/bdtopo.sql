-- BD TOPO of IGN to axes.

CREATE OR REPLACE FUNCTION streetgen._bdtopo_way(said text, usual text) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE WHEN coalesce(said, '') ~* '^\s*(non|sans objet|nc|aucun.*)?\s*$' THEN NULL
        WHEN said ~* 'deux|double|bidirectionnel' THEN 'both' WHEN said ~* 'inverse' THEN 'reverse'
        WHEN said ~* 'direct' THEN 'direct' ELSE usual END;
COMMENT ON FUNCTION streetgen._bdtopo_way(text, text) IS
    'The direction of a lane that BD TOPO names: direct, reverse or both, the usual one where it names none, NULL '
    'where there is no lane.';

CREATE OR REPLACE FUNCTION streetgen._bdtopo_kerb(design text, said text, usual text) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE WHEN design ~* 'bande' THEN coalesce(streetgen._bdtopo_way(said, usual), usual) END;
COMMENT ON FUNCTION streetgen._bdtopo_kerb(text, text, text) IS
    'The direction of the cycle lane at a kerb, by what was designed there and the direction that is said; NULL where '
    'no lane is: tracks are none.';

CREATE OR REPLACE FUNCTION streetgen._bdtopo_rows(driving_side text)
    RETURNS TABLE(geom geometry, width float8, lane_count integer, direction text, speed float8, importance integer,
        name text, ref text, level integer, class text, roundabout_tag text, kind_forward text, kind_backward text,
        access text, source_ref text, label text, left_out text, unread text[])
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
    CASE WHEN of_buses AND forward = 1 THEN concat('bus', CASE WHEN cycle_forward THEN '|cycle' END)
        WHEN bus_forward OR cycle_forward THEN
        streetgen.lane_kinds(forward, NULL, bus_forward, driving_side, cycle_forward, false, false, false) END,
    CASE WHEN of_buses AND backward = 1 THEN concat('bus', CASE WHEN cycle_backward THEN '|cycle' END)
        WHEN bus_backward OR cycle_backward THEN
        streetgen.lane_kinds(backward, NULL, bus_backward, driving_side, cycle_backward, false, false, false) END,
    CASE WHEN s.access ~* 'impossible' THEN 'no' WHEN s.access ~* 'restreint|ayants droit' THEN 'private' END,
    s.id, coalesce(s.id, 'number ' || row_number() OVER ()),
    CASE WHEN s.fictif IN ('Oui', 'true', 't') THEN 'fictitious axis' END,
    array_remove(ARRAY[CASE WHEN s.width <> '' AND metres IS NULL THEN 'width' END,
        CASE WHEN s.lane_count <> '' AND said_lanes IS NULL THEN 'lane_count' END,
        CASE WHEN s.sens <> '' AND s.sens !~* 'double|direct|inverse|^sens unique$|^sans objet$|^nc$'
            THEN 'direction' END,
        CASE WHEN s.speed <> '' AND kmh IS NULL THEN 'speed' END], NULL)
FROM pg_temp._import_line s,
     LATERAL (SELECT streetgen._within(streetgen._metres(s.width), 0, 200) AS metres,
         streetgen._within(streetgen._kmh(s.speed), 0, 400) AS kmh,
         streetgen._within(streetgen._number(s.lane_count), 0, 30) AS said_lanes) said,
     LATERAL (SELECT CASE WHEN s.sens ILIKE '%inverse%' THEN 'reverse' WHEN s.sens ILIKE '%direct%'
         AND s.sens NOT ILIKE '%double%' OR s.sens ILIKE 'sens unique' THEN 'direct' ELSE 'both' END AS direction,
                     coalesce(greatest(said_lanes::integer, 1), 1) AS lanes,
                     -- What names no direction means that of the traffic: of one lane all of it.
                     said_lanes = 1 AND streetgen._bdtopo_way(s.bus, 'all') = 'all' AS of_buses) d,
     LATERAL (SELECT streetgen._bdtopo_way(s.bus, direction) AS bus_way,
         ARRAY[streetgen._bdtopo_way(s.cycle, direction), streetgen._bdtopo_kerb(s.cycle_right, s.cycle_right_way,
             CASE direction WHEN 'both' THEN 'direct' ELSE direction END), streetgen._bdtopo_kerb(s.cycle_left,
             s.cycle_left_way, CASE direction WHEN 'both' THEN 'reverse' ELSE direction END)] AS cycle_ways) way,
     LATERAL (SELECT coalesce(bus_way IN ('direct', 'both'), false) AS bus_forward,
         coalesce(bus_way IN ('reverse', 'both'), false) AS bus_backward,
         cycle_ways && '{direct,both}' AS cycle_forward, cycle_ways && '{reverse,both}' AS cycle_backward) w,
     -- A bus lane against a one-way street takes one of its lanes.
     -- One lane in all, unless buses have one of their own, is of both directions.
     LATERAL (SELECT direction = 'both' AND said_lanes = 1 AND NOT bus_forward
         AND NOT bus_backward AS of_both) b,
     LATERAL (SELECT CASE direction WHEN 'both' THEN CASE WHEN of_both THEN 0 ELSE (lanes + 1) / 2 END WHEN 'direct'
         THEN CASE WHEN bus_backward THEN greatest(lanes - 1, 1) ELSE lanes END ELSE 0 END AS forward,
                     CASE direction WHEN 'both' THEN CASE WHEN of_both THEN 0 ELSE greatest(lanes / 2, 1)
                         END WHEN 'reverse' THEN CASE WHEN bus_forward THEN greatest(lanes - 1, 1) ELSE lanes
                         END ELSE 0 END AS backward) n
$$;
COMMENT ON FUNCTION streetgen._bdtopo_rows(text) IS
    'The rows of the import that the lines of a BD TOPO table become, where one drives on a side, left or right.';

CREATE OR REPLACE FUNCTION streetgen.import_bdtopo(model name, source regclass)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    -- Model column, then the source's names for it, V3 (as a table, as a shapefile) before V2.
    known constant jsonb := '{"id": ["cleabs", "id", "ogc_fid", "gid", "fid"], '
        '"width": ["largeur_de_chaussee", "largeur"], "lane_count": ["nombre_de_voies", "nb_voies"], '
        '"sens": ["sens_de_circulation", "sens"], "speed": ["vitesse_moyenne_vl", "vit_moy_vl"], '
        '"importance": ["importance"], "level": ["position_par_rapport_au_sol", "pos_sol"], "class": ["nature"], '
        '"name": ["nom_voie_ban_gauche", "nom_collaboratif_gauche", "nom_1_gauche", "nom_coll_g", "nom_1_g", '
        '"nom_rue_g", "nom_voie_g"], "ref": ["cpx_numero", "numero"], "fictif": ["fictif"], '
        '"bus": ["reserve_aux_bus", "bus"], "cycle": ["bande_cyclable", "cyclable"], '
        '"cycle_right": ["amenagement_cyclable_droit", "amgt_cy_d"], '
        '"cycle_right_way": ["sens_amenagement_cyclable_droit", "sens_cy_d"], '
        '"cycle_left": ["amenagement_cyclable_gauche", "amgt_cy_g"], '
        '"cycle_left_way": ["sens_amenagement_cyclable_gauche", "sens_cy_g"], '
        '"access": ["acces_vehicule_leger", "acces_vl"]}';
    present text[] := (SELECT array_agg(attname::text ORDER BY attnum) FROM pg_attribute WHERE attrelid = source
        AND attnum > 0 AND NOT attisdropped);
    shape text := (SELECT attname FROM pg_attribute a JOIN pg_type t ON t.oid = a.atttypid WHERE attrelid = source
        AND t.typname = 'geometry' AND NOT attisdropped ORDER BY attnum LIMIT 1);
    found jsonb;
BEGIN
    PERFORM streetgen._take_classes(model), streetgen._check_given('source', source::text);
    SELECT jsonb_object_agg(key, (SELECT quote_ident(n) || '::text'
        FROM jsonb_array_elements_text(value) WITH ORDINALITY AS c(n, i) WHERE n = ANY (present) ORDER BY i LIMIT 1))
        INTO found FROM jsonb_each(known);
    IF shape IS NULL OR found ->> 'class' IS NULL OR coalesce(found ->> 'width', found ->> 'lane_count') IS NULL THEN
        RAISE EXCEPTION 'table % is no BD TOPO road table', source USING ERRCODE = '22023',
            DETAIL = format('It has %s, and wants nature and largeur or largeur_de_chaussee beside a geometry.',
                array_to_string(present, ', ')),
            HINT = 'streetgen.import_axes, or data/streetgen load with --mapping, takes any line table whose columns '
                'a mapping names, such as {"width": "breite"}.';
    END IF;
    EXECUTE format('CREATE TEMPORARY TABLE _import_line ON COMMIT DROP AS SELECT %I AS geom, %s FROM %s', shape,
        (SELECT string_agg(format('%s AS %I', coalesce(found ->> key, 'NULL::text'), key), ', ')
        FROM jsonb_object_keys(known) key), source);
    -- What the table has no column for it does not mention.
    RETURN QUERY SELECT * FROM streetgen._import(model, source::text, format('SELECT geom, %s, source_ref, label, '
        'left_out, unread FROM streetgen._bdtopo_rows(%L)', (SELECT string_agg(name, ', ')
        FROM (VALUES ('width', '{width}'::text[]), ('lane_count', '{lane_count}'), ('direction', '{sens}'),
            ('speed', '{speed}'), ('importance', '{importance}'), ('name', '{name}'), ('ref', '{ref}'),
            ('level', '{level}'),
            ('class', '{class}'), ('roundabout_tag', '{class}'), ('kind_forward', '{bus,cycle,cycle_right,cycle_left}'),
            ('kind_backward', '{bus,cycle,cycle_right,cycle_left}'), ('access', '{access}')) c(name, wants)
        WHERE jsonb_strip_nulls(found) ?| wants), streetgen._driving_side(model)));
    DROP TABLE pg_temp._import_line;
END $$;
COMMENT ON FUNCTION streetgen.import_bdtopo(name, regclass) IS
    'Imports a BD TOPO road table, version 2 or 3 by its column names: width, lanes, direction, speed, importance, '
    'position against the ground, nature, street name, number of the route, bus and cycle lanes. Fictitious axes are '
    'left out and counted; a width, speed or number of lanes that means nothing is unknown, and reported. A table '
    'that is no BD TOPO, or bad rows: 22023; then the model stays as it was.';
