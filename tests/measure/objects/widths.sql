-- Widths across a hundred places drawn at random against what the sources state: psql -v seed=SEED. Models neukoelln_w,
-- cambridge_w, montpellier_w, and tables of lines and sidewalks of these names. A row a town and a thing: places that
-- state it, and how many widths are within 0.1 m; then each that is neither that nor told. Tags and columns are read
-- here, not by the importers.
SET client_min_messages = warning;
CREATE TEMP TABLE stated (model text, axis_id bigint, what text, side text, metres float8);
CREATE FUNCTION pg_temp.metres(said text) RETURNS float8 LANGUAGE sql AS $$
  SELECT CASE WHEN said ~ '^\d+(\.\d+)?( ?m)?$' THEN substring(said FROM '^[0-9.]+')::float8 END $$;
CREATE PROCEDURE pg_temp.read_tags(model text) LANGUAGE plpgsql AS $$ BEGIN
  EXECUTE format($q$INSERT INTO stated SELECT %1$L, a.axis_id, s.what, s.side, s.metres
    FROM %2$I l JOIN %1$I.axis a ON split_part(a.source_ref, '/', 1) = l.way_id::text, LATERAL (
      SELECT 'roadway' AS what, NULL AS side, pg_temp.metres(tags ->> 'width') AS metres
      UNION ALL SELECT 'sidewalk', side, pg_temp.metres(coalesce(tags ->> ('sidewalk:' || side || ':width'),
        tags ->> 'sidewalk:both:width')) FROM unnest('{left,right}'::text[]) side
      UNION ALL SELECT 'cycle lane', side, pg_temp.metres(coalesce(tags ->> ('cycleway:' || side || ':width'),
        tags ->> 'cycleway:both:width')) FROM unnest('{left,right}'::text[]) side
        WHERE coalesce(tags ->> ('cycleway:' || side), tags ->> 'cycleway:both') = 'lane') s
    WHERE s.metres IS NOT NULL AND l.class !~ 'foot|path|steps|cycle|pedestrian|track'$q$, model, model || '_line');
END $$;
CALL pg_temp.read_tags('neukoelln_w');
CALL pg_temp.read_tags('cambridge_w');
INSERT INTO stated SELECT 'montpellier_w', a.axis_id, 'sidewalk', s.side, s.metres
  FROM montpellier_w_sidewalk w JOIN montpellier_w.axis a ON split_part(split_part(a.source_ref, '/', 1), '#',
    1) = w.id_arc::text,
    LATERAL (VALUES ('left', w.acv_ilar), ('right', w.acv_plar)) s(side, metres) WHERE s.metres BETWEEN 0.5 AND 8;
-- Places in the middle of edges of 30 m and more between their limits: nobody says where a width ends.
CREATE TEMP TABLE place (model text, axis_id bigint, metres float8);
CREATE PROCEDURE pg_temp.draw(model text, in_all integer, seed integer) LANGUAGE plpgsql AS $$ BEGIN
  EXECUTE format($q$INSERT INTO place SELECT %1$L, axis_id, middle FROM (
    SELECT DISTINCT ON (e.axis_id) e.axis_id, e.start_abscissa + (a.abscissa + b.abscissa) / 2 AS middle,
      hashint8extended(e.axis_id, $2) AS turn
    FROM %1$I.edge e JOIN %1$I.section_limit a ON (a.edge_id, a.which) = (e.edge_id, 'start')
      JOIN %1$I.section_limit b ON (b.edge_id, b.which) = (e.edge_id, 'end')
    WHERE b.abscissa - a.abscissa > 30 AND e.axis_id IN (SELECT axis_id FROM stated WHERE model = %1$L)
      ORDER BY e.axis_id, e.start_abscissa) p ORDER BY turn LIMIT $1 - (SELECT count(*) FROM place)$q$, model)
      USING in_all, seed;
END $$;
-- Neukölln states the widths of few streets: the others have the rest of the hundred.
CALL pg_temp.draw('neukoelln_w', 34, :seed);
CALL pg_temp.draw('cambridge_w', 67, :seed);
CALL pg_temp.draw('montpellier_w', 100, :seed);
CREATE TEMP TABLE piece AS
SELECT p.model, p.axis_id, c.side, c.kind, c.offset_from, c.offset_to, bool_or(c.kind = 'kerb')
  OVER (PARTITION BY p.model, p.axis_id, c.side ORDER BY c."order") AS behind
FROM place p, LATERAL streetgen.cross_section(p.model, p.axis_id, p.metres) c;
CREATE TEMP TABLE found AS
SELECT p.model, p.axis_id, p.metres AS at, s.what, s.side, s.metres AS stated, round((CASE s.what
    WHEN 'roadway' THEN (SELECT sum(offset_to - offset_from) FROM piece c WHERE (c.model, c.axis_id) = (p.model,
      p.axis_id) AND NOT behind AND kind <> 'kerb')
    WHEN 'cycle lane' THEN (SELECT sum(offset_to - offset_from) FROM piece c WHERE (c.model, c.axis_id,
      c.side) = (p.model, p.axis_id, s.side) AND kind = 'cycle')
    ELSE (SELECT sum(offset_to - offset_from) FROM piece c WHERE (c.model, c.axis_id, c.side) = (p.model, p.axis_id,
      s.side) AND behind AND kind <> 'bay' AND offset_to IS NOT NULL) END)::numeric, 3) AS found
FROM place p JOIN stated s USING (model, axis_id);
-- A width of a source that is too wide for its lanes is not believed, and the import says so: such a place is told.
ALTER TABLE found ADD told boolean DEFAULT false;
CREATE PROCEDURE pg_temp.tell(model text) LANGUAGE plpgsql AS $$ BEGIN
  EXECUTE format('UPDATE found f SET told = true FROM %1$I.axis_used u WHERE f.model = %1$L AND f.what = ''roadway''
    AND u.axis_id = f.axis_id AND ''width'' = ANY (u.estimated)', model);
END $$;
CALL pg_temp.tell('neukoelln_w');
CALL pg_temp.tell('cambridge_w');
SELECT '| town | width of | places | stated | within 0.1 m | told as not believed | other |
|---|---|---|---|---|---|---|';
SELECT format('| %s | %s | %s | %s | %s | %s | %s |', replace(model, '_w', ''), what, count(DISTINCT axis_id),
  count(*), count(*) FILTER (WHERE near), count(*) FILTER (WHERE NOT near AND told), count(*) FILTER (WHERE NOT near
  AND NOT told))
    FROM (SELECT *, abs(found - stated) <= 0.1 IS TRUE AS near FROM found) f GROUP BY model, what ORDER BY model, what;
SELECT format('%s places of %s', count(DISTINCT (model, axis_id)), (SELECT count(*) FROM place)) FROM found;
SELECT format('other: %s axis %s at %s: %s %s %s, found %s', model, axis_id, round(at::numeric, 1), what, side, stated,
  found) FROM found WHERE NOT told AND abs(found - stated) <= 0.1 IS NOT TRUE ORDER BY 1;
