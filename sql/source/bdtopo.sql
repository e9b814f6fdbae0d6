-- BD TOPO of IGN to axes.

CREATE OR REPLACE FUNCTION streetgen._number(value text, low float8, high float8) RETURNS float8
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT CASE WHEN value ~ '^\s*[-+]?\d{1,15}(\.\d*)?\s*$' AND value::float8 BETWEEN low AND high
        THEN value::float8 END $$;
COMMENT ON FUNCTION streetgen._number(text, float8, float8) IS
    'A text as the number that it says, NULL where it says none within the bounds.';

CREATE OR REPLACE FUNCTION streetgen.import_bdtopo(model name, source regclass)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    -- Model column, then the source's names for it, V3 (as a table, as a shapefile) before V2.
    known constant jsonb :=
        '{"id": ["cleabs", "id", "ogc_fid", "gid", "fid"], "width": ["largeur_de_chaussee", "largeur"], '
        '"lane_count": ["nombre_de_voies", "nb_voies"],
        "sens": ["sens_de_circulation", "sens"], "speed": ["vitesse_moyenne_vl", "vit_moy_vl"],
        "importance": ["importance"],
        "level": ["position_par_rapport_au_sol", "pos_sol"],
        "class": ["nature"], "name": ["nom_voie_ban_gauche", "nom_collaboratif_gauche", "nom_1_gauche",
            "nom_coll_g", "nom_1_g", "nom_rue_g", "nom_voie_g"], "fictif": ["fictif"],
        "bus": ["reserve_aux_bus", "bus"], "cycle": ["bande_cyclable", "cyclable"]}';
    driving_side text;
    present text[] := (SELECT array_agg(attname::text ORDER BY attnum) FROM pg_attribute WHERE attrelid = source
        AND attnum > 0 AND NOT attisdropped);
    shape text := (SELECT attname FROM pg_attribute a JOIN pg_type t ON t.oid = a.atttypid WHERE attrelid = source
        AND t.typname = 'geometry' AND NOT attisdropped ORDER BY attnum LIMIT 1);
    found jsonb;
    query text;
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
    driving_side := streetgen._driving_side(model);
    query := format($sql$
SELECT %1$I AS geom, streetgen._number(s.width, 0, 200) AS width,
    streetgen._number(s.lane_count, 0, 30)::integer AS lane_count,
       direction,
       streetgen._number(s.speed, 0, 400) AS speed,
       CASE WHEN s.importance ~ '^\d' THEN substring(s.importance FROM '^\d')::integer END AS importance,
       s.name, CASE WHEN s.level ~ '^-?\d' THEN greatest(-50, least(50, substring(s.level FROM '^-?\d{1,3}')::integer))
           ELSE 0 END AS level,
       s.class, CASE s.class WHEN 'Rond-point' THEN s.class END AS roundabout_tag,
       streetgen.lane_kinds(forward, NULL, bus_forward, '%13$s', cycle_forward, false, false, false) AS kind_forward,
       streetgen.lane_kinds(backward, NULL, bus_backward, '%13$s', cycle_backward, false, false,
           false) AS kind_backward,
       s.id AS source_ref, coalesce(s.id, 'number ' || row_number() OVER ()) AS label,
           CASE WHEN s.fictif IN ('Oui', 'true', 't') THEN 'fictitious axis' END AS left_out,
       array_remove(ARRAY[CASE WHEN s.width <> '' AND streetgen._number(s.width, 0, 200) IS NULL THEN 'width' END,
                          CASE WHEN s.lane_count <> '' AND streetgen._number(s.lane_count, 0, 30) IS NULL
                              THEN 'lane_count' END,
                          CASE WHEN s.sens <> '' AND s.sens !~* 'double|direct|inverse|^sens unique$|^sans objet$|^nc$'
                              THEN 'direction' END,
                          CASE WHEN s.speed <> '' AND streetgen._number(s.speed, 0, 400) IS NULL THEN 'speed' END],
                              NULL) AS unread
FROM (SELECT %1$I, %2$s AS id, %3$s AS width, %4$s AS lane_count, %5$s AS sens, %6$s AS speed, %7$s AS importance,
    %8$s AS level, %9$s AS class, nullif(%10$s, '') AS name, %11$s AS fictif, %14$s AS bus, %15$s AS cycle
    FROM %12$s) s,
     LATERAL (SELECT CASE WHEN s.sens ILIKE '%%inverse%%' THEN 'reverse' WHEN s.sens ILIKE '%%direct%%'
         AND s.sens NOT ILIKE '%%double%%' OR s.sens ILIKE 'sens unique' THEN 'direct' ELSE 'both' END AS direction,
                     coalesce(greatest(streetgen._number(s.lane_count, 1, 30)::integer, 1), 1) AS lanes,
                     coalesce(s.bus ~* 'direct|deux|double|bidirectionnel', false) AS bus_forward,
                         coalesce(s.bus ~* 'inverse|deux|double|bidirectionnel', false) AS bus_backward,
                     coalesce(s.cycle ~* 'direct|deux|double|bidirectionnel', false) AS cycle_forward,
                         coalesce(s.cycle ~* 'inverse|deux|double|bidirectionnel', false) AS cycle_backward) d,
     -- A bus lane against a one-way street takes one of its lanes.
     -- One lane in all, unless buses have one of their own, is of both directions.
     LATERAL (SELECT direction = 'both' AND streetgen._number(s.lane_count, 0, 30) = 1 AND NOT bus_forward
         AND NOT bus_backward AS of_both) b,
     LATERAL (SELECT CASE direction WHEN 'both' THEN CASE WHEN of_both THEN 0 ELSE (lanes + 1) / 2 END WHEN 'direct'
         THEN CASE WHEN bus_backward THEN greatest(lanes - 1, 1) ELSE lanes END ELSE 0 END AS forward,
                     CASE direction WHEN 'both' THEN CASE WHEN of_both THEN 0 ELSE greatest(lanes / 2, 1)
                         END WHEN 'reverse' THEN CASE WHEN bus_forward THEN greatest(lanes - 1, 1) ELSE lanes
                         END ELSE 0 END AS backward) n$sql$, shape, coalesce(found ->> 'id', 'NULL::text'),
                         coalesce(found ->> 'width', 'NULL::text'), coalesce(found ->> 'lane_count', 'NULL::text'),
        coalesce(found ->> 'sens', 'NULL::text'), coalesce(found ->> 'speed', 'NULL::text'),
            coalesce(found ->> 'importance', 'NULL::text'), coalesce(found ->> 'level', 'NULL::text'),
        found ->> 'class', coalesce(found ->> 'name', 'NULL::text'), coalesce(found ->> 'fictif', 'NULL::text'), source,
        driving_side, coalesce(found ->> 'bus', 'NULL::text'), coalesce(found ->> 'cycle', 'NULL::text'));
    -- What the table has no column for it does not mention.
    RETURN QUERY SELECT * FROM streetgen._import(model, source::text, format('SELECT geom, %s, source_ref, label, '
        'left_out, unread FROM (%s) q', (SELECT string_agg(name, ', ') FROM (VALUES ('width', '{width}'::text[]),
        ('lane_count', '{lane_count}'), ('direction', '{sens}'), ('speed', '{speed}'), ('importance', '{importance}'),
        ('name', '{name}'), ('level', '{level}'), ('class', '{class}'), ('roundabout_tag', '{class}'),
        ('kind_forward', '{bus,cycle}'), ('kind_backward', '{bus,cycle}')) c(name, wants)
        WHERE jsonb_strip_nulls(found) ?| wants), query));
END $$;
COMMENT ON FUNCTION streetgen.import_bdtopo(name, regclass) IS
    'Imports a BD TOPO road table, version 2 or 3 by its column names: width, lanes, direction, speed, importance, '
    'position against the ground, nature, street name, bus and cycle lanes. Fictitious axes are left out and counted; '
    'a width, speed or number of lanes that means nothing is unknown, and reported. A table that is no BD TOPO, or '
    'bad rows: 22023; then the model stays as it was.';
