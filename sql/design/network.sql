-- Stage links: which towns are linked, where links of a network meet, and what stays of the links before.

CREATE OR REPLACE FUNCTION streetgen._match_nearest() RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
BEGIN
    CREATE TEMPORARY TABLE _match ON COMMIT DROP AS SELECT * FROM pg_temp._near WHERE false;
    LOOP
        INSERT INTO pg_temp._match SELECT n.* FROM (SELECT DISTINCT ON (found) * FROM pg_temp._near
                ORDER BY found, apart, known) n
            JOIN (SELECT DISTINCT ON (known) * FROM pg_temp._near ORDER BY known, apart, found) k
                USING (found, known);
        EXIT WHEN NOT FOUND;
        DELETE FROM pg_temp._near n USING pg_temp._match m WHERE n.found = m.found OR n.known = m.known;
    END LOOP;
    DROP TABLE pg_temp._near;
END $$;
COMMENT ON FUNCTION streetgen._match_nearest() IS
    'Of pairs of what is found and what is known (temporary table _near: found, known, apart) keeps those that are '
    'nearest to each other, then those nearest among the rest, as temporary table _match.';

CREATE OR REPLACE FUNCTION streetgen._clear_links(model name, links bigint[]) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
DECLARE
    relation name;
BEGIN
    PERFORM streetgen._use_model(model);
    FOR relation IN SELECT t.relation FROM streetgen._design_table() t WHERE t.of_link LOOP
        EXECUTE format('DELETE FROM %I.%I WHERE design_link_id = ANY ($1) AND NOT by_hand', model, relation)
            USING links;
    END LOOP;
    DELETE FROM design_crossing WHERE other_link_id = ANY (links) AND NOT by_hand;
    UPDATE design_crossing SET abscissa = -1, other_abscissa = -1 WHERE abscissa >= 0
        AND (design_link_id = ANY (links) OR other_link_id = ANY (links));
    UPDATE design_link SET geom = NULL WHERE design_link_id = ANY (links);
    DELETE FROM design_input WHERE design_link_id = ANY (links);
END $$;
COMMENT ON FUNCTION streetgen._clear_links(name, bigint[]) IS
    'Takes away what was computed of links; rows by hand stay, and all stages are stale.';

CREATE OR REPLACE FUNCTION streetgen._find_town_links(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    srid constant integer := (SELECT m.srid FROM streetgen.model m WHERE m.name = model);
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE TEMPORARY TABLE _town ON COMMIT DROP AS
    SELECT design_node_id, row_number() OVER (ORDER BY design_node_id) - 1 AS nth, geom FROM design_node
        WHERE NOT rejected AND (by_hand OR kind <> 'interchange');
    CREATE TEMPORARY TABLE _link ON COMMIT DROP AS
    WITH given AS (SELECT l.*, a.nth AS a, b.nth AS b, streetgen._network_rank(network) - 1 AS rank
        FROM design_link l JOIN pg_temp._town a ON a.design_node_id = node_a JOIN pg_temp._town b
            ON b.design_node_id = node_b
        WHERE by_hand),
    linked AS (SELECT row_number() OVER () - 1 AS nth, t.* FROM streetgen._link_towns(streetgen._town_numbers(model),
        ARRAY(SELECT v FROM given, unnest(ARRAY[a, b, rank]::float8[]) WITH ORDINALITY u(v, k) WHERE NOT rejected
            ORDER BY design_link_id, k),
        ARRAY(SELECT v FROM given, unnest(ARRAY[a, b]::float8[]) WITH ORDINALITY u(v, k) WHERE rejected
            ORDER BY design_link_id, k),
        streetgen._setting_number(model, 'link_factor'), streetgen._setting_text(model, 'benefit') = 'network') t)
    SELECT l.nth, a, b, l.network AS rank, (ARRAY['highway', 'secondary', 'rural'])[l.network + 1] AS network, length,
        utilisation, benefit, cost, by_hand_row, s.design_node_id AS town_a, e.design_node_id AS town_b,
        ST_MakeLine(s.geom, e.geom) AS geom
    FROM linked l JOIN pg_temp._town s ON s.nth = l.a JOIN pg_temp._town e ON e.nth = l.b;
    CREATE INDEX ON pg_temp._link (nth);
    CREATE TEMPORARY TABLE _meeting ON COMMIT DROP AS
    SELECT ST_ClusterDBSCAN(geom, 1, 1) OVER () AS place, * FROM (
        SELECT ST_SnapToGrid(ST_SetSRID(ST_Point(x, y), srid), 0.001) AS geom, first, second
        FROM streetgen._link_crossings(streetgen._town_numbers(model), ARRAY(SELECT v FROM pg_temp._link l,
            unnest(ARRAY[a, b, rank]::float8[]) WITH ORDINALITY u(v, k) ORDER BY nth, k))
        -- A link by hand is not cut: it crosses the others as links of other networks do.
        WHERE NOT EXISTS (SELECT FROM pg_temp._link l WHERE by_hand_row AND l.nth IN (first, second))) m;
END $$;
COMMENT ON FUNCTION streetgen._find_town_links(name) IS
    'Links between towns before they are cut (temporary tables _town and _link), and where those of one network cross '
    '(_meeting): crossings within a metre are one place.';

CREATE OR REPLACE FUNCTION streetgen._place_interchanges(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE TEMPORARY TABLE _passing ON COMMIT DROP AS
        SELECT DISTINCT place, l.* FROM pg_temp._meeting JOIN pg_temp._link l ON l.nth IN (first, second);
    CREATE TEMPORARY TABLE _interchange ON COMMIT DROP AS
        SELECT m.place, (array_agg(m.geom ORDER BY first, second))[1] AS geom, t.design_node_id
        FROM pg_temp._meeting m LEFT JOIN LATERAL (SELECT design_node_id FROM pg_temp._town t
            JOIN design_node n USING (design_node_id)
            WHERE ST_DWithin(t.geom, m.geom, 1) AND n.kind <> 'interchange' LIMIT 1) t ON true
        GROUP BY m.place, t.design_node_id;
    CREATE TEMPORARY TABLE _near ON COMMIT DROP AS
    WITH former AS (SELECT DISTINCT design_node_id, town_a, town_b, network FROM (
            SELECT node_a AS design_node_id, town_a, town_b, network FROM design_link
            UNION ALL SELECT node_b, town_a, town_b, network FROM design_link) e WHERE town_a IS NOT NULL),
    shared AS (SELECT place, design_node_id, count(*) AS roads FROM pg_temp._passing p JOIN former f
        ON (least(p.town_a, p.town_b), greatest(p.town_a, p.town_b), p.network) = (f.town_a, f.town_b, f.network)
        GROUP BY place, design_node_id),
    -- The interchange of the same two roads is the same however far it moved, that of one of them within a tenth of it.
    reach AS (SELECT place, 100 * min(length) AS metres FROM pg_temp._passing GROUP BY place)
    SELECT i.place AS found, n.design_node_id AS known,
        ST_Distance(i.geom, n.geom) - 1e8 * coalesce(s.roads, 0) AS apart
    FROM pg_temp._interchange i JOIN reach r USING (place) JOIN design_node n ON n.kind = 'interchange'
    LEFT JOIN shared s ON s.place = i.place AND s.design_node_id = n.design_node_id
    WHERE i.design_node_id IS NULL AND (s.roads > 1 OR ST_DWithin(i.geom, n.geom, metres) AND (s.roads = 1
        OR n.by_hand OR n.design_node_id NOT IN (SELECT design_node_id FROM former)));
    PERFORM streetgen._match_nearest();
    UPDATE pg_temp._interchange i SET design_node_id = m.known FROM pg_temp._match m WHERE m.found = i.place;
    -- One that was deleted by hand cuts no road.
    DELETE FROM pg_temp._interchange i USING design_node n WHERE n.design_node_id = i.design_node_id AND n.rejected
        AND n.by_hand;
    UPDATE design_node n SET geom = i.geom, rejected = false FROM pg_temp._interchange i
        WHERE n.design_node_id = i.design_node_id AND n.kind = 'interchange' AND NOT n.by_hand
        AND (n.rejected OR NOT ST_Equals(n.geom, i.geom));
    UPDATE pg_temp._interchange SET design_node_id = nextval(pg_get_serial_sequence('design_node', 'design_node_id'))
        WHERE design_node_id IS NULL;
    INSERT INTO design_node (design_node_id, kind, importance, geom) SELECT design_node_id, 'interchange', 0, geom
        FROM pg_temp._interchange i WHERE NOT EXISTS (SELECT FROM design_node n
            WHERE n.design_node_id = i.design_node_id);
    DROP TABLE pg_temp._match;
END $$;
COMMENT ON FUNCTION streetgen._place_interchanges(name) IS
    'Gives each place where links of a network cross its node (temporary table _interchange): a town within a metre, '
    'the interchange that it was before, which moves, or a new one. An interchange by hand stays where it is.';

CREATE OR REPLACE FUNCTION streetgen._settle_links(model name) RETURNS bigint
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    held constant bigint[] := streetgen._links_by_hand(model);
    changed bigint;
    gone bigint[];
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE TEMPORARY TABLE _piece ON COMMIT DROP AS
    WITH stop AS (
        SELECT nth, town_a AS node, 0::float8 AS at FROM pg_temp._link
        UNION ALL SELECT nth, town_b, 1 FROM pg_temp._link
        UNION ALL SELECT p.nth, n.design_node_id, ST_LineLocatePoint(p.geom, n.geom) FROM pg_temp._passing p
            JOIN pg_temp._interchange i USING (place) JOIN design_node n USING (design_node_id)),
    piece AS (SELECT nth, node, lead(node) OVER (PARTITION BY nth ORDER BY at) AS next FROM stop),
    each AS (SELECT DISTINCT ON (least(node, next), greatest(node, next), network) least(node, next) AS node_a,
        greatest(node, next) AS node_b, network, length, utilisation, benefit, cost, least(town_a, town_b) AS town_a,
        greatest(town_a, town_b) AS town_b
        FROM piece JOIN pg_temp._link USING (nth) WHERE next <> node AND NOT by_hand_row
        ORDER BY least(node, next), greatest(node, next), network, benefit DESC, town_a, town_b)
    SELECT row_number() OVER () AS nth, e.*, l.design_link_id, coalesce(l.rejected AND l.by_hand, false) AS unwanted
    FROM each e LEFT JOIN LATERAL (SELECT * FROM design_link l WHERE l.network = e.network
        AND (least(l.node_a, l.node_b), greatest(l.node_a, l.node_b)) = (e.node_a, e.node_b)
        ORDER BY by_hand DESC, rejected, design_link_id LIMIT 1) l ON true;
    CREATE INDEX ON pg_temp._piece (design_link_id);
    -- A link whose ends are others now, and that has rows by hand, goes on as the new one that is nearest to it.
    CREATE TEMPORARY TABLE _near ON COMMIT DROP AS
    WITH former AS (SELECT l.*, a.geom AS a, b.geom AS b FROM design_link l
        JOIN design_node a ON a.design_node_id = node_a JOIN design_node b ON b.design_node_id = node_b
        WHERE NOT l.by_hand AND l.design_link_id = ANY (held)
        AND NOT EXISTS (SELECT FROM pg_temp._piece p WHERE p.design_link_id = l.design_link_id))
    SELECT p.nth AS found, h.design_link_id AS known, w.apart - CASE
        WHEN (p.town_a, p.town_b) = (h.town_a, h.town_b) THEN 1e8 ELSE 0 END AS apart, w.turned
    FROM pg_temp._piece p JOIN former h USING (network) JOIN design_node a ON a.design_node_id = p.node_a
    JOIN design_node b ON b.design_node_id = p.node_b,
        LATERAL (SELECT ST_Distance(h.a, a.geom) + ST_Distance(h.b, b.geom) AS apart, false AS turned
            UNION ALL SELECT ST_Distance(h.a, b.geom) + ST_Distance(h.b, a.geom), true ORDER BY apart LIMIT 1) w
    WHERE p.design_link_id IS NULL AND w.apart < 0.2 * ST_Distance(a.geom, b.geom);
    PERFORM streetgen._match_nearest();
    UPDATE pg_temp._piece p SET design_link_id = m.known FROM pg_temp._match m WHERE m.found = p.nth;
    WITH same AS (UPDATE design_link l SET length = p.length, utilisation = p.utilisation, benefit = p.benefit,
        cost = p.cost, town_a = p.town_a, town_b = p.town_b, rejected = false,
        -- Metres along it count from the same end as before.
        node_a = CASE WHEN m.turned IS NULL THEN l.node_a WHEN m.turned THEN p.node_b ELSE p.node_a END,
        node_b = CASE WHEN m.turned IS NULL THEN l.node_b WHEN m.turned THEN p.node_a ELSE p.node_b END
        FROM pg_temp._piece p LEFT JOIN pg_temp._match m ON m.found = p.nth WHERE p.design_link_id = l.design_link_id
            AND NOT p.unwanted
        AND (m.turned IS NOT NULL OR (l.length, l.utilisation, l.benefit, l.cost, l.town_a, l.town_b, l.rejected)
            IS DISTINCT FROM (p.length, p.utilisation, p.benefit, p.cost, p.town_a, p.town_b, false)) RETURNING 1),
    come AS (INSERT INTO design_link (node_a, node_b, network, length, utilisation, benefit, cost, town_a, town_b)
        SELECT node_a, node_b, network, length, utilisation, benefit, cost, town_a, town_b FROM pg_temp._piece
        WHERE design_link_id IS NULL ORDER BY nth RETURNING 1)
    SELECT (SELECT count(*) FROM same) + (SELECT count(*) FROM come) INTO changed;
    -- Links that came have no row in _piece by their key; all others that are not there are gone.
    SELECT coalesce(array_agg(design_link_id), '{}') FROM design_link l WHERE NOT by_hand
        AND NOT rejected AND NOT EXISTS (SELECT FROM pg_temp._piece p WHERE (p.node_a, p.node_b, p.network)
            = (least(l.node_a, l.node_b), greatest(l.node_a, l.node_b), l.network)) INTO gone;
    PERFORM streetgen._clear_links(model, gone);
    UPDATE design_link SET rejected = true, method = NULL WHERE design_link_id = ANY (gone);
    DELETE FROM design_link WHERE rejected AND NOT by_hand AND design_link_id <> ALL (held);
    UPDATE design_node n SET rejected = true WHERE kind = 'interchange' AND NOT by_hand AND NOT rejected
        AND NOT EXISTS (SELECT FROM pg_temp._interchange i WHERE i.design_node_id = n.design_node_id);
    DELETE FROM design_node n WHERE rejected AND NOT by_hand
        AND NOT EXISTS (SELECT FROM design_link l WHERE n.design_node_id IN (l.node_a, l.node_b));
    DROP TABLE pg_temp._match;
    RETURN changed + cardinality(gone);
END $$;
COMMENT ON FUNCTION streetgen._settle_links(name) IS
    'Links between the nodes (temporary table _piece): those with the same ends stay, and those with rows by hand go '
    'on as the nearest. Links that are gone wait while they have rows by hand, rejected and not by hand; others, and '
    'interchanges without a link, are deleted. Returns how many links came, went or changed.';

CREATE OR REPLACE FUNCTION streetgen._design_links(model name) RETURNS bigint
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
DECLARE
    changed bigint;
BEGIN
    PERFORM streetgen._find_town_links(model);
    PERFORM streetgen._place_interchanges(model);
    changed := streetgen._settle_links(model);
    DROP TABLE pg_temp._town, pg_temp._link, pg_temp._meeting, pg_temp._passing, pg_temp._interchange, pg_temp._piece;
    RETURN changed;
END $$;
COMMENT ON FUNCTION streetgen._design_links(name) IS
    'Stage links: computes interchanges and links anew; returns how many links came, went or changed.';
