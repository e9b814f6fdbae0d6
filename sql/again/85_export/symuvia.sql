-- The network of SymuVia (reseau.xsd 2.05), with the smallest scenario that runs on it.

CREATE OR REPLACE FUNCTION streetgen._symuvia_vehicle()
    RETURNS TABLE(kind text, vehicle text, speed numeric, wave numeric, density numeric)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 3 SET search_path = pg_catalog
    AS $$ VALUES
    ('general', 'VL', 25, -5.88, 0.17), ('bus', 'BUS', 14, -5.88, 0.08), ('cycle', 'VELO', 5, -2.5, 0.4) $$;
COMMENT ON FUNCTION streetgen._symuvia_vehicle() IS
    'The vehicles of a written scenario, each by the kind of the lanes that are its own: free speed (m/s), speed of '
    'the wave (m/s) and greatest density (vehicles a metre) of the triangular fundamental diagram.';

-- Functions of each value that is written: bound when made, and thus inlined.
CREATE OR REPLACE FUNCTION streetgen._symuvia_place(place geometry, x float8, y float8, digits integer) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN translate(substr(ST_AsText(ST_Translate(place, -x, -y), digits), 7), ')', '');
COMMENT ON FUNCTION streetgen._symuvia_place(geometry, float8, float8, integer) IS
    'A POINT as SymuVia writes it, from an origin.';

CREATE OR REPLACE FUNCTION streetgen._symuvia_points(line geometry, x float8, y float8, digits integer) RETURNS text
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20 AS 'MODULE_PATHNAME', 'streetgen_symuvia_points';
COMMENT ON FUNCTION streetgen._symuvia_points(geometry, float8, float8, integer) IS
    'The points of a line between its ends as SymuVia lists them, from an origin; NULL where there are none.';

CREATE OR REPLACE FUNCTION streetgen._symuvia_network(rings boolean) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT $part$,
-- A lane has number 1 at the right, on whichever side one drives.
troncon AS MATERIALIZED (
    SELECT lane_group_id, streetgen._lane_group_text(edge_id, along_axis, number) AS name, edge_id, along_axis,
        g.from_node, g.to_node, f.place_id AS from_place, t.place_id AS to_place, g.lane_count,
        g.width / g.lane_count AS lane_width,
        ST_Simplify(streetgen._at_least_long(g.geom, 2 * 0.1 ^ digits), tolerance, true) AS line,
        CASE s.value WHEN 'left' THEN ARRAY(SELECT l FROM unnest(lanes) WITH ORDINALITY u(l, i) ORDER BY i DESC)
            ELSE lanes END AS lanes
    FROM origin, %1$I.setting s, %1$I.lane_group g JOIN written_edge USING (edge_id)
        JOIN place f ON f.node_id = g.from_node JOIN place t ON t.node_id = g.to_node
    WHERE s.name = 'driving_side'),
in_group AS MATERIALIZED (
    SELECT name, lane_id, along_axis, i, edge_id, kind, lane_position, to_place
    FROM troncon, streetgen._few(lanes) WITH ORDINALITY u(lane_id, i)
        JOIN (SELECT lane_id, kind, lane_position FROM %1$I.lane) l USING (lane_id)),
-- Whoever merges drives on the lane beside the merging one, which SymuVia does not know.
placed AS MATERIALIZED (
    TABLE in_group
    UNION ALL SELECT b.name, m.lane_id, b.along_axis, b.i, b.edge_id, b.kind, b.lane_position, b.to_place
    FROM %1$I.lane m, LATERAL (SELECT * FROM in_group g WHERE (g.edge_id, g.along_axis) = (m.edge_id, m.along_axis)
        ORDER BY abs(g.lane_position - m.lane_position) LIMIT 1) b
    WHERE m.kind = 'merging' AND (m.start_abscissa IS NOT NULL OR m.end_abscissa IS NOT NULL)),
step AS MATERIALIZED (
    SELECT a.to_place AS place_id, k.way_id, a.name AS name_in, a.i AS lane_in, b.name AS name_out, b.i AS lane_out,
        ST_Simplify(k.geom, tolerance, true) AS line,
        coalesce(m.kind, '') AS sign
    FROM origin, way k JOIN placed a ON (a.lane_id, a.along_axis) = (k.lane_in, k.along_in)
        JOIN placed b ON (b.lane_id, b.along_axis) = (k.lane_out, k.along_out)
        LEFT JOIN %1$I.marking m ON (m.edge_id, m.lane_position, m.along_axis)
            = (a.edge_id, a.lane_position, a.along_axis) AND m.kind IN ('stop', 'yield')
            -- Lights say who goes first.
            AND a.to_place NOT IN (SELECT place_id FROM place WHERE kind = 'signals'))$part$
    || streetgen._symuvia_rings(rings) || $part$,
movement AS MATERIALIZED (
    SELECT * FROM step WHERE place_id NOT IN (SELECT node_id FROM ring_node) UNION ALL SELECT * FROM ring_movement),
-- Where traffic goes through: a ring is a giratoire; between two edges there is a repartiteur, among more a carrefour.
connexion AS MATERIALIZED (
    SELECT place_id, CASE WHEN count(*) > 2 THEN 'C_' ELSE 'R_' END || place_id AS name,
        CASE WHEN count(*) > 2 THEN 'carrefour' ELSE 'repartiteur' END AS kind
    FROM (SELECT from_node FROM written_edge UNION ALL SELECT to_node FROM written_edge) e(node_id)
        JOIN place USING (node_id)
    WHERE place_id IN (SELECT place_id FROM movement) AND node_id NOT IN (SELECT node_id FROM ring_node)
    GROUP BY place_id
    UNION ALL SELECT place_id, name, 'giratoire' FROM ring_element),
-- Where a troncon has no movement, traffic comes into the network or leaves it.
ended AS MATERIALIZED (
    SELECT t.*, CASE WHEN i.name IS NULL THEN 'E_' || t.name ELSE a.name END AS amont,
        CASE WHEN o.name IS NULL THEN 'S_' || t.name ELSE b.name END AS aval
    FROM troncon t LEFT JOIN ring_node f ON f.node_id = from_node LEFT JOIN ring_node l ON l.node_id = to_node
    LEFT JOIN connexion a ON a.place_id = coalesce(f.place_id, from_place)
    LEFT JOIN connexion b ON b.place_id = coalesce(l.place_id, to_place)
    LEFT JOIN (SELECT DISTINCT name_out AS name FROM movement) i ON i.name = t.name
    LEFT JOIN (SELECT DISTINCT name_in AS name FROM movement) o ON o.name = t.name
    WHERE t.name NOT IN (SELECT name FROM ring_troncon))$part$ $$;
COMMENT ON FUNCTION streetgen._symuvia_network(boolean) IS
    'Queries of the network of SymuVia over a model: placed, its lanes with troncon and number; step, its ways from '
    'lane to lane; the rings of one that computes roundabouts; movement, the ways through connections; connexion, the '
    'places that they lie at; ended, the lane groups outside of rings with what they end at.';

CREATE OR REPLACE FUNCTION streetgen._symuvia_troncon() RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT $part$,
-- Lanes that are not for all: those of one vehicle, and those of none.
reserved AS (
    SELECT name, CASE WHEN count(vehicle) > 0 THEN xmlelement(name "VOIES_RESERVEES", xmlagg(xmlelement(
            name "VOIE_RESERVEE", xmlattributes(i AS num_voie, vehicle AS id_typesvehicules)) ORDER BY i)
            FILTER (WHERE vehicle IS NOT NULL)) END AS one,
        CASE WHEN count(*) > count(vehicle) THEN xmlelement(name "VOIES_INTERDITES", xmlagg(xmlelement(
            name "VOIE_INTERDITE", xmlattributes(i AS num_voie, every AS id_typesvehicules)) ORDER BY i)
            FILTER (WHERE vehicle IS NULL)) END AS none
    FROM placed LEFT JOIN streetgen._symuvia_vehicle() USING (kind),
        (SELECT string_agg(vehicle, ' ') FROM streetgen._symuvia_vehicle()) v(every)
    WHERE kind <> 'general' GROUP BY name),
troncon_line AS (
    SELECT t.lane_group_id AS id, concat('<TRONCON id="', t.name, '" id_eltamont="', amont, '" id_eltaval="', aval,
        '" extremite_amont="', streetgen._symuvia_place(ST_StartPoint(line), x, y, digits), '" extremite_aval="',
        streetgen._symuvia_place(ST_EndPoint(line), x, y, digits), '" nb_voie="', t.lane_count, '" largeur_voie="',
        round(greatest(lane_width, 0.001)::numeric, 3), '" vit_reg="', round(e.speed::numeric / 3.6, 4),
        '" longueur="', round(ST_Length(line)::numeric, 2), '"', named, ' id_troncon_oppose="' || opposed || '"')
        AS element,
        concat(streetgen._symuvia_points(line, x, y, digits), one, none) AS content
    FROM origin, ended t JOIN (SELECT edge_id, axis_id, level, speed FROM written_edge) e USING (edge_id)
    -- Words of users are escaped: of <a nom_axe="…"/> what stands between the name and the end.
    LEFT JOIN (SELECT axis_id, left(substr(xmlelement(name a, xmlattributes(
        streetgen._xml_text(name) AS nom_axe))::text, 3), -2) AS named FROM %1$I.axis) a USING (axis_id)
    LEFT JOIN reserved r ON r.name = t.name
    LEFT JOIN (SELECT name AS opposed FROM ended) o
        ON opposed = CASE WHEN t.along_axis THEN '-' ELSE '' END || t.edge_id)$part$ $$;
COMMENT ON FUNCTION streetgen._symuvia_troncon() IS
    'Queries of the network of SymuVia, after streetgen._symuvia_network(): troncon_line, its troncons.';

CREATE OR REPLACE FUNCTION streetgen._symuvia_connexion() RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT $part$,
-- Movements are written as text: their names need no escape, and each level of xmlagg would copy what lies within.
allowed AS (
    SELECT place_id, '<MOUVEMENTS_AUTORISES>' || string_agg('<MOUVEMENT_AUTORISE id_troncon_amont="' || name_in
        || '" num_voie_amont="' || lane_in || '"><MOUVEMENT_SORTIES>' || ways
        || '</MOUVEMENT_SORTIES></MOUVEMENT_AUTORISE>', '' ORDER BY name_in COLLATE "C", lane_in)
        || '</MOUVEMENTS_AUTORISES>' AS text
    FROM (SELECT place_id, name_in, lane_in, string_agg('<MOUVEMENT_SORTIE id_troncon_aval="' || name_out
            || '" num_voie_aval="' || lane_out || '" taux_utilisation="' || round(1.0 / ways, 4) || '"/>', ''
            ORDER BY way_id) AS ways
        FROM (SELECT *, count(*) OVER (PARTITION BY place_id, name_in, lane_in, name_out) AS ways FROM movement) m
        GROUP BY place_id, name_in, lane_in) m GROUP BY place_id),
entered AS (
    SELECT place_id, '<ENTREES_CAF>' || string_agg('<ENTREE_CAF id_troncon_amont="' || name_in || '" num_voie_amont="'
        || lane_in || '" priorite="' || CASE sign WHEN 'stop' THEN 'stop' WHEN 'yield' THEN 'cedez_le_passage'
            ELSE 'defaut' END || '"><MOUVEMENTS>' || ways || '</MOUVEMENTS></ENTREE_CAF>', ''
        ORDER BY name_in COLLATE "C", lane_in) || '</ENTREES_CAF>' AS text
    FROM (SELECT place_id, name_in, lane_in, max(sign) AS sign, string_agg('<MOUVEMENT id_troncon_aval="' || name_out
            || '" num_voie_aval="' || lane_out || coalesce('">' || streetgen._symuvia_points(line, x, y, digits)
            || '</MOUVEMENT>', '"/>'), '' ORDER BY way_id) AS ways
        FROM origin, movement JOIN connexion USING (place_id) WHERE connexion.kind = 'carrefour'
        GROUP BY place_id, name_in, lane_in) m GROUP BY place_id),
connexion_line AS (
    SELECT 20 AS turn, lane_group_id AS id, '<EXTREMITE id="' || v.name || '"/>' AS element
    FROM ended t, LATERAL (VALUES (amont, 'E_'), (aval, 'S_')) v(name, mark) WHERE v.name = mark || t.name
    UNION ALL
    SELECT 30, place_id, '<REPARTITEUR id="' || name || '"'
        || coalesce(' controleur_de_feux="' || controller || '"', '') || '>' || a.text || '</REPARTITEUR>'
    FROM connexion JOIN allowed a USING (place_id) LEFT JOIN controlled USING (place_id) WHERE kind = 'repartiteur'
    UNION ALL
    SELECT 35, place_id, xmlelement(name "GIRATOIRE", xmlattributes(name AS id, troncons, lanes AS nb_voie,
        round(greatest(lane_width, 0.001)::numeric, 3) AS "LargeurVoie", round(speed::numeric / 3.6, 4) AS vit_max),
        a.text::xml, xmlelement(name "TRONCONS_INTERNES", inside))::text
    FROM ring_element LEFT JOIN allowed a USING (place_id)
    UNION ALL
    SELECT 40, place_id, '<CARREFOURAFEUX id="' || name || '"'
        || coalesce(' controleur_de_feux="' || controller || '"', '') || '>' || a.text || c.text || '</CARREFOURAFEUX>'
    FROM connexion JOIN allowed a USING (place_id) JOIN entered c USING (place_id)
        LEFT JOIN controlled USING (place_id))$part$ $$;
COMMENT ON FUNCTION streetgen._symuvia_connexion() IS
    'Queries of the network of SymuVia, after streetgen._symuvia_network(): connexion_line, the ends of the network '
    'and the places with their movements, by turn 20 to 40.';

CREATE OR REPLACE FUNCTION streetgen.export_symuvia(model name, options jsonb DEFAULT '{}')
    RETURNS TABLE(ordinality bigint, line text)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 10000
    SET search_path = pg_catalog, public SET work_mem = '4MB'
    AS $$
DECLARE
    known constant jsonb := streetgen._begin_export(model, 'symuvia', 'interconnection', options);
    subjects constant text[] := streetgen._subjects(model);
    vehicles text;
BEGIN
    SELECT string_agg(xmlelement(name "TYPE_DE_VEHICULE", xmlattributes(v.vehicle AS id, v.wave AS w, v.density AS kx,
        v.speed AS vx))::text, '') INTO vehicles FROM streetgen._symuvia_vehicle() v;
    RETURN QUERY EXECUTE streetgen._export_lines(model, known,
        streetgen._symuvia_network('roundabout' = ANY (subjects)) || streetgen._symuvia_signals('signal'
            = ANY (subjects)) || streetgen._symuvia_troncon() || streetgen._symuvia_connexion() || $part$,
line AS (
    SELECT 3 AS turn, id, element || CASE content WHEN '' THEN '/>' ELSE '>' || content || '</TRONCON>' END AS element
    FROM troncon_line
    UNION ALL TABLE connexion_line UNION ALL SELECT turn, id, element::text FROM controller_line UNION ALL
    VALUES (2, 0, '</CONTROLEURS_DE_FEUX></TRAFIC></TRAFICS><RESEAUX><RESEAU id="reseau"><TRONCONS>'),
        (4, 0, '</TRONCONS><CONNEXIONS><EXTREMITES>'), (29, 0, '</EXTREMITES><REPARTITEURS>'),
        (34, 0, '</REPARTITEURS><GIRATOIRES>'), (39, 0, '</GIRATOIRES><CARREFOURSAFEUX>'),
        (49, 0, '</CARREFOURSAFEUX></CONNEXIONS></RESEAU></RESEAUX>'))$part$,
        '<ROOT_SYMUBRUIT version="2.05"><SIMULATIONS><SIMULATION id="simulation" pasdetemps="1" debut="07:00:00" '
        'fin="08:00:00" loipoursuite="exacte" comportementflux="iti" date="2000-01-01" titre="StreetGen"/>'
        '</SIMULATIONS><TRAFICS><TRAFIC id="trafic" accbornee="true"><TYPES_DE_VEHICULE>' || vehicles ||
        '</TYPES_DE_VEHICULE><CONTROLEURS_DE_FEUX>',
        '<SCENARIOS><SCENARIO id="scenario" simulation_id="simulation" trafic_id="trafic" reseau_id="reseau" '
        'prefout="streetgen"/></SCENARIOS></ROOT_SYMUBRUIT>') USING known;
END $$;
COMMENT ON FUNCTION streetgen.export_symuvia(name, jsonb) IS
    'A file of SymuVia (reseau.xsd 2.05), line by line. A TRONCON is a lane group, named edge_id along the axis and '
    '-edge_id against it, with lane 1 at the right; lanes of buses and bicycles are reserved, parking lanes closed. '
    'Interconnections that connect are its movements: at a REPARTITEUR between two edges, at a CARREFOURAFEUX among '
    'more, with priority by stop and yield lines where no signals are, and the points of the path. With subject '
    'roundabout, an accepted ring is a GIRATOIRE with its edges inside, and what goes in and out are its movements; '
    'with subject signal, places of '
    'a controller name it, and its program is one of whole seconds. A troncon without movements at an end has '
    'an EXTREMITE there: E_name where traffic comes in, S_name where it leaves. Coordinates are counted from the whole '
    'metres at the lower left of what is written. Simulation, traffic and scenario are the smallest that are valid. '
    'options as streetgen.export_option() lists them: an unknown one, or no edge that they take: 22023. A caller who '
    'may not read the model: 42501; a model without interconnections, or junctions that are asked for: 55000. What is '
    'stale is written as it was, with a warning.';
