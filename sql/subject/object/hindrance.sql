-- What keeps an object from standing at a place: for rules, which place none there, and for check_model, which tells.

CREATE OR REPLACE FUNCTION streetgen._in_mouth(axis geometry, abscissa float8, width float8, angle float8,
    place geometry) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    BEGIN ATOMIC
        -- A pole beside the mouth leaves a hand's breadth.
        SELECT abs((ST_X(place) - ST_X(foot)) * cosd(across) - (ST_Y(place) - ST_Y(foot)) * sind(across))
            < (width / 2 + 0.3) * sind(angle)
        FROM (SELECT streetgen._direction_on(axis::bytea, abscissa, 0) - angle AS across,
            streetgen._place_on(axis::bytea, abscissa, 0)::geometry AS foot) c;
    END;
COMMENT ON FUNCTION streetgen._in_mouth(geometry, float8, float8, float8, geometry) IS
    'Whether a place lies in the strip of a crossing, drawn on beyond its kerbs, by the axis and abscissa, width and '
    'angle of the crossing.';

CREATE OR REPLACE FUNCTION streetgen._make_hindrances(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE OR REPLACE FUNCTION _types_on_roadway() RETURNS text[]
        LANGUAGE sql STABLE SET search_path FROM CURRENT
        AS $body$
        SELECT array_agg(DISTINCT below)
        FROM unnest('{crossing,parking_bay,arrow,manhole,runway_light,tram_stop,traffic_calming}'::text[]) above,
            unnest(_types_below(above)) below $body$;
    CREATE OR REPLACE FUNCTION _object_spacing() RETURNS TABLE(type text, other text, metres float8)
        LANGUAGE sql STABLE ROWS 50 SET search_path FROM CURRENT
        AS $body$
        WITH RECURSIVE below(above, type) AS (SELECT t.type, t.type FROM object_type t
            UNION SELECT b.above, t.type FROM below b JOIN object_type t ON t.parent = b.type),
        said AS MATERIALIZED (SELECT a.type, b.type AS other, metres FROM object_distance
            JOIN below a ON a.above = type_a JOIN below b ON b.above = type_b)
        SELECT type, other, max(metres) FROM (
            SELECT type, other, metres FROM said UNION ALL SELECT other, type, metres FROM said
            -- Things of one kind never stand on each other. Bays have ground that tells.
            UNION ALL SELECT t.type, t.type, 1 FROM object_type t
                WHERE t.type NOT IN (SELECT b.type FROM below b WHERE b.above = 'parking_bay')) d
        WHERE metres > 0 GROUP BY type, other $body$;
    CREATE OR REPLACE FUNCTION _object_spread() RETURNS TABLE(type text, reach float8, farthest float8)
        LANGUAGE plpgsql STABLE ROWS 10 SET search_path FROM CURRENT
        AS $body$
    #variable_conflict use_column
    BEGIN
        RETURN QUERY
        WITH spacing AS MATERIALIZED (SELECT * FROM _object_spacing()),
        ruled AS MATERIALIZED (
            SELECT type, max(abs(axis_offset)) AS aside FROM placement_rule WHERE active GROUP BY type),
        -- All that keeps an object from a place, other objects aside, lies no farther away.
        hindered AS MATERIALIZED (
            SELECT greatest(4, max(value::float8) FILTER (WHERE name = 'line_sight'),
                max(value::float8) FILTER (WHERE name = 'median_tree_width') + 0.3 + (SELECT max(aside) FROM ruled),
                (SELECT max(distance_least) FROM object_type), (SELECT max(metres) FROM spacing
                    WHERE other = ANY (_types_below('crossing')))) AS metres
            FROM setting WHERE name IN ('line_sight', 'median_tree_width')),
        reached AS MATERIALIZED (
            SELECT type, aside, coalesce((SELECT max(s.metres) FROM spacing s WHERE s.type = r.type), 0) + h.metres
                AS reach
            FROM ruled r, hindered h)
        SELECT type, reach, aside + greatest(reach, (SELECT max(q.reach + s.metres)
            FROM reached q JOIN spacing s ON s.type = q.type WHERE s.other = r.type)) FROM reached r;
    END $body$;
    CREATE OR REPLACE FUNCTION _hindrances(places streetgen.standing_place[])
        RETURNS TABLE(number bigint, hindrance text)
        LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 10 SET search_path FROM CURRENT SET jit = off
        -- What lies about each place is looked up by the spatial indexes, for few places and for all.
        SET enable_nestloop = on SET enable_hashjoin = off SET enable_mergejoin = off SET enable_seqscan = off
        AS $body$
    #variable_conflict use_column
    DECLARE
        sight constant float8 := (SELECT value::float8 FROM setting WHERE name = 'line_sight');
        median constant float8 := (SELECT value::float8 FROM setting WHERE name = 'median_tree_width');
        crossings constant text[] := _types_below('crossing');
        trees constant text[] := _types_below('tree');
        seen constant text[] := _types_below('sign') || _types_below('traffic_light');
        on_roadway constant text[] := _types_on_roadway();
    BEGIN
        IF places IS NULL THEN
            RETURN;
        END IF;
        RETURN QUERY SELECT number, 'near'
        FROM unnest(places) WITH ORDINALITY p(type, geom, level, away, by_kerb, self, number)
            JOIN (SELECT type, max(metres) AS metres FROM _object_spacing() GROUP BY type) most USING (type)
        WHERE EXISTS (SELECT FROM street_object o JOIN _object_spacing() s ON s.other = o.type
            WHERE o.placed_by <> 'rule' AND ST_DWithin(o.geom, p.geom, most.metres) AND s.type = p.type
                AND coalesce((SELECT a.level FROM axis a WHERE a.axis_id = o.axis_id), p.level) = p.level
                AND ST_DWithin(o.geom, p.geom, s.metres) AND o.street_object_id IS DISTINCT FROM p.self
                AND (o.type <> ALL (crossings) OR p.type = ANY (crossings)));
        RETURN QUERY SELECT number, 'underground'
        FROM unnest(places) WITH ORDINALITY p(type, geom, level, away, by_kerb, self, number)
        WHERE level < 0 AND type <> ALL (on_roadway);
        RETURN QUERY SELECT number, 'roadway'
        FROM unnest(places) WITH ORDINALITY p(type, geom, level, away, by_kerb, self, number)
        WHERE type <> ALL (on_roadway) AND EXISTS (SELECT FROM section s WHERE s.surface && p.geom
                AND s.level = p.level AND ST_Intersects(s.surface, p.geom)
                -- What stands on the border itself is off it by rounding.
                AND (abs(coalesce(p.away, 1)) > 0.01 OR ST_Distance(ST_Boundary(s.surface), p.geom) > 0.01)
            UNION ALL SELECT FROM intersection i WHERE i.surface && p.geom AND i.level = p.level
                AND ST_Intersects(i.surface, p.geom)
                AND (abs(coalesce(p.away, 1)) > 0.01 OR ST_Distance(ST_Boundary(i.surface), p.geom) > 0.01));
        RETURN QUERY SELECT number, 'bay'
        FROM unnest(places) WITH ORDINALITY p(type, geom, level, away, by_kerb, self, number)
        WHERE type <> ALL (on_roadway) AND EXISTS (SELECT FROM parking_bay b
                JOIN street_object o USING (street_object_id) JOIN axis a USING (axis_id)
            WHERE b.surface && p.geom AND a.level = p.level AND ST_Contains(b.surface, p.geom));
        -- Four metres: one does not wait for the crossing farther from the kerb.
        RETURN QUERY SELECT DISTINCT p.number,
            CASE WHEN streetgen._in_mouth(l.line, l.abscissa, c.width, c.angle, p.geom)
                    AND ST_DWithin(c.surface, p.geom, 4) THEN 'mouth'
                ELSE 'near' END
        FROM unnest(places) WITH ORDINALITY p(type, geom, level, away, by_kerb, self, number)
            LEFT JOIN (SELECT type, max(metres) AS metres FROM _object_spacing() WHERE other = ANY (crossings)
                GROUP BY type) most ON most.type = p.type
            -- Each place looks for the few crossings about it, also where the tables are new and their size unknown.
            CROSS JOIN LATERAL (SELECT * FROM pedestrian_crossing c
                WHERE ST_DWithin(c.surface, p.geom, greatest(4, most.metres)) OFFSET 0) c
            JOIN street_object o USING (street_object_id) JOIN axis a USING (axis_id),
            LATERAL (SELECT ST_Force2D(a.geom) AS line, a.level, o.abscissa OFFSET 0) l
        WHERE p.type <> ALL (on_roadway) AND l.level = p.level
            AND (ST_DWithin(c.surface, p.geom, most.metres)
                OR streetgen._in_mouth(l.line, l.abscissa, c.width, c.angle, p.geom)
                AND ST_DWithin(c.surface, p.geom, 4));
        IF to_regclass('marking') IS NOT NULL THEN
            RETURN QUERY SELECT number, 'sight'
            FROM unnest(places) WITH ORDINALITY p(type, geom, level, away, by_kerb, self, number)
            WHERE by_kerb AND type <> ALL (seen || on_roadway)
                AND EXISTS (SELECT FROM marking m JOIN edge e USING (edge_id)
                WHERE m.kind IN ('stop', 'yield') AND ST_DWithin(m.geom, p.geom, sight) AND e.level = p.level
                    AND NOT ST_IsEmpty(m.surface));
        END IF;
        -- A model of an older build may have objects without kerbs.
        IF to_regclass('kerb') IS NOT NULL THEN
            RETURN QUERY SELECT number, CASE WHEN k.foot IS NULL THEN 'no_kerb'
                ELSE 'median' END
            FROM unnest(places) WITH ORDINALITY p(type, geom, level, away, by_kerb, self, number)
                LEFT JOIN LATERAL (
                    SELECT ST_ClosestPoint(k.geom, p.geom) AS foot, k.beside, ST_Distance(k.geom, p.geom) AS distance
                    FROM kerb k WHERE ST_DWithin(k.geom, p.geom, abs(p.away) + 0.3) AND k.level = p.level
                        AND k.method <> 'level_change' ORDER BY 3, 2 LIMIT 1) k ON true
            WHERE by_kerb AND (k.foot IS NULL OR k.beside = 'median' AND type = ANY (trees) AND k.distance > 0.01
                AND (SELECT EXISTS (SELECT FROM section s WHERE ST_Intersects(s.surface, way) AND s.level = p.level)
                        OR EXISTS (SELECT FROM intersection i WHERE ST_Intersects(i.surface, way)
                            AND i.level = p.level)
                    FROM (SELECT ST_MakeLine(p.geom, ST_Translate(k.foot,
                        (ST_X(p.geom) - ST_X(k.foot)) / k.distance * median,
                        (ST_Y(p.geom) - ST_Y(k.foot)) / k.distance * median)) AS way OFFSET 0) w));
        END IF;
    END $body$;
    CREATE OR REPLACE FUNCTION _near_earlier(numbers bigint[], places streetgen.standing_place[], rules bigint[],
        axes bigint[], every float8[], asked boolean[]) RETURNS TABLE(number bigint, earlier bigint)
        LANGUAGE sql STABLE ROWS 10 SET search_path FROM CURRENT SET jit = off
        -- An object gives way also where the earlier one gives way itself: what stands depends on what is near
        -- alone. Places of the same cell of a grid are joined by hash, however few are expected.
        SET enable_nestloop = off SET enable_mergejoin = off
        AS $body$
        WITH place AS MATERIALIZED (
            SELECT number, type, level, rule, axis, every, asked, ST_X(geom) AS x, ST_Y(geom) AS y
            FROM ROWS FROM (unnest(numbers), unnest(places), unnest(rules), unnest(axes), unnest(every), unnest(asked))
                p(number, type, geom, level, away, by_kerb, self, rule, axis, every, asked)),
        spaced AS MATERIALIZED (SELECT *, 2 * metres AS cell FROM _object_spacing()),
        offered AS MATERIALIZED (
            SELECT p.*, s.metres, floor(x / cell) AS cell_x, floor(y / cell) AS cell_y
            FROM place p JOIN (SELECT DISTINCT other, metres, cell FROM spaced) s ON s.other = p.type),
        wanted AS MATERIALIZED (
            SELECT p.*, s.other, s.metres, cell_x, cell_y FROM place p JOIN spaced s USING (type),
                LATERAL unnest(ARRAY[floor((x - metres) / cell), floor((x + metres) / cell)]) cell_x,
                LATERAL unnest(ARRAY[floor((y - metres) / cell), floor((y + metres) / cell)]) cell_y
            WHERE p.asked)
        SELECT DISTINCT w.number, o.number FROM wanted w JOIN offered o ON (o.type, o.metres, o.cell_x, o.cell_y)
            = (w.other, w.metres, w.cell_x, w.cell_y)
        WHERE o.number < w.number AND o.level = w.level AND (o.rule, o.axis) <> (w.rule, w.axis)
            AND (o.x - w.x) ^ 2 + (o.y - w.y) ^ 2
                < least(w.metres, CASE WHEN o.rule = w.rule THEN 0.9 * w.every END) ^ 2 $body$;
    PERFORM streetgen._own_function(model, '_object_spread()',
        'How far from ground that changed another object may stand, by types of rules (reach, m), and how far from it '
        'a street lies whose objects these may give way to (farthest, m)');
    PERFORM streetgen._own_function(model,
        '_near_earlier(bigint[], streetgen.standing_place[], bigint[], bigint[], float8[], boolean[])',
        'Which places of rules, of those that are asked for, are too near to earlier ones, in the order of '
        'the rules; those of one rule along one axis are as far apart as the rule says'),
        streetgen._own_function(model, '_types_on_roadway()', 'The types of objects that lie on the roadway'),
        streetgen._own_function(model, '_object_spacing()',
        'How far objects of a type keep from those of another one, both ways, metres'),
        streetgen._own_function(model, '_hindrances(streetgen.standing_place[])',
        'What keeps objects from standing at places, a row each: the number of the place and a word, of '
        'which check_model makes a rule');
END $$;
COMMENT ON FUNCTION streetgen._make_hindrances(name) IS
    'Makes the functions of a model that tell where objects cannot stand.';
