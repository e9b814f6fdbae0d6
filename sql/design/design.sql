-- The driver of a design: what is stale is computed, stage by stage.

CREATE OR REPLACE FUNCTION streetgen._design_stage()
    RETURNS TABLE(place integer, stage text, computed boolean, each_link boolean)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 9 SET search_path = pg_catalog
    AS $$ VALUES (1, 'terrain', false, false), (2, 'zones', false, false), (3, 'nodes', false, false),
        (4, 'links', true, false), (5, 'paths', true, true), (6, 'horizontal', true, true), (7, 'vertical', true, true),
        (8, 'structures', true, true), (9, 'axes', true, true) $$;
COMMENT ON FUNCTION streetgen._design_stage() IS
    'The stages of a design in their order. computed: else it is input alone; each_link: it is computed link by link.';

CREATE OR REPLACE FUNCTION streetgen._ground_input(model name, stage text, link bigint) RETURNS SETOF text
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 50 SET search_path = pg_catalog, public
    AS $$
DECLARE
    area constant geometry := streetgen._link_area(model, link);
BEGIN
    PERFORM streetgen._use_model(model);
    IF stage IN ('paths', 'vertical') THEN
        RETURN QUERY SELECT ROW(content, geom)::text FROM terrain_tile WHERE geom && area AND NOT rejected;
    END IF;
    IF stage IN ('paths', 'structures') THEN
        RETURN QUERY SELECT ROW(z.class, cost, passage, z.content)::text FROM zone z JOIN zone_class USING (class)
            WHERE z.geom && area AND NOT z.rejected;
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._ground_input(name, text, bigint) IS
    'The terrain and the zones that a stage of a link is computed from.';

CREATE OR REPLACE FUNCTION streetgen._profile_input(model name, link bigint) RETURNS SETOF text
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 20 SET search_path = pg_catalog, public
    AS $$
DECLARE
    extent constant geometry := ST_Envelope(streetgen._plan_line(model, link));
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY
    SELECT ROW(streetgen._link_rules(model, link), streetgen._setting_text(model, 'clearance'))::text
    UNION ALL SELECT ROW(streetgen._link_elements(model, link))::text
    UNION ALL SELECT ROW(abscissa, height, radius, rejected)::text FROM grade_point WHERE design_link_id = link
        AND (by_hand OR rejected)
    -- The place of a crossing follows from both alignments.
    UNION ALL SELECT ROW(design_crossing_id, other_link_id, kind, rejected)::text FROM design_crossing
        WHERE design_link_id = link AND (by_hand OR rejected)
    UNION ALL SELECT ROW(o.design_link_id, o.geom)::text FROM design_link l JOIN design_link o
        ON (streetgen._network_rank(o.network), o.design_link_id) <
            (streetgen._network_rank(l.network), l.design_link_id) AND NOT o.rejected
        AND o.geom && extent WHERE l.design_link_id = link;
END $$;
COMMENT ON FUNCTION streetgen._profile_input(name, bigint) IS
    'What stage vertical of a link is computed from, beside the terrain.';

CREATE OR REPLACE FUNCTION streetgen._stage_input(model name, stage text, link bigint) RETURNS SETOF text
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 50 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    CASE stage
    WHEN 'links' THEN RETURN QUERY
        SELECT ROW(design_node_id, kind, importance, geom)::text FROM design_node WHERE NOT rejected
            AND (by_hand OR kind <> 'interchange')
        UNION ALL SELECT ROW(node_a, node_b, network, rejected)::text FROM design_link WHERE by_hand
        UNION ALL SELECT ROW(streetgen._setting_text(model, 'link_factor'),
            streetgen._setting_text(model, 'benefit'))::text;
    WHEN 'paths' THEN RETURN QUERY
        SELECT ROW(streetgen._link_rules(model, link) - 'curve_radius')::text
        UNION ALL SELECT ROW(ordinality, geom, straight)::text FROM streetgen._link_places(model, link, true)
        UNION ALL SELECT * FROM streetgen._ground_input(model, stage, link);
    WHEN 'horizontal' THEN RETURN QUERY
        SELECT ROW(streetgen._link_rules(model, link))::text
        UNION ALL SELECT ROW(ordinality, geom, curve)::text FROM streetgen._link_places(model, link, false)
        UNION ALL SELECT ROW(e.*)::text FROM alignment_element e WHERE design_link_id = link AND by_hand;
    WHEN 'vertical' THEN RETURN QUERY
        SELECT * FROM streetgen._profile_input(model, link)
        UNION ALL SELECT * FROM streetgen._ground_input(model, stage, link);
    WHEN 'structures' THEN RETURN QUERY
        SELECT ROW(streetgen._link_rules(model, link))::text
        UNION ALL SELECT ROW(streetgen._link_elements(model, link), streetgen._link_grades(model, link))::text
        UNION ALL SELECT ROW(abscissa, kind, rejected)::text FROM design_crossing WHERE design_link_id = link
        UNION ALL SELECT * FROM streetgen._ground_input(model, stage, link)
        UNION ALL SELECT ROW(kind, start_abscissa, end_abscissa, rejected)::text FROM structure
            WHERE design_link_id = link AND by_hand;
    WHEN 'axes' THEN RETURN QUERY
        SELECT ROW(c.*, a.name, b.name, streetgen._setting_text(model, 'driving_side'),
            streetgen._link_elements(model, link), streetgen._link_grades(model, link))::text FROM design_link l
            JOIN design_class c USING (network) JOIN design_node a ON a.design_node_id = node_a
            JOIN design_node b ON b.design_node_id = node_b WHERE design_link_id = link
        UNION ALL SELECT ROW(p.*)::text FROM streetgen._axis_cuts(model, link) p;
    END CASE;
END $$;
COMMENT ON FUNCTION streetgen._stage_input(name, text, bigint) IS
    'The rows that a stage of a link is computed from, as text; link 0: of a stage that is not link by link.';

CREATE OR REPLACE FUNCTION streetgen._design_hash(model name, stage text, link bigint) RETURNS bigint
    LANGUAGE sql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$ SELECT coalesce(hashtextextended(string_agg(md5(line), '' ORDER BY md5(line)), 47), 0)
        FROM streetgen._stage_input(model, stage, link) line $$;
COMMENT ON FUNCTION streetgen._design_hash(name, text, bigint) IS
    'Hash of what a stage is computed from; link 0: of a stage that is not link by link.';

CREATE OR REPLACE FUNCTION streetgen._stale_input(model name, stage text, link bigint) RETURNS bigint
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
DECLARE
    hash constant bigint := streetgen._design_hash(model, stage, link);
    known boolean;
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT EXISTS (SELECT FROM design_input i WHERE i.stage = _stale_input.stage AND design_link_id = link
        AND input_hash = hash) INTO known;
    RETURN CASE WHEN NOT known THEN hash END;
END $$;
COMMENT ON FUNCTION streetgen._stale_input(name, text, bigint) IS
    'Hash of the input of a stage of a link that changed since the stage was computed; NULL: it did not.';

CREATE OR REPLACE FUNCTION streetgen._note_input(model name, stage text, link bigint, hash bigint)
    RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    INSERT INTO design_input VALUES (stage, link, hash) ON CONFLICT ON CONSTRAINT design_input_pkey DO UPDATE SET
        input_hash = excluded.input_hash;
END $$;
COMMENT ON FUNCTION streetgen._note_input(name, text, bigint, bigint) IS
    'Notes what a stage of a link was computed from.';

CREATE OR REPLACE FUNCTION streetgen._run_stages(model name, stages text[], links bigint[])
    RETURNS TABLE(stage text, computed bigint, written bigint)
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE ROWS 6 SET search_path = pg_catalog, public
    AS $$
DECLARE
    each record;
    link bigint;
    wanted bigint[];
    stale bigint[];
    hashes bigint[];
    hash bigint;
    rows bigint;
    barred boolean;
BEGIN
    PERFORM streetgen._use_model(model);
    LOCK TABLE design_link IN SHARE ROW EXCLUSIVE MODE;
    FOR each IN SELECT * FROM streetgen._design_stage() s WHERE s.computed
        AND (stages IS NULL OR s.stage = ANY (stages)) ORDER BY s.place
    LOOP
        stage := each.stage;
        computed := 0;
        written := 0;
        IF NOT each.each_link THEN
            hash := CASE WHEN links IS NULL THEN streetgen._stale_input(model, stage, 0) END;
            IF hash IS NOT NULL THEN
                PERFORM streetgen._check_design_nodes(model);
                computed := 1;
                written := streetgen._design_links(model);
                PERFORM streetgen._note_input(model, stage, 0, hash);
            END IF;
            RETURN NEXT;
            CONTINUE;
        END IF;
        SELECT coalesce(array_agg(design_link_id ORDER BY streetgen._network_rank(network),
            design_link_id), '{}') FROM design_link WHERE NOT rejected AND (links IS NULL
                OR design_link_id = ANY (links))
            AND (stage = 'paths' OR coalesce(method, '') NOT LIKE 'no_path%') INTO wanted;
        stale := '{}';
        hashes := '{}';
        FOREACH link IN ARRAY wanted LOOP
            -- A link that is built before another one may change what that one is computed from.
            hash := streetgen._stale_input(model, stage, link);
            IF hash IS NOT NULL THEN
                stale := stale || link;
                hashes := hashes || hash;
                PERFORM set_config('application_name', format('streetgen: design, %s, link %s of %s', stage,
                    array_position(wanted, link), cardinality(wanted)), true);
                IF stage <> 'axes' THEN
                    EXECUTE format('SELECT streetgen.%I($1, $2)', '_design_' || CASE stage WHEN 'paths' THEN 'path'
                        ELSE stage END) INTO rows USING model, link;
                    written := written + rows;
                    PERFORM streetgen._note_input(model, stage, link, hash);
                END IF;
            END IF;
        END LOOP;
        SELECT EXISTS (SELECT FROM design_link WHERE design_link_id = ANY (links)
            AND method LIKE 'no_path%') INTO barred;
        IF stage = 'axes' AND (stale <> '{}' OR links IS NULL OR barred) THEN
            written := streetgen._design_axes(model, stale);
            PERFORM streetgen._note_input(model, stage, l, h) FROM unnest(stale, hashes) u(l, h);
        END IF;
        computed := cardinality(stale);
        RETURN NEXT;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._run_stages(name, text[], bigint[]) IS
    'Computes the stages of links that are stale, in order: how many links were computed, and rows written.';

CREATE OR REPLACE FUNCTION streetgen.design(model name, stages text[] DEFAULT NULL, links bigint[] DEFAULT NULL)
    RETURNS TABLE(stage text, computed bigint, written bigint)
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE ROWS 6 SET search_path = pg_catalog, public
    SET application_name = 'streetgen: design'
    AS $$
DECLARE
    wrong text;
    missing bigint;
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_owner(model), streetgen._require_design(model);
    SELECT w INTO wrong FROM unnest(stages) w WHERE w NOT IN (SELECT s.stage FROM streetgen._design_stage() s)
        OR w IS NULL LIMIT 1;
    IF FOUND THEN
        RAISE EXCEPTION 'there is no stage "%" of a design', coalesce(wrong, 'NULL') USING ERRCODE = '22023',
            HINT = 'The stages are ' || (SELECT string_agg(s.stage, ', ' ORDER BY s.place)
                FROM streetgen._design_stage() s) || '.';
    END IF;
    SELECT w FROM unnest(links) w WHERE NOT EXISTS (SELECT FROM design_link
        WHERE design_link_id = w) LIMIT 1 INTO missing;
    IF missing IS NOT NULL THEN
        RAISE EXCEPTION 'there is no link % in the design', missing USING ERRCODE = '22023',
            HINT = format('SELECT design_link_id FROM %I.design_link lists them.', model);
    END IF;
    PERFORM streetgen._pause();
    RETURN QUERY SELECT * FROM streetgen._run_stages(model, stages, links);
END $$;
COMMENT ON FUNCTION streetgen.design(name, text[], bigint[]) IS
    'Designs the roads of a model: computes what is stale, stage by stage, in one transaction, and writes axes (source '
    'design); streetgen.generate makes their streets. stages: terrain, zones, nodes (input alone), links, paths, '
    'horizontal, vertical, structures, axes; NULL: all. links: keys of links; NULL: all, and which towns are linked. '
    'Rows by hand stay, rejected ones do not come back. Gives a row a stage: how many links were computed, and how '
    'many rows written. Nodes at one place or without terrain, a speed without a standard, curves by hand that do not '
    'fit, an unknown stage or link: 22023; a model without a design: 55000; not its owner: 42501.';
