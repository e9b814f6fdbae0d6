-- A model is a schema of the user's: these functions make it, hand it out and take it away.

CREATE OR REPLACE FUNCTION streetgen.version() RETURNS text
    LANGUAGE sql STABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT extversion FROM pg_extension WHERE extname = 'streetgen' $$;
COMMENT ON FUNCTION streetgen.version() IS 'Version of the installed extension.';

CREATE OR REPLACE FUNCTION streetgen._default_setting()
    RETURNS TABLE(name text, value text, unit text, description text, minimum float8, maximum float8, choice text[])
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ VALUES
    ('tolerance', '0.5', 'm', 'ends and vertices this near to each other are one node', 0.001, 10, NULL::text[]),
    ('crossing', 'over', NULL, 'axes of one level that cross without a vertex: over (no node) or split', NULL, NULL, ARRAY['over', 'split']),
    ('max_arc_distance', '60', 'm', 'an arc centre farther from its node gets the minimal radius', 1, 1000, NULL),
    ('radius_minimal', '0.15', 'm', 'radius of a kerb stone, for arcs that lie too far away', 0.01, 5, NULL),
    ('radius_rule', 'min', NULL, 'radius of a corner from those of its two axes: min, max or mean', NULL, NULL, ARRAY['min', 'max', 'mean']),
    ('short_axis', 'reduce', NULL, 'an axis too short for the wanted radius: reduce (the radius, and follow only where none fits) or follow (the next axis in its direction first)', NULL, NULL, ARRAY['reduce', 'follow']),
    ('radius_by_importance', '{"1": 8, "2": 6.25, "3": 6.25, "4": 3}', 'm', 'wanted radius by importance; an entry holds up to the next one, the first also before itself; null: no arc; empty: turning_radius', NULL, NULL, NULL),
    ('turning_mode', 'paper', NULL, 'law of turning_radius: paper or setra', NULL, NULL, ARRAY['paper', 'setra']),
    ('transition_length', '5', 'm', 'length of a change of width', 0, 200, NULL),
    ('transition_kind', 'symmetric', NULL, 'kerbs that change linearly at a change of width, seen along the axis of the smaller axis_id: symmetric, left or right', NULL, NULL, ARRAY['symmetric', 'left', 'right']),
    ('dead_end', 'flat', NULL, 'end of a dead end: flat or round', NULL, NULL, ARRAY['flat', 'round']),
    ('max_hole_area', '0.5', 'm2', 'holes of one surface under this area are filled', 0, 100, NULL),
    ('max_width_per_lane', '5.5', 'm', 'a source width beyond this per stated lane is not believed; NULL believes all', 2, 100, NULL),
    ('lane_width', '3.5', 'm', 'width of one lane, for estimates', 1, 10, NULL),
    ('lane_width_minimal', '2', 'm', 'lanes of unknown width get less only where all lanes of the roadway do', 0.5, 10, NULL),
    ('cycle_lane_width', '1.5', 'm', 'width of a cycle lane that says none; 0: as the other lanes', 0, 10, NULL),
    ('parking_lane_width', '2', 'm', 'width of a parking lane that says none; 0: as the other lanes', 0, 10, NULL),
    ('lane_order', 'left_first', NULL, 'lanes are numbered from the middle outwards: left_first or right_first', NULL, NULL, ARRAY['left_first', 'right_first']),
    ('driving_side', 'right', NULL, 'side of the road that one drives on: right or left', NULL, NULL, ARRAY['right', 'left']),
    ('edge_line', 'none', NULL, 'line along the kerbs: none or solid', NULL, NULL, ARRAY['none', 'solid']),
    ('u_turn', 'false', NULL, 'pairs also lanes of one edge at its nodes: true or false', NULL, NULL, ARRAY['true', 'false']),
    ('trajectory', 'bezier', NULL, 'path between two lanes: bezier or arcs, which follow the lanes towards the node where they would cross a kerb, or a function (lane_in geometry, lane_out geometry, centre geometry, tolerance float8) returning geometry, with its schema', NULL, NULL, ARRAY['bezier', 'arcs']),
    ('trajectory_radius', '3', 'm', 'a Bezier path tighter than this bends nearer to the crossing of its lanes, away from the node; 0: the rule of the paper wherever its path stays on the roadway', 0, 100, NULL),
    ('trajectory_tolerance', '0.05', 'm', 'chords of a path between lanes leave its curve by at most this', 0.001, 10, NULL),
    ('width_default', '6', 'm', 'width of an axis of which nothing is known', 1, 200, NULL),
    ('importance_default', '5', NULL, 'importance of an axis of which nothing is known', 1, 99, NULL),
    ('speed_by_importance', '{"1": 90, "2": 70, "3": 50, "4": 50, "5": 30}', 'km/h', 'speed by importance; an entry holds up to the next one, the first also before itself', NULL, NULL, NULL),
    ('speed_per_width', '6', 'km/h per m', 'speed of an axis of unknown importance, from its width', 0, 50, NULL),
    ('clean_epsilon', '0.3', 'm', 'importers remove points nearer to each other', 0, 10, NULL),
    ('clean_r_min', '3', 'm', 'importers remove points that turn more sharply than this radius', 0, 100, NULL),
    ('reach', '60', 'm', 'an edit changes nothing farther away along the network', 10, 1000, NULL),
    ('cell_size', '200', 'm', 'cells of the grid on which sessions lock places', 50, 5000, NULL),
    ('lock_timeout', '5', 's', 'an edit waits so long for another session where its own lock_timeout is 0', 0.1, 3600, NULL),
    ('log', 'off', NULL, 'rows in edit_log of who edits what: off or on', NULL, NULL, ARRAY['off', 'on'])
    $$;
COMMENT ON FUNCTION streetgen._default_setting() IS 'The settings of a new model, with their ranges.';

CREATE OR REPLACE FUNCTION streetgen._check_model(model name) RETURNS void
    LANGUAGE plpgsql STABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
BEGIN
    IF model IS NULL THEN
        RAISE EXCEPTION 'the model is NULL' USING ERRCODE = '22004', HINT = 'SELECT name FROM streetgen.model lists them.';
    END IF;
    IF NOT EXISTS (SELECT FROM streetgen.model m JOIN pg_namespace n ON n.nspname = m.name WHERE m.name = _check_model.model) THEN
        RAISE EXCEPTION 'model "%" does not exist', model USING ERRCODE = '3F000',
            HINT = format('SELECT streetgen.create_model(%L, srid => …) makes it.', model);
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._check_model(name) IS 'Raises 3F000 when the model does not exist, 22004 when it is NULL.';

CREATE OR REPLACE FUNCTION streetgen._check_owner(model name) RETURNS void
    LANGUAGE plpgsql STABLE PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._check_model(model);
    IF NOT pg_has_role(current_user, (SELECT nspowner FROM pg_namespace WHERE nspname = model), 'MEMBER') THEN
        RAISE EXCEPTION 'only the owner of model "%" may do this', model USING ERRCODE = '42501',
            HINT = 'Ask its owner, or become a member of the role that owns its schema.';
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._check_owner(name) IS 'Raises 3F000 when the model does not exist, 42501 when the caller is no member of its owner.';

CREATE OR REPLACE FUNCTION streetgen._register_model(model name, srid integer, dimension integer) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SECURITY DEFINER SET search_path = pg_catalog, pg_temp
    AS $$
BEGIN
    -- Inside a definer function current_user is the function's owner: ask for the caller's role.
    IF NOT pg_has_role(coalesce(nullif(current_setting('role'), 'none'), session_user)::name, (SELECT nspowner FROM pg_namespace WHERE nspname = model), 'MEMBER') THEN
        RAISE EXCEPTION 'schema "%" belongs to another role', model USING ERRCODE = '42501',
            HINT = 'Only the owner of a schema registers it as a model.';
    END IF;
    INSERT INTO streetgen.model VALUES (model, srid, dimension, streetgen.version())
        ON CONFLICT (name) DO UPDATE SET srid = excluded.srid, dimension = excluded.dimension, template_version = excluded.template_version;
    DELETE FROM streetgen.model m WHERE NOT EXISTS (SELECT FROM pg_namespace WHERE nspname = m.name);
END $$;
COMMENT ON FUNCTION streetgen._register_model(name, integer, integer) IS 'Writes the registry, for the owner of the schema only; forgets models whose schema is gone.';

CREATE OR REPLACE FUNCTION streetgen._check_srid(srid integer) RETURNS void
    LANGUAGE plpgsql STABLE PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    reference record;
    utm constant text := 'Use a projection in metres that keeps its scale, such as the UTM zone of the place (EPSG 32600 + zone north, 32700 + zone south; Paris is 32631) or the national one (France 2154).';
BEGIN
    SELECT srtext, proj4text INTO reference FROM spatial_ref_sys s WHERE s.srid = _check_srid.srid;
    IF NOT FOUND THEN
        RAISE EXCEPTION 'SRID % is unknown', coalesce(srid::text, 'NULL') USING ERRCODE = '22023', HINT = utm;
    ELSIF reference.srtext LIKE 'GEOG%' OR reference.srtext LIKE 'GEOC%' OR reference.proj4text ~ '\+proj=(longlat|geocent)' THEN
        RAISE EXCEPTION 'SRID % is not projected: its units are degrees', srid USING ERRCODE = '22023', HINT = utm;
    ELSIF reference.proj4text !~ '\+units=m( |$)' THEN
        RAISE EXCEPTION 'SRID % is not in metres', srid USING ERRCODE = '22023', HINT = utm;
    ELSIF reference.proj4text ~ '\+proj=(merc|webmerc|eqc|mill|cea)( |$)' THEN
        RAISE EXCEPTION 'SRID % does not keep its scale: a 7 m street would be built 4.6 m wide in Paris', srid USING ERRCODE = '22023', HINT = utm;
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._check_srid(integer) IS 'Raises 22023 for spatial references that are unknown, geographic, not in metres or more than 1 % off in scale.';

CREATE OR REPLACE FUNCTION streetgen._check_scale(lines text) RETURNS void
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    place record;
    centre geometry;
    -- Metres of ground for 100 m of map.
    east float8;
    north float8;
BEGIN
    -- A scale grows or shrinks towards the rim: the ends of the lines that touch it are looked at.
    FOR place IN EXECUTE format($sql$
WITH line AS MATERIALIZED (%s),
rim AS (SELECT min(ST_XMin(geom)) AS west, max(ST_XMax(geom)) AS east, min(ST_YMin(geom)) AS south, max(ST_YMax(geom)) AS north FROM line)
SELECT label, ST_Force2D(v.point) AS point FROM line, rim, LATERAL (VALUES (ST_StartPoint(geom)), (ST_EndPoint(geom))) v(point)
WHERE (ST_XMin(geom) = west OR ST_XMax(geom) = rim.east OR ST_YMin(geom) = south OR ST_YMax(geom) = rim.north)
    AND ST_X(v.point) BETWEEN -1e12 AND 1e12 AND ST_Y(v.point) BETWEEN -1e12 AND 1e12 $sql$, lines)
    LOOP
        BEGIN
            centre := ST_Transform(place.point, 4326);
            east := ST_Distance(centre::geography, ST_Transform(ST_Translate(place.point, 100, 0), 4326)::geography);
            north := ST_Distance(centre::geography, ST_Transform(ST_Translate(place.point, 0, 100), 4326)::geography);
        EXCEPTION WHEN internal_error THEN
            RAISE EXCEPTION '%, %, lies where SRID % is not defined', place.label, ST_AsText(place.point, 0), ST_SRID(place.point) USING ERRCODE = '22023',
                DETAIL = SQLERRM, HINT = 'Mend its coordinates, or make the model in the reference that they are in.';
        END;
        IF NOT (east BETWEEN 99 AND 101 AND north BETWEEN 99 AND 101) THEN
            RAISE EXCEPTION 'the scale of SRID % is more than 1 %% off at %, %', ST_SRID(place.point), place.label, ST_AsText(place.point, 0) USING ERRCODE = '22023',
                DETAIL = format('100 m of map are %s m east and %s m north on the ground.', round(east::numeric, 1), round(north::numeric, 1)),
                HINT = format('Make the model in the UTM zone of this place: EPSG:%s.', CASE WHEN ST_Y(centre) < 0 THEN 32700 ELSE 32600 END + least(60, floor((ST_X(centre) + 180) / 6)::integer + 1));
        END IF;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._check_scale(text) IS 'Raises 22023, naming the place, the scale and the UTM zone, where the projection of lines, given as a query of label and geom, is more than 1 % off in scale or not defined.';

CREATE OR REPLACE FUNCTION streetgen._make_views(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    EXECUTE format($sql$
CREATE OR REPLACE VIEW %1$I.setting_used WITH (security_invoker = true) AS
SELECT jsonb_object_agg(name, value) AS settings, hashtextextended(string_agg(name || '=' || coalesce(value, '-'), ',' ORDER BY name), 0) AS setting_hash
FROM %1$I.setting WHERE name NOT IN ('cell_size', 'lock_timeout', 'log')
$sql$, model);
    EXECUTE format($sql$COMMENT ON VIEW %I.setting_used IS 'The settings that streets depend on, as one row'$sql$, model);
    EXECUTE format($sql$
CREATE OR REPLACE VIEW %1$I.axis_used WITH (security_invoker = true) AS
SELECT axis_id, geom, level, width_used AS width, coalesce(CASE WHEN kerb_width IS NULL THEN width_end END, width_used) AS width_end,
       forward_used + backward_used AS lane_count, forward_used AS lanes_forward, backward_used AS lanes_backward, direction,
       kind_forward, kind_backward, lane_width_forward, lane_width_backward, turn_forward, turn_backward,
       speed_used AS speed, coalesce(importance_known, (v ->> 'importance_default')::integer) AS importance,
       streetgen.wanted_radius(radius, importance_known, speed_used, width_used, v ->> 'radius_by_importance', v ->> 'turning_mode') AS radius,
       array_remove(ARRAY[CASE WHEN kerb_width IS NULL AND believed IS NULL THEN 'width' END, CASE WHEN lane_count IS NULL AND stated_forward IS NULL AND stated_backward IS NULL THEN 'lane_count' END,
                          CASE WHEN speed IS NULL THEN 'speed' END, CASE WHEN importance IS NULL THEN 'importance' END], NULL) AS estimated,
       hashtextextended(concat_ws('|', geom::text, level, width, width_end, lane_count, speed, importance, radius, kind, class_width, class_speed, class_importance, kerb_width,
           (SELECT string_agg(says, '|' ORDER BY place, key) FROM (
               SELECT 1 AS place, transition_override_id AS key, format('%%s %%s %%s', which, kind, length) AS says FROM %1$I.transition_override WHERE axis_id = a.axis_id
               UNION ALL SELECT 2, section_limit_override_id, concat_ws(' ', abscissa, which) FROM %1$I.section_limit_override WHERE axis_id = a.axis_id
               UNION ALL SELECT 3, corner_override_id, concat_ws(' ', geom::text, axis_a, axis_b, radius) FROM %1$I.corner_override WHERE axis_a = a.axis_id OR axis_b = a.axis_id
               UNION ALL SELECT 4, lane_override_id, concat_ws(' ', abscissa, ordinality, along_axis, width, line::text) FROM %1$I.lane_override WHERE axis_id = a.axis_id) o))
           || concat(',', direction, ',', lanes_forward, ',', lanes_backward, ',', kind_forward, ',', kind_backward, ',', lane_width_forward, ',', lane_width_backward, ',', turn_forward, ',', turn_backward), 0) AS input_hash,
       setting_hash
FROM %1$I.axis a CROSS JOIN (SELECT settings AS v, setting_hash FROM %1$I.setting_used) s
LEFT JOIN (SELECT class AS kind, width AS class_width, speed AS class_speed, importance AS class_importance FROM %1$I.axis_class) c USING (kind)
-- OFFSET 0: each step is computed once, not again in every expression that names it.
CROSS JOIN LATERAL (
    SELECT coalesce(streetgen.driving_lanes(kind_forward), nullif(lanes_forward, 0)) AS stated_forward, coalesce(streetgen.driving_lanes(kind_backward), nullif(lanes_backward, 0)) AS stated_backward,
           streetgen.believed_width(width, lane_count, CASE WHEN kind IN ('runway', 'taxiway') THEN NULL ELSE (v ->> 'max_width_per_lane')::float8 END) AS believed,
           coalesce(importance, class_importance) AS importance_known,
           (SELECT avg(k.width ORDER BY k.kerb_point_override_id) FROM %1$I.kerb_point_override k WHERE k.axis_id = a.axis_id) AS kerb_width OFFSET 0) known
CROSS JOIN LATERAL (
    SELECT coalesce(kerb_width, believed, least(200, streetgen.estimated_width(lanes_stated, class_width, (v ->> 'lane_width')::float8, (v ->> 'width_default')::float8)
               + CASE WHEN lanes_stated IS NULL THEN 0 ELSE coalesce(streetgen.kerbside_width(kind_forward, (v ->> 'cycle_lane_width')::float8, (v ->> 'parking_lane_width')::float8), 0)
                                                            + coalesce(streetgen.kerbside_width(kind_backward, (v ->> 'cycle_lane_width')::float8, (v ->> 'parking_lane_width')::float8), 0) END)) AS width_used
    FROM (SELECT coalesce(lane_count, stated_forward + stated_backward) AS lanes_stated) k OFFSET 0) w
CROSS JOIN LATERAL (
    SELECT coalesce(speed, class_speed, streetgen.estimated_speed(importance_known, width_used, (v ->> 'speed_by_importance')::jsonb, (v ->> 'speed_per_width')::float8)) AS speed_used OFFSET 0) p
CROSS JOIN LATERAL (
    SELECT coalesce(lane_count, greatest(CASE WHEN kind IN ('runway', 'taxiway') THEN 1 ELSE streetgen.estimated_lane_count(width_used, speed_used, (v ->> 'lane_width')::float8) END,
               CASE direction WHEN 'both' THEN 2 ELSE 1 END)) AS count_used OFFSET 0) n
CROSS JOIN LATERAL (
    SELECT streetgen.lanes_of_way(direction <> 'reverse', kind_forward IS NOT NULL, stated_forward,
               CASE WHEN direction = 'both' THEN coalesce(stated_backward, count_used / 2) WHEN kind_backward IS NULL THEN 0 ELSE stated_backward END, count_used) AS forward_used,
           streetgen.lanes_of_way(direction <> 'direct', kind_backward IS NOT NULL, stated_backward,
               CASE WHEN direction = 'both' THEN coalesce(stated_forward, (count_used + 1) / 2) WHEN kind_forward IS NULL THEN 0 ELSE stated_forward END, count_used) AS backward_used OFFSET 0) l
$sql$, model);
    EXECUTE format($sql$COMMENT ON VIEW %I.axis_used IS 'The axes with the values that generate uses: what the source lacks is estimated by named functions'$sql$, model);
    EXECUTE format($sql$
CREATE OR REPLACE VIEW %1$I.intersection_group WITH (security_invoker = true) AS
WITH RECURSIVE crossed AS (
    SELECT from_node, to_node FROM %1$I.edge JOIN %1$I.section s USING (edge_id)
    WHERE s.method = 'crossed_limits' AND from_node IN (SELECT node_id FROM %1$I.intersection) AND to_node IN (SELECT node_id FROM %1$I.intersection)
), touching AS (
    SELECT from_node, to_node FROM crossed UNION SELECT to_node, from_node FROM crossed
), joined AS (
    SELECT node_id, node_id AS other FROM %1$I.intersection
    UNION SELECT j.node_id, t.to_node FROM joined j JOIN touching t ON t.from_node = j.other
)
SELECT node_id, i.level, min(j.other) AS group_id FROM joined j JOIN %1$I.intersection i USING (node_id) GROUP BY node_id, i.level
$sql$, model);
    EXECUTE format($sql$
CREATE OR REPLACE VIEW %1$I.conflict WITH (security_invoker = true) AS
SELECT a.node_id, a.interconnection_id AS interconnection_a, b.interconnection_id AS interconnection_b,
       CASE WHEN a.lane_out = b.lane_out THEN 'merging' ELSE 'crossing' END AS kind,
       CASE WHEN a.lane_out = b.lane_out THEN ST_EndPoint(a.geom) ELSE ST_Intersection(a.geom, b.geom) END AS geom
FROM %1$I.interconnection a JOIN %1$I.interconnection b ON b.node_id = a.node_id AND a.interconnection_id < b.interconnection_id
WHERE a.connecting AND b.connecting AND a.lane_in <> b.lane_in AND (a.lane_out = b.lane_out OR ST_Intersects(a.geom, b.geom))
$sql$, model);
    EXECUTE format($sql$
CREATE OR REPLACE VIEW %1$I.roadway WITH (security_invoker = true) AS
SELECT 2 * edge_id AS roadway_id, 'section' AS part, edge_id, NULL::bigint AS node_id, axis_id, name, kind, importance, e.level, e.width, e.lane_count, surface
FROM %1$I.section JOIN %1$I.edge e USING (edge_id) LEFT JOIN (SELECT axis_id, name, kind FROM %1$I.axis) a USING (axis_id) WHERE NOT ST_IsEmpty(surface)
UNION ALL
SELECT 2 * node_id + 1, 'intersection', NULL, node_id, axis_id, name, kind, importance, level, width, lane_count, surface
FROM %1$I.intersection i LEFT JOIN LATERAL (
    SELECT axis_id, importance, greatest(CASE node_id WHEN from_node THEN width END, CASE node_id WHEN to_node THEN width_end END) AS width, lane_count
    FROM %1$I.edge WHERE from_node = node_id OR to_node = node_id ORDER BY importance, width DESC, axis_id, edge_id LIMIT 1) first ON true
LEFT JOIN (SELECT axis_id, name, kind FROM %1$I.axis) a USING (axis_id) WHERE NOT ST_IsEmpty(surface)
$sql$, model);
    EXECUTE format($sql$COMMENT ON VIEW %I.roadway IS 'The polygons of the roads: sections and intersections, which tile the ground of each level without overlap. An intersection is named after its first edge: the most important, then the widest, then that of the smallest axis_id'$sql$, model);
    EXECUTE format($sql$COMMENT ON VIEW %I.conflict IS 'Pairs of connecting interconnections of a node from two lanes whose paths cross, or merge in one lane; geom is where'$sql$, model);
    EXECUTE format($sql$COMMENT ON VIEW %I.intersection_group IS 'Intersections that touch without a section between, over edges of crossed limits, as groups: the smallest node of each names it'$sql$, model);
END $$;
COMMENT ON FUNCTION streetgen._make_views(name) IS 'Makes the views of a model, again and again.';

CREATE OR REPLACE FUNCTION streetgen._add_tables(model name, srid integer) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._make_override_tables(model, srid), streetgen._make_edit_log_table(model, srid), streetgen._make_followed_table(model), streetgen._make_cluster_table(model, srid), streetgen._make_edit_indexes(model, srid);
END $$;
COMMENT ON FUNCTION streetgen._add_tables(name, integer) IS 'Makes the tables, columns and indexes that came after the first models, where they are missing.';

CREATE OR REPLACE FUNCTION streetgen.create_model(model name, srid integer, dimension integer DEFAULT 2) RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    z text := CASE WHEN dimension = 3 THEN 'Z' ELSE '' END;
    statement text;
BEGIN
    IF model IS NULL OR model = '' THEN
        RAISE EXCEPTION 'the model needs a name' USING ERRCODE = '22023', HINT = 'It names the schema of the model''s tables.';
    END IF;
    IF dimension IS NULL OR dimension NOT IN (2, 3) THEN
        RAISE EXCEPTION 'dimension is %, expected 2 or 3', coalesce(dimension::text, 'NULL') USING ERRCODE = '22023', HINT = '3 keeps the heights of axes and nodes.';
    END IF;
    PERFORM streetgen._check_srid(srid);
    IF EXISTS (SELECT FROM pg_namespace WHERE nspname = model) THEN
        RAISE EXCEPTION 'schema "%" already exists', model USING ERRCODE = '42P06',
            HINT = format('Choose another name, or SELECT streetgen.drop_model(%L) if it is a model that may go.', model);
    END IF;
    EXECUTE format('CREATE SCHEMA %I', model);
    EXECUTE format('COMMENT ON SCHEMA %I IS %L', model, 'Street model of StreetGen: axes in, streets out');
    FOREACH statement IN ARRAY ARRAY[
        $t$CREATE TABLE %1$I.setting (name text PRIMARY KEY, value text, unit text, description text NOT NULL, minimum float8, maximum float8, choice text[])$t$,
        $t$COMMENT ON TABLE %1$I.setting IS 'Settings of the model; streetgen.set changes one, within its range'$t$,
        $t$CREATE TABLE %1$I.axis_class (class text PRIMARY KEY, taken boolean NOT NULL, width float8 CHECK (width BETWEEN 0.001 AND 200), speed float8 CHECK (speed BETWEEN 0 AND 400), importance integer CHECK (importance BETWEEN 1 AND 99))$t$,
        $t$COMMENT ON TABLE %1$I.axis_class IS 'Classes of a source: whether importers take them, and what axes of the class have where the source is silent (width m, speed km/h, importance 1 highest)'$t$,
        $t$CREATE TABLE %1$I.axis (
            axis_id bigint GENERATED BY DEFAULT AS IDENTITY PRIMARY KEY,
            geom geometry(LineString%2$s, %3$s) NOT NULL CONSTRAINT geom_is_a_finite_line CHECK (
                NOT ST_IsEmpty(geom) AND ST_XMin(geom) BETWEEN -1e12 AND 1e12 AND ST_XMax(geom) BETWEEN -1e12 AND 1e12
                AND ST_YMin(geom) BETWEEN -1e12 AND 1e12 AND ST_YMax(geom) BETWEEN -1e12 AND 1e12
                AND ST_ZMin(geom) BETWEEN -1e12 AND 1e12 AND ST_ZMax(geom) BETWEEN -1e12 AND 1e12 AND ST_3DLength(geom) < 'Infinity'
                AND ST_IsValid(geom) AND (ST_XMin(geom) < ST_XMax(geom) OR ST_YMin(geom) < ST_YMax(geom))),
            width float8 CHECK (width BETWEEN 0.001 AND 200), width_end float8 CHECK (width_end BETWEEN 0.001 AND 200),
            lane_count integer CHECK (lane_count BETWEEN 1 AND 30),
            direction text NOT NULL DEFAULT 'both' CHECK (direction IN ('both', 'direct', 'reverse')),
            speed float8 CHECK (speed BETWEEN 0.001 AND 400), importance integer CHECK (importance BETWEEN 1 AND 99),
            name text, level integer NOT NULL DEFAULT 0 CHECK (level BETWEEN -50 AND 50), kind text,
            radius float8 CHECK (radius BETWEEN 0 AND 200),
            lanes_forward integer CHECK (lanes_forward BETWEEN 0 AND 30), lanes_backward integer CHECK (lanes_backward BETWEEN 0 AND 30),
            kind_forward text CHECK (kind_forward ~ %4$L), kind_backward text CHECK (kind_backward ~ %4$L),
            lane_width_forward text CHECK (lane_width_forward ~ %5$L), lane_width_backward text CHECK (lane_width_backward ~ %5$L),
            turn_forward text CHECK (turn_forward ~ %6$L), turn_backward text CHECK (turn_backward ~ %6$L),
            source text, source_ref text, source_geom geometry,
            UNIQUE (source, source_ref))$t$,
        $t$CREATE INDEX axis_geom ON %1$I.axis USING gist (geom)$t$, $t$CREATE INDEX axis_width ON %1$I.axis (width)$t$,
        $t$COMMENT ON TABLE %1$I.axis IS 'Input: road axes. Only geom is obligatory. width, width_end, radius in metres (width kerb to kerb), speed km/h, importance 1 highest, direction along the line; what is known of single lanes stands in lists with |, from left to right in driving direction; source_geom is the line before cleaning'$t$,
        $t$CREATE TABLE %1$I.node (node_id bigint GENERATED BY DEFAULT AS IDENTITY PRIMARY KEY, geom geometry(Point%2$s, %3$s) NOT NULL)$t$,
        $t$CREATE INDEX node_geom ON %1$I.node USING gist (geom)$t$,
        $t$COMMENT ON TABLE %1$I.node IS 'Where axes meet or end'$t$,
        $t$CREATE TABLE %1$I.edge (
            edge_id bigint GENERATED BY DEFAULT AS IDENTITY PRIMARY KEY,
            axis_id bigint NOT NULL, -- no foreign key: the leftovers of a deleted axis stay until generate repairs the place
            from_node bigint NOT NULL REFERENCES %1$I.node, to_node bigint NOT NULL REFERENCES %1$I.node,
            level integer NOT NULL, start_abscissa float8 NOT NULL, end_abscissa float8 NOT NULL CHECK (end_abscissa > start_abscissa),
            geom geometry(LineString%2$s, %3$s) NOT NULL,
            width float8 NOT NULL, width_end float8 NOT NULL, lane_count integer NOT NULL, lanes_forward integer NOT NULL, lanes_backward integer NOT NULL, speed float8 NOT NULL, importance integer NOT NULL,
            estimated text[] NOT NULL, input_hash bigint NOT NULL, setting_hash bigint NOT NULL)$t$,
        $t$CREATE INDEX edge_width ON %1$I.edge ((greatest(width, width_end)))$t$,
        $t$CREATE INDEX edge_axis ON %1$I.edge (axis_id)$t$, $t$CREATE INDEX edge_from_node ON %1$I.edge (from_node)$t$,
        $t$CREATE INDEX edge_to_node ON %1$I.edge (to_node)$t$, $t$CREATE INDEX edge_geom ON %1$I.edge USING gist (geom)$t$,
        $t$COMMENT ON TABLE %1$I.edge IS 'Axes snapped and cut at nodes, with the values used; estimated names those that the source lacks. Abscissas in metres along the axis'$t$,
        $t$CREATE TABLE %1$I.section_limit (
            section_limit_id bigint GENERATED BY DEFAULT AS IDENTITY PRIMARY KEY,
            edge_id bigint NOT NULL REFERENCES %1$I.edge ON DELETE CASCADE, which text NOT NULL CHECK (which IN ('start', 'end')),
            wanted_abscissa float8 NOT NULL, abscissa float8 NOT NULL CHECK (abscissa >= 0),
            geom geometry(Point%2$s, %3$s) NOT NULL, border_line geometry(LineString, %3$s) NOT NULL, method text NOT NULL,
            UNIQUE (edge_id, which))$t$,
        $t$CREATE INDEX section_limit_geom ON %1$I.section_limit USING gist (geom)$t$,
        $t$COMMENT ON TABLE %1$I.section_limit IS 'Where the constant part of an edge begins and ends, abscissas in metres along the edge; border_line runs from the left to the right kerb'$t$,
        $t$CREATE TABLE %1$I.section (
            edge_id bigint PRIMARY KEY REFERENCES %1$I.edge ON DELETE CASCADE, level integer NOT NULL,
            surface geometry(MultiPolygon, %3$s) NOT NULL CONSTRAINT surface_is_valid CHECK (ST_IsValid(surface)), method text NOT NULL, contested_area float8 NOT NULL CHECK (contested_area >= 0))$t$,
        $t$CREATE INDEX section_surface ON %1$I.section USING gist (surface)$t$,
        $t$COMMENT ON TABLE %1$I.section IS 'Roadway of the constant part of an edge; empty where its limits crossed; contested_area (m2) went to another surface'$t$,
        $t$CREATE TABLE %1$I.corner (
            corner_id bigint GENERATED BY DEFAULT AS IDENTITY PRIMARY KEY,
            node_id bigint NOT NULL REFERENCES %1$I.node ON DELETE CASCADE,
            edge_a bigint NOT NULL REFERENCES %1$I.edge ON DELETE CASCADE, end_a text NOT NULL CHECK (end_a IN ('start', 'end')),
            edge_b bigint NOT NULL REFERENCES %1$I.edge ON DELETE CASCADE, end_b text NOT NULL CHECK (end_b IN ('start', 'end')),
            centre geometry(Point, %3$s), radius_wanted float8 NOT NULL, radius float8 NOT NULL, arc geometry(CircularString, %3$s), method text NOT NULL,
            UNIQUE (node_id, edge_a, end_a, edge_b, end_b))$t$,
        $t$CREATE INDEX corner_edge_a ON %1$I.corner (edge_a)$t$, $t$CREATE INDEX corner_edge_b ON %1$I.corner (edge_b)$t$,
        $t$CREATE INDEX corner_arc ON %1$I.corner USING gist (arc)$t$,
        $t$COMMENT ON TABLE %1$I.corner IS 'Kerb of a corner, counter-clockwise from edge_a to edge_b: true arc, centre, radius wanted and used (metres, 0 without an arc)'$t$,
        $t$CREATE TABLE %1$I.intersection (
            node_id bigint PRIMARY KEY REFERENCES %1$I.node ON DELETE CASCADE, level integer NOT NULL,
            surface geometry(MultiPolygon, %3$s) NOT NULL CONSTRAINT surface_is_valid CHECK (ST_IsValid(surface)), method text NOT NULL, contested_area float8 NOT NULL CHECK (contested_area >= 0))$t$,
        $t$CREATE INDEX intersection_surface ON %1$I.intersection USING gist (surface)$t$,
        $t$COMMENT ON TABLE %1$I.intersection IS 'Roadway about a node, out to the section limits'$t$,
        $t$CREATE TABLE %1$I.report (
            issue text NOT NULL, axis_a bigint NOT NULL, axis_b bigint NOT NULL, measure float8 NOT NULL, geom geometry(Point, %3$s) NOT NULL)$t$,
        $t$CREATE INDEX report_axis ON %1$I.report (axis_a)$t$,
        $t$COMMENT ON TABLE %1$I.report IS 'What the network step noticed: wide_cluster, crossing, collapsed_axis; check_model shows it'$t$
    ] LOOP
        EXECUTE format(statement, model, z, srid, streetgen._lane_list_pattern('kind'), streetgen._lane_list_pattern('width'), streetgen._lane_list_pattern('turn'));
    END LOOP;
    PERFORM streetgen._make_lane_tables(model, srid);
    PERFORM streetgen._make_interconnection_tables(model, srid);
    EXECUTE format('INSERT INTO %I.setting SELECT * FROM streetgen._default_setting()', model);
    EXECUTE format('INSERT INTO %I.axis_class SELECT * FROM streetgen._default_axis_class()', model);
    PERFORM streetgen._register_model(model, srid, dimension);
    PERFORM streetgen._add_tables(model, srid);
    PERFORM streetgen._make_views(model);
    PERFORM streetgen._make_functions(model);
    PERFORM streetgen._make_remap(model);
    PERFORM streetgen._make_edit_views(model);
    PERFORM streetgen._make_edit_log(model);
    PERFORM streetgen._comment_model(model);
END $$;
COMMENT ON FUNCTION streetgen.create_model(name, integer, integer) IS 'Makes schema model with the tables of a street model in the given SRID (projected, metres). An existing schema: 42P06; an unfit SRID: 22023 with a hint.';

CREATE OR REPLACE FUNCTION streetgen.drop_model(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._check_owner(model);
    EXECUTE format('DROP SCHEMA %I CASCADE', model);
    PERFORM streetgen._forget_models(), streetgen._forget_styles(model);
END $$;
COMMENT ON FUNCTION streetgen.drop_model(name) IS 'Drops the schema of a model with all in it, its QGIS project too, and the styles that QGIS keeps for its layers in public.layer_styles; a table of styles that belongs neither to the caller nor to a superuser, or may not be written, is left as it is.';

CREATE OR REPLACE FUNCTION streetgen._forget_styles(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    -- A table of somebody else could run his trigger with the rights of the caller.
    IF EXISTS (SELECT FROM pg_class c JOIN pg_roles r ON r.oid = relowner JOIN pg_attribute ON attrelid = c.oid WHERE c.oid = to_regclass('public.layer_styles') AND relkind = 'r'
               AND (r.rolsuper OR r.rolname = current_user) AND has_table_privilege(c.oid, 'SELECT') AND has_table_privilege(c.oid, 'DELETE') AND attname = 'f_table_schema' AND NOT attisdropped) THEN
        EXECUTE 'DELETE FROM public.layer_styles WHERE f_table_schema = $1' USING model;
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._forget_styles(name) IS 'Deletes the styles of the layers of a model from the table that QGIS keeps them in.';

CREATE OR REPLACE FUNCTION streetgen._forget_models() RETURNS void
    LANGUAGE sql VOLATILE PARALLEL UNSAFE SECURITY DEFINER SET search_path = pg_catalog, pg_temp
    AS $$ DELETE FROM streetgen.model m WHERE NOT EXISTS (SELECT FROM pg_namespace WHERE nspname = m.name) $$;
COMMENT ON FUNCTION streetgen._forget_models() IS 'Takes models whose schema is gone out of the registry.';

CREATE OR REPLACE FUNCTION streetgen.adopt_model(schema name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    srid integer;
    dimension integer;
    missing text[];
    reader oid;
BEGIN
    missing := ARRAY(SELECT name FROM unnest(ARRAY['setting', 'axis_class', 'axis', 'transition_override', 'node', 'edge', 'section_limit', 'section', 'corner', 'intersection', 'report']) name
        WHERE to_regclass(format('%I.%I', schema, name)) IS NULL);
    IF missing <> '{}' THEN
        RAISE EXCEPTION 'schema "%" holds no street model', schema USING ERRCODE = '3F000', HINT = format('Its tables %s are missing.', array_to_string(missing, ', '));
    END IF;
    SELECT g.srid, g.coord_dimension INTO srid, dimension FROM geometry_columns g
        WHERE f_table_schema = schema AND f_table_name = 'axis' AND f_geometry_column = 'geom';
    IF NOT FOUND OR srid = 0 THEN
        RAISE EXCEPTION 'schema "%" holds no street model', schema USING ERRCODE = '3F000', HINT = 'Its table axis has no column geom with an SRID.';
    END IF;
    PERFORM streetgen._register_model(schema, srid, dimension);
    PERFORM streetgen._add_tables(schema, srid);
    PERFORM streetgen._make_views(schema);
    PERFORM streetgen._make_functions(schema);
    PERFORM streetgen._make_remap(schema);
    PERFORM streetgen._make_edit_views(schema);
    PERFORM streetgen._make_edit_log(schema);
    PERFORM streetgen._grant_edit_views(schema);
    PERFORM streetgen._comment_model(schema);
    PERFORM streetgen._follow_again(schema);
    -- Who may read or write the axes may do so with what was lost or is new.
    FOR reader IN SELECT DISTINCT grantee FROM pg_class, aclexplode(relacl) WHERE oid = to_regclass(format('%I.axis', schema)) AND privilege_type = 'SELECT' AND grantee <> relowner LOOP
        EXECUTE format('GRANT SELECT ON %1$I.setting_used, %1$I.axis_used, %1$I.intersection_group, %1$I.conflict, %1$I.roadway, %1$I.section_limit_override, %1$I.corner_override, %1$I.kerb_point_override TO %2$s', schema, CASE reader WHEN 0 THEN 'PUBLIC' ELSE reader::regrole::text END);
    END LOOP;
    FOR reader IN SELECT DISTINCT grantee FROM pg_class, aclexplode(relacl) WHERE oid = to_regclass(format('%I.axis', schema)) AND privilege_type = 'INSERT' AND grantee <> relowner LOOP
        EXECUTE format('GRANT INSERT, UPDATE, DELETE ON %1$I.section_limit_override, %1$I.corner_override, %1$I.kerb_point_override TO %2$s', schema, CASE reader WHEN 0 THEN 'PUBLIC' ELSE reader::regrole::text END);
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen.adopt_model(name) IS 'Registers a schema that holds the tables of a model (after a restore, or DROP EXTENSION CASCADE) and puts its views and triggers back, with their comments and readers, also those by which it follows a table (a warning for one that it cannot follow); tables that came later are added. A schema without the tables: 3F000; one of another role: 42501.';

CREATE OR REPLACE FUNCTION streetgen.setting(model name)
    RETURNS TABLE(name text, value text, unit text, description text, minimum float8, maximum float8, choice text[])
    LANGUAGE plpgsql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._check_model(model);
    RETURN QUERY EXECUTE format('SELECT * FROM %I.setting ORDER BY name', model);
END $$;
COMMENT ON FUNCTION streetgen.setting(name) IS 'The settings of a model. An unknown model: 3F000.';

CREATE OR REPLACE FUNCTION streetgen._check_setting(model name, setting text, value text) RETURNS void
    LANGUAGE plpgsql STABLE PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    known record;
    holds boolean;
    expected text;
BEGIN
    SELECT * INTO known FROM streetgen._default_setting() d WHERE d.name = setting;
    IF NOT FOUND THEN
        RAISE EXCEPTION 'there is no setting "%"', setting USING ERRCODE = '22023', HINT = format('SELECT * FROM streetgen.setting(%L) lists them.', model);
    END IF;
    IF value IS NULL THEN
        IF setting = 'max_width_per_lane' THEN RETURN; END IF;
        RAISE EXCEPTION 'setting "%" of model "%" is NULL or missing', setting, model USING ERRCODE = '22004',
            HINT = format('SELECT streetgen.set(%L, %L, %L) puts the default back.', model, setting, known.value);
    END IF;
    IF known.choice IS NOT NULL THEN
        holds := value = ANY (known.choice) OR setting = 'trajectory' AND streetgen._trajectory_function(value) IS NOT NULL;
        expected := 'One of ' || array_to_string(known.choice, ', ') || CASE setting WHEN 'trajectory' THEN ', or a function (lane_in geometry, lane_out geometry, centre geometry, tolerance float8) returning geometry' ELSE '' END || '.';
    ELSIF known.minimum IS NOT NULL THEN
        holds := CASE WHEN value ~ '^\s*[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d{1,2})?\s*$' THEN value::float8 BETWEEN known.minimum AND known.maximum ELSE false END;
        expected := concat_ws(' ', 'Expected', known.minimum, 'to', known.maximum, known.unit);
    ELSE
        expected := 'Expected a JSON object of importance to number, such as {"1": 8, "2": 6.25}.';
        BEGIN
            -- Only a radius has another law to fall back on.
            holds := value = '' AND setting = 'radius_by_importance' OR NOT EXISTS (SELECT FROM jsonb_each_text(value::jsonb) e WHERE e.key !~ '^[1-9]\d?$' OR NOT (coalesce(e.value, '1')::float8 BETWEEN 0 AND 400));
        EXCEPTION WHEN data_exception THEN
            holds := false;
        END;
    END IF;
    IF NOT holds THEN
        RAISE EXCEPTION 'setting "%" of model "%" cannot be %', setting, model, quote_literal(value) USING ERRCODE = '22023', HINT = expected;
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._check_setting(name, text, text) IS 'Raises 22023 for an unknown setting or a value beyond the range, words or form of _default_setting, 22004 for NULL, saying how to put the default back.';

CREATE OR REPLACE FUNCTION streetgen._check_settings(model name) RETURNS void
    LANGUAGE plpgsql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    EXECUTE format('SELECT streetgen._check_setting(%L, d.name, s.value) FROM streetgen._default_setting() d LEFT JOIN %I.setting s USING (name)', model, model);
END $$;
COMMENT ON FUNCTION streetgen._check_settings(name) IS 'Raises as _check_setting for what was written or deleted in the setting table of a model without streetgen.set.';

CREATE OR REPLACE FUNCTION streetgen.set(model name, setting text, value text) RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._check_owner(model);
    PERFORM streetgen._check_setting(model, setting, value);
    EXECUTE format('INSERT INTO %I.setting AS s SELECT d.name, $2, d.unit, d.description, d.minimum, d.maximum, d.choice FROM streetgen._default_setting() d WHERE d.name = $1
        ON CONFLICT (name) DO UPDATE SET value = excluded.value WHERE s.value IS DISTINCT FROM excluded.value', model) USING setting, value;
END $$;
COMMENT ON FUNCTION streetgen.set(name, text, text) IS 'Changes a setting of a model within its range (22023 outside, 22004 for NULL), also one that was deleted; rows computed before are stale until generate.';

CREATE OR REPLACE FUNCTION streetgen.grant(model name, role name, kind text) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._check_owner(model);
    IF kind NOT IN ('reader', 'editor') THEN
        RAISE EXCEPTION 'unknown kind of right "%"', kind USING ERRCODE = '22023', HINT = 'reader or editor';
    ELSIF role <> 'public' AND NOT EXISTS (SELECT FROM pg_roles WHERE rolname = role) THEN
        RAISE EXCEPTION 'role "%" does not exist', role USING ERRCODE = '42704', HINT = 'SELECT rolname FROM pg_roles lists them; public is everybody.';
    END IF;
    EXECUTE format('GRANT USAGE ON SCHEMA %I TO %I', model, role);
    EXECUTE format('GRANT SELECT ON ALL TABLES IN SCHEMA %I TO %I', model, role);
    IF kind = 'editor' THEN
        EXECUTE format('GRANT INSERT, UPDATE, DELETE ON %1$I.axis, %1$I.turn_restriction, %1$I.transition_override, %1$I.lane_override, %1$I.interconnection_override, %1$I.section_limit_override, %1$I.corner_override, %1$I.kerb_point_override TO %2$I', model, role);
    END IF;
    PERFORM streetgen._grant_edit_views(model);
END $$;
COMMENT ON FUNCTION streetgen.grant(name, name, text) IS 'Gives a role the right to read a model (reader) or also to edit its input: axes, turn restrictions, overrides (editor); role public: everybody. An unknown role: 42704.';
