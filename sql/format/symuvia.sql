-- The network of SymuVia (reseau.xsd 2.05), with the smallest scenario that runs on it.

CREATE OR REPLACE FUNCTION streetgen._symuvia_vehicle()
    RETURNS TABLE(kind text, vehicle text, speed numeric, wave numeric, density numeric)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 4 SET search_path = pg_catalog
    AS $$ VALUES
    ('general', 'VL', 25, -5.88, 0.17), ('bus', 'BUS', 14, -5.88, 0.08),
    ('carpool', 'COVOITURAGE', 25, -5.88, 0.17), ('cycle', 'VELO', 5, -2.5, 0.4) $$;
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

CREATE OR REPLACE FUNCTION streetgen._symuvia_elements(model name, options jsonb)
    RETURNS TABLE(rank integer, ref bigint, markup text)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10000 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY WITH written_edge AS MATERIALIZED (SELECT * FROM edge
        WHERE edge_id IN (SELECT streetgen._written_edges(model, options))),
    origin AS MATERIALIZED (SELECT * FROM streetgen._export_origin(model, options)),
    place AS MATERIALIZED (
        SELECT node_id, place_id, kind FROM streetgen._places(model, options)),
    way AS MATERIALIZED (SELECT * FROM streetgen._connecting_ways(model, options)),
    -- A lane has number 1 at the right, on whichever side one drives.
    troncon AS MATERIALIZED (
        SELECT lane_group_id, streetgen._lane_group_text(edge_id, along_axis, number) AS name, edge_id, along_axis,
            g.from_node, g.to_node, f.place_id AS from_place, t.place_id AS to_place, g.lane_count,
            g.width / g.lane_count AS lane_width,
            ST_Simplify(streetgen._at_least_long(g.geom, 2 * 0.1 ^ digits), tolerance, true) AS line,
            CASE s.value WHEN 'left' THEN ARRAY(SELECT l FROM unnest(lanes) WITH ORDINALITY u(l, i) ORDER BY i DESC)
                ELSE lanes END AS lanes
        FROM origin, setting s, lane_group g JOIN written_edge USING (edge_id)
            JOIN place f ON f.node_id = g.from_node JOIN place t ON t.node_id = g.to_node
        WHERE s.name = 'driving_side'),
    in_group AS MATERIALIZED (
        SELECT name, lane_id, along_axis, i, edge_id, kind, lane_position, to_place
        FROM troncon, streetgen._few(lanes) WITH ORDINALITY u(lane_id, i)
            JOIN (SELECT lane_id, kind, lane_position FROM lane) l USING (lane_id)),
    -- Whoever merges drives on the lane beside the merging one, which SymuVia does not know.
    placed AS MATERIALIZED (
        TABLE in_group
        UNION ALL SELECT b.name, m.lane_id, b.along_axis, b.i, b.edge_id, b.kind, b.lane_position, b.to_place
        FROM lane m, LATERAL (SELECT * FROM in_group g WHERE (g.edge_id, g.along_axis) = (m.edge_id, m.along_axis)
            ORDER BY abs(g.lane_position - m.lane_position) LIMIT 1) b
        WHERE m.kind = 'merging' AND (m.start_abscissa IS NOT NULL OR m.end_abscissa IS NOT NULL)),
    step AS MATERIALIZED (
        SELECT a.to_place AS place_id, k.way_id, a.name AS name_in, a.i AS lane_in, b.name AS name_out, b.i AS lane_out,
            ST_Simplify(k.geom, tolerance, true) AS line,
            coalesce(m.kind, '') AS sign,
            -- A movement is for all whom its lanes let in, but for those whom it bars.
            CASE WHEN k.traffic IS NOT NULL AND 'general' IN (a.kind, b.kind) THEN (SELECT string_agg(v.vehicle, ' ')
                FROM streetgen._symuvia_vehicle() v WHERE v.kind <> ALL (string_to_array(k.traffic, '|'))) END AS barred
        FROM origin, way k JOIN placed a ON (a.lane_id, a.along_axis) = (k.lane_in, k.along_in)
            JOIN placed b ON (b.lane_id, b.along_axis) = (k.lane_out, k.along_out)
            LEFT JOIN marking m ON (m.edge_id, m.lane_position, m.along_axis)
                = (a.edge_id, a.lane_position, a.along_axis) AND m.kind IN ('stop', 'yield')
                -- Lights say who goes first.
                AND a.to_place NOT IN (SELECT place_id FROM place WHERE kind = 'signals')),
    -- In the order of traffic; the table runs counter-clockwise.
    ring_edge AS MATERIALIZED (
        SELECT r.roundabout_id AS ring, r.centre, g.name, g.from_node, from_place, to_place, g.line, g.lane_count,
            g.lane_width,
            w.speed, keeps_right, CASE WHEN keeps_right THEN r.ordinality ELSE -r.ordinality END AS turn,
            count(*) OVER (PARTITION BY r.roundabout_id) AS edges
        FROM (SELECT value <> 'left' AS keeps_right FROM setting WHERE name = 'driving_side') s
            CROSS JOIN streetgen._ring_edges(model) r
            LEFT JOIN troncon g ON g.edge_id = r.edge_id AND g.along_axis = r.along_axis
            LEFT JOIN written_edge w ON w.edge_id = r.edge_id
        WHERE r.edge_id NOT IN (SELECT streetgen._edges_inside(options))),
    at_ring AS MATERIALIZED (
        SELECT n.ring, t.name, t.edge_id, n.from_place AS place_id, n.from_node, n.turn, leaves, n.centre,
            n.keeps_right, CASE WHEN leaves THEN t.from_node ELSE t.to_node END AS node_id,
            CASE WHEN leaves THEN ST_StartPoint(t.line) ELSE ST_EndPoint(t.line) END AS ends
        FROM ring_edge n JOIN troncon t ON n.from_place IN (t.from_place, t.to_place),
            LATERAL (SELECT t.from_place = n.from_place AS leaves) l
        WHERE NOT EXISTS (SELECT FROM ring_edge e WHERE e.ring = n.ring AND e.name = t.name)),
    -- One lane group for each edge; all else at its nodes are arms, and none of these is of another ring or has
    -- signals.
    whole_ring AS MATERIALIZED (
        SELECT ring, min(from_place) AS ring_place FROM ring_edge e GROUP BY ring, edges
        HAVING count(DISTINCT name) = edges AND count(DISTINCT from_place) = edges
            AND count(DISTINCT to_place) = edges
            AND NOT EXISTS (SELECT FROM ring_edge n JOIN place p ON p.place_id = n.from_place
                WHERE n.ring = e.ring AND p.kind = 'signals')
            AND EXISTS (SELECT FROM at_ring a WHERE a.ring = e.ring)
            AND NOT EXISTS (SELECT FROM at_ring a WHERE a.ring = e.ring AND (a.name IN (SELECT name FROM ring_edge)
                OR NOT EXISTS (SELECT FROM streetgen._ring_arms(model) m WHERE (m.roundabout_id, m.edge_id, m.node_id)
                    = (a.ring, a.edge_id, a.node_id))))),
    -- Round the centre from each node on, as traffic meets them.
    ring_end AS MATERIALIZED (
        SELECT ring, name, place_id, row_number() OVER (PARTITION BY ring ORDER BY a.turn,
            mod((degrees(ST_Azimuth(centre, n.geom) - ST_Azimuth(centre, ends))::numeric + 900) * CASE WHEN keeps_right
                THEN 1 ELSE -1 END + 1800, 360), NOT leaves, name COLLATE "C") AS turn
        FROM at_ring a JOIN whole_ring USING (ring) JOIN node n ON n.node_id = a.from_node),
    -- Edges between which there is no arm are one piece; the first one begins at an arm.
    ring_troncon AS MATERIALIZED (
        SELECT *, sum(begins) OVER (PARTITION BY ring ORDER BY step) AS piece
        FROM (SELECT *, mod(turn - min(turn) FILTER (WHERE begins = 1) OVER (PARTITION BY ring) + edges, edges) AS step
            FROM (SELECT e.*, ring_place, EXISTS (SELECT FROM ring_end a WHERE (a.ring, a.place_id)
                    = (e.ring, e.from_place))::integer AS begins FROM ring_edge e JOIN whole_ring USING (ring)) e) e),
    ring_place AS MATERIALIZED (SELECT from_place AS place_id, ring_place FROM ring_troncon),
    -- From the lanes that come in, round the ring, to those that leave it; by movements that bar nobody.
    ring_movement AS MATERIALIZED (
        WITH RECURSIVE round AS (
            SELECT ring_place, s.name_in, s.lane_in, s.name_out, s.lane_out, s.sign
            FROM step s JOIN ring_place USING (place_id)
            WHERE s.name_in NOT IN (SELECT name FROM ring_troncon) AND s.barred IS NULL
            UNION SELECT r.ring_place, r.name_in, r.lane_in, s.name_out, s.lane_out, r.sign
            FROM round r JOIN ring_troncon t ON t.name = r.name_out
                JOIN step s ON (s.name_in, s.lane_in) = (r.name_out, r.lane_out) AND s.barred IS NULL)
        SELECT ring_place AS place_id,
            row_number() OVER (ORDER BY name_in COLLATE "C", lane_in, name_out COLLATE "C", lane_out) AS way_id,
            name_in, lane_in, name_out, lane_out, NULL::geometry AS line, sign, NULL::text AS barred
        FROM round WHERE name_out NOT IN (SELECT name FROM ring_troncon)),
    ring_piece AS (
        SELECT ring, piece, (array_agg(name ORDER BY step))[1] AS name,
            ST_RemoveRepeatedPoints(ST_MakeLine(line ORDER BY step)) AS line,
            (array_agg(from_place ORDER BY step))[1] AS from_place,
            (array_agg(to_place ORDER BY step DESC))[1] AS to_place
        FROM ring_troncon GROUP BY ring, piece),
    ring_inside AS (
        SELECT p.ring, xmlagg(xmlelement(name "TRONCON_INTERNE", xmlattributes(p.name AS id, a.name AS troncon_amont,
            b.name AS troncon_aval, round(ST_Length(line)::numeric, 2) AS longueur,
            streetgen._symuvia_place(ST_StartPoint(line), x, y, digits) AS extremite_amont,
            streetgen._symuvia_place(ST_EndPoint(line), x, y, digits) AS extremite_aval),
            streetgen._symuvia_points(line, x, y, digits)::xml) ORDER BY p.piece) AS inside
        FROM origin, ring_piece p
            JOIN (SELECT DISTINCT ON (ring, place_id) * FROM ring_end ORDER BY ring, place_id, turn DESC) a
                ON (a.ring, a.place_id) = (p.ring, p.from_place)
            JOIN (SELECT DISTINCT ON (ring, place_id) * FROM ring_end ORDER BY ring, place_id, turn) b
                ON (b.ring, b.place_id) = (p.ring, p.to_place)
        GROUP BY p.ring),
    ring_element AS (
        SELECT r.*, e.troncons, i.inside
        FROM (SELECT ring, ring_place AS place_id, 'G_' || ring AS name, max(lane_count) AS lanes,
                avg(lane_width ORDER BY step) AS lane_width, min(speed) AS speed
                FROM ring_troncon GROUP BY ring, ring_place) r
            JOIN (SELECT ring, string_agg(name, ' ' ORDER BY turn) AS troncons FROM ring_end GROUP BY ring) e
                USING (ring)
            JOIN ring_inside i USING (ring)),
    movement AS MATERIALIZED (
        SELECT * FROM step WHERE place_id NOT IN (SELECT place_id FROM ring_place)
        UNION ALL SELECT * FROM ring_movement),
    -- Where traffic goes through: a ring is a giratoire; between two edges there is a repartiteur, among more a
    -- carrefour.
    connexion AS MATERIALIZED (
        SELECT place_id, CASE WHEN count(*) > 2 THEN 'C_' ELSE 'R_' END || place_id AS name,
            CASE WHEN count(*) > 2 THEN 'carrefour' ELSE 'repartiteur' END AS kind
        FROM (SELECT from_node FROM written_edge UNION ALL SELECT to_node FROM written_edge) e(node_id)
            JOIN place USING (node_id)
        WHERE place_id IN (SELECT place_id FROM movement) AND place_id NOT IN (SELECT place_id FROM ring_place)
        GROUP BY place_id
        UNION ALL SELECT place_id, name, 'giratoire' FROM ring_element),
    -- Where a troncon has no movement, traffic comes into the network or leaves it.
    ended AS MATERIALIZED (
        SELECT t.*, CASE WHEN i.name IS NULL THEN 'E_' || t.name ELSE a.name END AS amont,
            CASE WHEN o.name IS NULL THEN 'S_' || t.name ELSE b.name END AS aval
        FROM troncon t LEFT JOIN ring_place f ON f.place_id = from_place
        LEFT JOIN ring_place l ON l.place_id = to_place
        LEFT JOIN connexion a ON a.place_id = coalesce(f.ring_place, from_place)
        LEFT JOIN connexion b ON b.place_id = coalesce(l.ring_place, to_place)
        LEFT JOIN (SELECT DISTINCT name_out AS name FROM movement) i ON i.name = t.name
        LEFT JOIN (SELECT DISTINCT name_in AS name FROM movement) o ON o.name = t.name
        WHERE t.name NOT IN (SELECT name FROM ring_troncon)),
    -- The signals of a model that computes them.
    link AS MATERIALIZED (
        SELECT l.* FROM (SELECT array_agg(a.to_place) AS places, array_agg(lane_in) AS lanes_in,
                array_agg(lane_out) AS lanes_out, array_agg(along_in) AS along_in, array_agg(along_out) AS along_out,
                array_agg(a.name) AS names_in, array_agg(a.i) AS indexes_in, array_agg(b.name) AS names_out,
                array_agg(b.i) AS indexes_out
            FROM way k JOIN placed a ON (a.lane_id, a.along_axis) = (k.lane_in, k.along_in)
                JOIN placed b ON (b.lane_id, b.along_axis) = (k.lane_out, k.along_out)
            WHERE a.to_place IN (SELECT place_id FROM place WHERE kind = 'signals')) w,
            streetgen._signal_links(model, options, places, lanes_in, lanes_out, along_in, along_out, names_in,
                indexes_in, names_out, indexes_out) l),
    controlled AS (SELECT DISTINCT place_id, 'F_' || controller_id AS controller FROM link),
    -- What is left of a second in one state is shown in the next one, so that the cycle lasts as long.
    whole_state AS (
        SELECT controller_id, coalesce(green, 0) AS green, kind,
            (round(ends::numeric) - round((ends - duration)::numeric))::integer AS seconds
        FROM (SELECT *, sum(duration) OVER (PARTITION BY controller_id ORDER BY ordinality) AS ends
            FROM streetgen._signal_states(model)) s
        WHERE controller_id IN (SELECT controller_id FROM link)),
    signal_sequence AS MATERIALIZED (
        SELECT controller_id, green, sum(seconds) AS seconds,
            coalesce(sum(seconds) FILTER (WHERE kind = 'green'), 0) AS shown,
            coalesce(sum(seconds) FILTER (WHERE kind = 'amber'), 0) AS amber
        FROM whole_state GROUP BY controller_id, green HAVING sum(seconds) > 0),
    -- Troncons are what SymuVia gives green to. A sequence has a signal, if it were one that stays red.
    signal_shown AS (
        SELECT s.controller_id, s.green, name_in, name_out, bool_or(k.open) AS open,
            bool_or(k.open OR s.green = ANY (k.greens)) AS serves,
            row_number() OVER (PARTITION BY s.controller_id, s.green
                ORDER BY bool_or(k.open OR s.green = ANY (k.greens)) DESC, name_in COLLATE "C", name_out COLLATE "C")
                    AS turn
        FROM signal_sequence s JOIN link k USING (controller_id)
        GROUP BY s.controller_id, s.green, name_in, name_out),
    sequence_line AS (
        SELECT s.controller_id, s.green, xmlelement(name "SEQUENCE", xmlattributes(s.seconds AS duree_totale),
            xmlelement(name "SIGNAUX_ACTIFS", xmlagg(xmlelement(name "SIGNAL_ACTIF", xmlattributes(
                0 AS duree_retard_allumage,
                CASE WHEN open THEN seconds WHEN serves THEN shown ELSE 0 END AS duree_vert,
                CASE WHEN serves AND NOT open THEN amber ELSE 0 END AS duree_orange, name_in AS troncon_entree,
                name_out AS troncon_sortie)) ORDER BY g.turn))) AS element
        FROM signal_sequence s JOIN signal_shown g USING (controller_id, green)
        WHERE serves OR turn = 1 GROUP BY s.controller_id, s.green, s.seconds),
    controller_line AS (
        SELECT 1 AS turn, c.controller_id AS id, xmlelement(name "CONTROLEUR_DE_FEUX", xmlattributes(
            'F_' || c.controller_id AS id, 1 AS duree_vert_min, 1 AS duree_rouge_degagement), xmlelement(
            name "PLANS_DE_FEUX", xmlelement(name "PLAN_DE_FEUX", xmlattributes('P_' || c.controller_id AS id,
                -- A cycle before the simulation begins, and later by the offset.
                CASE WHEN round(start_offset) > 0 THEN (time '07:00' + (mod(start_offset::numeric, cycle::numeric)
                    - cycle::numeric)::integer * interval '1 second')::text END AS debut),
                xmlelement(name "SEQUENCES", xmlagg(s.element ORDER BY green))))) AS element
        FROM sequence_line s JOIN streetgen._signal_controllers(model) c USING (controller_id)
        GROUP BY c.controller_id, c.start_offset, c.cycle),
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
            streetgen._xml_text(name) AS nom_axe))::text, 3), -2) AS named FROM axis) a USING (axis_id)
        LEFT JOIN reserved r ON r.name = t.name
        LEFT JOIN (SELECT name AS opposed FROM ended) o
            ON opposed = CASE WHEN t.along_axis THEN '-' ELSE '' END || t.edge_id),
    -- Movements are written as text: their names need no escape, and each level of xmlagg would copy what lies within.
    allowed AS (
        SELECT place_id, '<MOUVEMENTS_AUTORISES>' || string_agg('<MOUVEMENT_AUTORISE id_troncon_amont="' || name_in
            || '" num_voie_amont="' || lane_in || '"><MOUVEMENT_SORTIES>' || ways
            || '</MOUVEMENT_SORTIES></MOUVEMENT_AUTORISE>', '' ORDER BY name_in COLLATE "C", lane_in)
            || '</MOUVEMENTS_AUTORISES>' AS text
        FROM (SELECT place_id, name_in, lane_in, string_agg('<MOUVEMENT_SORTIE id_troncon_aval="' || name_out
                || '" num_voie_aval="' || lane_out || '" taux_utilisation="' || round(1.0 / ways, 4)
                || coalesce('" exclusion_types_vehicules="' || barred, '') || '"/>', ''
                ORDER BY way_id, name_out COLLATE "C", lane_out) AS ways
            FROM (SELECT *, count(*) OVER (PARTITION BY place_id, name_in, lane_in, name_out, barred) AS ways
                FROM movement) m
            GROUP BY place_id, name_in, lane_in) m GROUP BY place_id),
    entered AS (
        SELECT place_id, '<ENTREES_CAF>' || string_agg('<ENTREE_CAF id_troncon_amont="' || name_in
            || '" num_voie_amont="'
            || lane_in || '" priorite="' || CASE sign WHEN 'stop' THEN 'stop' WHEN 'yield' THEN 'cedez_le_passage'
                ELSE 'defaut' END || '"><MOUVEMENTS>' || ways || '</MOUVEMENTS></ENTREE_CAF>', ''
            ORDER BY name_in COLLATE "C", lane_in) || '</ENTREES_CAF>' AS text
        FROM (SELECT place_id, name_in, lane_in, max(sign) AS sign, string_agg('<MOUVEMENT id_troncon_aval="'
            || name_out
                || '" num_voie_aval="' || lane_out || coalesce('">' || streetgen._symuvia_points(line, x, y, digits)
                || '</MOUVEMENT>', '"/>'), '' ORDER BY way_id, name_out COLLATE "C", lane_out) AS ways
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
            || coalesce(' controleur_de_feux="' || controller || '"', '') || '>' || a.text || c.text
                || '</CARREFOURAFEUX>'
        FROM connexion JOIN allowed a USING (place_id) JOIN entered c USING (place_id)
            LEFT JOIN controlled USING (place_id))
    SELECT 3, id, element || CASE content WHEN '' THEN '/>' ELSE '>' || content || '</TRONCON>' END
    FROM troncon_line
    UNION ALL TABLE connexion_line UNION ALL SELECT turn, id, element::text FROM controller_line UNION ALL
    VALUES (2, 0, '</CONTROLEURS_DE_FEUX></TRAFIC></TRAFICS><RESEAUX><RESEAU id="reseau"><TRONCONS>'),
        (4, 0, '</TRONCONS><CONNEXIONS><EXTREMITES>'), (29, 0, '</EXTREMITES><REPARTITEURS>'),
        (34, 0, '</REPARTITEURS><GIRATOIRES>'), (39, 0, '</GIRATOIRES><CARREFOURSAFEUX>'),
        (49, 0, '</CARREFOURSAFEUX></CONNEXIONS></RESEAU></RESEAUX>');
END $$;
COMMENT ON FUNCTION streetgen._symuvia_elements(name, jsonb) IS
    'The elements of a file of SymuVia, by rank: controllers (1), troncons (3), ends of the network and the places '
    'with their movements (20 to 40). A ring of edges is a giratoire where it is accepted, each of its edges is '
    'written and has one lane group, no signals stand there, and it shares no node with another; the nodes of others '
    'are places like all.';

CREATE OR REPLACE FUNCTION streetgen.export_symuvia(model name, options jsonb DEFAULT '{}')
    RETURNS TABLE(ordinality bigint, line text)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 10000
    SET search_path = pg_catalog, public SET work_mem = '4MB'
    AS $$
DECLARE
    known constant jsonb := streetgen._begin_export(model, 'symuvia', 'interconnection', options);
    vehicles text;
BEGIN
    SELECT string_agg(xmlelement(name "TYPE_DE_VEHICULE", xmlattributes(v.vehicle AS id, v.wave AS w, v.density AS kx,
        v.speed AS vx))::text, '') INTO vehicles FROM streetgen._symuvia_vehicle() v;
    RETURN QUERY SELECT row_number() OVER (ORDER BY rank, ref, text), text
        FROM (SELECT rank, ref, ('    ' || markup) COLLATE "C" AS text
            FROM streetgen._symuvia_elements(model, known)
            UNION ALL SELECT rank, ref, markup COLLATE "C" FROM streetgen._xml_frame(
                '<ROOT_SYMUBRUIT version="2.05"><SIMULATIONS><SIMULATION id="simulation" pasdetemps="1" '
                'debut="07:00:00" fin="08:00:00" loipoursuite="exacte" comportementflux="iti" date="2000-01-01" '
                'titre="StreetGen"/></SIMULATIONS><TRAFICS><TRAFIC id="trafic" accbornee="true"><TYPES_DE_VEHICULE>'
                || vehicles || '</TYPES_DE_VEHICULE><CONTROLEURS_DE_FEUX>',
                '<SCENARIOS><SCENARIO id="scenario" simulation_id="simulation" trafic_id="trafic" reseau_id="reseau" '
                'prefout="streetgen"/></SCENARIOS></ROOT_SYMUBRUIT>')) l
        ORDER BY rank, ref, text;
END $$;
COMMENT ON FUNCTION streetgen.export_symuvia(name, jsonb) IS
    'A file of SymuVia (reseau.xsd 2.05), line by line. A TRONCON is a lane group, named edge_id along the axis and '
    '-edge_id against it, with lane 1 at the right; lanes of buses, carpools and bicycles are reserved, parking lanes '
    'closed. '
    'Interconnections that connect are its movements: at a REPARTITEUR between two edges, at a CARREFOURAFEUX among '
    'more, with priority by stop and yield lines where no signals are, and the points of the path. One for a part of '
    'the traffic of a general lane says whom it bars, but round a ring. With subject '
    'roundabout, an accepted ring is a GIRATOIRE with its edges inside, and what goes in and out are its movements; '
    'with subject signal, places of '
    'a controller name it, and its program is one of whole seconds. A troncon without movements at an end has '
    'an EXTREMITE there: E_name where traffic comes in, S_name where it leaves. Coordinates are counted from the whole '
    'metres at the lower left of what is written. Simulation, traffic and scenario are the smallest that are valid. '
    'options as streetgen.export_option() lists them: an unknown one, or no edge that they take: 22023. A caller who '
    'may not read the model: 42501; a model without interconnections, or junctions that are asked for: 55000. What is '
    'stale is written as it was, with a warning.';
