\set ECHO none
\ir shared/truths.sql
-- A street is cut in two: decisions by hand on the new piece go over to it, whichever piece is written first.
\set subjects all
\o /dev/null
\ir ../../data/quarter.sql
\ir shared/by_hand.sql
-- A kerb point near where its axis is cut, and a limit near the end of its axis.
INSERT INTO quarter.kerb_point_override (axis_id, geom) SELECT axis_id, ST_Translate(ST_LineInterpolatePoint(geom, 0.5), 0, 6) FROM quarter.axis WHERE axis_id = 1;
INSERT INTO quarter.section_limit_override (axis_id, abscissa, which) SELECT axis_id, ST_Length(geom) - 2, 'end' FROM quarter.axis WHERE axis_id = 2;
\o
CREATE FUNCTION pg_temp.relations() RETURNS SETOF text LANGUAGE sql AS $$
  SELECT relation::text FROM streetgen._decision() WHERE axes <> '{}' ORDER BY 1 $$;
SELECT 'a row of each table of decisions at axes', array_agg(r) = ARRAY(SELECT DISTINCT relation FROM quarter.override_place ORDER BY 1) AND count(*) > 15 FROM pg_temp.relations() r;
-- The rows of all these tables by their keys.
CREATE FUNCTION pg_temp.decided() RETURNS TABLE (relation text, id bigint, said jsonb) LANGUAGE plpgsql AS $$
DECLARE r text;
BEGIN
  FOR r IN SELECT pg_temp.relations() LOOP
    RETURN QUERY EXECUTE format('SELECT %1$L, %2$I, to_jsonb(o) FROM quarter.%1$I o', r, r || '_id');
  END LOOP;
END $$;
-- Each cut has its place on the new piece, which gets a key of its own.
CREATE TABLE public.cut AS
  SELECT o.relation, o.override_id AS id, role, o.axis_id, start, line, 1000 + o.axis_id AS new_id, CASE WHEN start THEN 0.45 * at ELSE 0.55 + 0.45 * at END AS at
  FROM quarter.override_place o JOIN quarter.axis a USING (axis_id), ST_Force2D(a.geom) line, ST_LineLocatePoint(line, o.geom) at, LATERAL (SELECT at > 0.5 AS start) s;
INSERT INTO public.cut SELECT relation, id, role, axis_id, true, line, new_id, 0.5 - 1 / ST_Length(line) FROM public.cut WHERE (relation, axis_id) = ('kerb_point_override', 1);
INSERT INTO public.cut SELECT relation, id, role, axis_id, true, line, new_id, 1 - 3 / ST_Length(line) FROM public.cut WHERE (relation, axis_id, start) = ('section_limit_override', 2, true);
CREATE FUNCTION pg_temp.write_piece(c public.cut, new boolean, turned boolean) RETURNS void LANGUAGE plpgsql AS $$
DECLARE
  piece geometry := CASE WHEN new = c.start THEN ST_LineSubstring(c.line, c.at, 1) ELSE ST_LineSubstring(c.line, 0, c.at) END;
BEGIN
  IF new THEN
    INSERT INTO quarter.axis (axis_id, geom, width, width_end, lane_count, importance, level, kind, direction) SELECT c.new_id, CASE WHEN turned THEN ST_Reverse(piece) ELSE piece END, width, width_end, lane_count, importance, level, kind,
      CASE WHEN turned AND direction <> 'both' THEN 'reverse' ELSE direction END FROM quarter.axis WHERE axis_id = c.axis_id;
  ELSE
    UPDATE quarter.axis SET geom = piece WHERE axis_id = c.axis_id;
  END IF;
END $$;
-- What is decided after a cut, all of which is taken back.
CREATE FUNCTION pg_temp.after_cut(c public.cut, new_first boolean, turned boolean) RETURNS TABLE (relation text, id bigint, said jsonb) LANGUAGE plpgsql AS $$
DECLARE rows jsonb;
BEGIN
  BEGIN
    PERFORM pg_temp.write_piece(c, new_first, turned);
    PERFORM pg_temp.write_piece(c, NOT new_first, turned);
    SELECT jsonb_agg(to_jsonb(d)) FROM pg_temp.decided() d INTO rows;
    RAISE SQLSTATE 'TT000';
  EXCEPTION WHEN SQLSTATE 'TT000' THEN
    RETURN QUERY SELECT d.* FROM jsonb_to_recordset(rows) d(relation text, id bigint, said jsonb);
  END;
END $$;
SET streetgen.live = off;
CREATE TABLE public.tried AS SELECT c.*, turned, o.relation AS of, o.id AS of_id, o.said AS old_first, n.said AS new_first
  FROM public.cut c CROSS JOIN (VALUES (false), (true)) v(turned) CROSS JOIN LATERAL pg_temp.after_cut(c, false, turned) o
    CROSS JOIN LATERAL pg_temp.after_cut(c, true, turned) n WHERE (o.relation, o.id) = (n.relation, n.id);
RESET streetgen.live;
SELECT format('either order gives the same rows of %s%s', of, CASE WHEN turned THEN ', where the new piece is turned' END), bool_and(old_first = new_first) FROM public.tried GROUP BY of, turned ORDER BY of, turned;
SELECT format('%s of %s goes to the new piece', role, relation), bool_and(new_first ->> role = new_id::text) FROM public.tried
  WHERE (relation, id) = (of, of_id) AND role NOT LIKE 'via%' GROUP BY relation, role ORDER BY relation, role;

-- A street is drawn again from its other end: with another key before or after it goes, while streets follow; or with its own.
CREATE FUNCTION pg_temp.after_drawing(old bigint, new bigint, old_first boolean) RETURNS TABLE (relation text, id bigint, said jsonb) LANGUAGE plpgsql AS $$
DECLARE
  street quarter.axis;
  rows jsonb;
BEGIN
  SELECT * INTO street FROM quarter.axis WHERE axis_id = old;
  street.axis_id := new;
  -- As wide as the old one is by hand: that stays the street while both lie there.
  street.width := (SELECT width FROM quarter.axis_used WHERE axis_id = old);
  street.source_ref := street.source_ref || ' again';
  street.geom := ST_Reverse(street.geom);
  street.direction := CASE street.direction WHEN 'direct' THEN 'reverse' WHEN 'reverse' THEN 'direct' ELSE street.direction END;
  BEGIN
    IF new = old AND NOT old_first THEN
      UPDATE quarter.axis SET geom = street.geom, direction = street.direction WHERE axis_id = old;
    ELSE
      IF NOT old_first THEN
        INSERT INTO quarter.axis SELECT street.*;
      END IF;
      DELETE FROM quarter.axis WHERE axis_id = old;
      IF old_first THEN
        INSERT INTO quarter.axis SELECT street.*;
      END IF;
    END IF;
    SELECT jsonb_agg(to_jsonb(d)) FROM pg_temp.decided() d INTO rows;
    RAISE SQLSTATE 'TT000';
  EXCEPTION WHEN SQLSTATE 'TT000' THEN
    RETURN QUERY SELECT d.* FROM jsonb_to_recordset(rows) d(relation text, id bigint, said jsonb);
  END;
END $$;
CREATE TABLE public.drawn AS SELECT 'with another key' AS how, axis_id, o.relation, o.id, o.said AS old_first, n.said AS new_first FROM (SELECT DISTINCT axis_id FROM quarter.override_place) a
  CROSS JOIN LATERAL pg_temp.after_drawing(axis_id, 1000 + axis_id, true) o CROSS JOIN LATERAL pg_temp.after_drawing(axis_id, 1000 + axis_id, false) n WHERE (o.relation, o.id) = (n.relation, n.id);
SET streetgen.live = off;
INSERT INTO public.drawn SELECT 'with its own key', axis_id, o.relation, o.id, o.said, n.said FROM (SELECT DISTINCT axis_id FROM quarter.override_place) a
  CROSS JOIN LATERAL pg_temp.after_drawing(axis_id, axis_id, true) o CROSS JOIN LATERAL pg_temp.after_drawing(axis_id, axis_id, false) n WHERE (o.relation, o.id) = (n.relation, n.id);
RESET streetgen.live;
-- A control point at a node goes to another axis there as soon as its own is gone.
SELECT format('drawn again %s from its other end, the same rows of %s', how, relation), bool_and(old_first = new_first) FROM public.drawn WHERE (how, relation) <> ('with its own key', 'control_point') GROUP BY how, relation ORDER BY how, relation;
SELECT 'those about a side, a direction or a lane are turned', count(DISTINCT (relation, k)) >= 8 FROM public.drawn JOIN pg_temp.decided() d USING (relation, id), unnest('{side,which,direction,along_axis,ordinality,lane_from,lane_to,lane_in,lane_out,along_in,along_out}'::text[]) k
  WHERE d.said -> k <> old_first -> k;

-- Cut in two transactions, while streets follow.
CREATE TABLE public.told AS SELECT rule, relation, id FROM streetgen.check_model('quarter') WHERE relation LIKE '%override' OR relation = 'control_point';
CREATE PROCEDURE pg_temp.cut_live() LANGUAGE plpgsql AS $$
DECLARE c public.cut;
BEGIN
  FOR c IN SELECT DISTINCT ON (axis_id) * FROM public.cut ORDER BY axis_id, relation, id, role LOOP
    PERFORM pg_temp.write_piece(c, true, false);
    COMMIT;
    PERFORM pg_temp.write_piece(c, false, false);
    COMMIT;
  END LOOP;
END $$;
CALL pg_temp.cut_live();
SELECT format('cut in two transactions, %s lies on its axis', relation), bool_and(ST_DWithin(a.geom, o.geom, o.reach) AND streetgen._metres_beyond(a.geom, o.geom) < 0.5)
  FROM quarter.override_place o JOIN quarter.axis a USING (axis_id) GROUP BY relation ORDER BY relation;
SELECT 'and most on new pieces', count(DISTINCT relation) FILTER (WHERE axis_id > 1000) > 12 FROM quarter.override_place;
SELECT 'check_model tells of no other than before', array_agg((rule, relation, id)::text) IS NULL FROM ((SELECT rule, relation, id FROM streetgen.check_model('quarter') WHERE relation LIKE '%override' OR relation = 'control_point') EXCEPT TABLE public.told) t;
SELECT 'the streets are as generated from scratch', sum(inserted + updated + deleted) = 0 FROM streetgen.generate('quarter', wait => true);

-- What is cut off and drawn nowhere is told.
SELECT streetgen.create_model('town', 2154) \g /dev/null
INSERT INTO town.axis (axis_id, geom, width) VALUES (1, 'SRID=2154;LINESTRING(650000 6860000, 650100 6860000)', 7), (2, 'SRID=2154;LINESTRING(650100 6860000, 650100 6860080)', 7), (3, 'SRID=2154;LINESTRING(650100 6860000, 650100 6859920)', 7);
INSERT INTO town.kerb_point_override (axis_id, geom) SELECT 1, ST_SetSRID(ST_Point(650000 + at, 6860004), 2154) FROM unnest('{20, 48, 53, 90}'::float8[]) at;
INSERT INTO town.control_point (geom, kind) SELECT ST_SetSRID(ST_Point(650000 + at, 6860002), 2154), 'stop' FROM unnest('{20, 80}'::float8[]) at;
CREATE FUNCTION pg_temp.told() RETURNS text LANGUAGE sql AS $$
  SELECT string_agg(format('%s %s', split_part(rule, ' ', 1), round(ST_X(geom)) - 650000), ', ' ORDER BY rule, ST_X(geom)) FROM streetgen.check_model('town') WHERE relation IN ('kerb_point_override', 'control_point') $$;
SELECT 'on the street nothing is told', pg_temp.told() IS NULL;
UPDATE town.axis SET geom = 'SRID=2154;LINESTRING(650000 6860000, 650050 6860000)' WHERE axis_id = 1;
SELECT 'kerb points and control points off their axis are told', pg_temp.told() = 'control 80, kerb 53, kerb 90';
SELECT 'the kerb point just past its axis keeps it', array_agg(axis_id) = '{1,1,1,1}' FROM town.kerb_point_override;
INSERT INTO town.axis (axis_id, geom, width) VALUES (4, 'SRID=2154;LINESTRING(650050 6860000, 650100 6860000)', 7);
SELECT 'they go to the piece that comes', array_agg(axis_id ORDER BY ST_X(geom)) = '{1,1,4,4}' AND pg_temp.told() IS NULL FROM town.kerb_point_override;
-- Both pieces are new, and the old street goes last: beside a place 2 m past its middle, too.
INSERT INTO town.lane_override (axis_id, abscissa, ordinality, width) VALUES (2, 42, 1, 3);
INSERT INTO town.axis (axis_id, geom, width) VALUES (5, 'SRID=2154;LINESTRING(650100 6860000, 650100 6860040)', 7), (6, 'SRID=2154;LINESTRING(650100 6860040, 650100 6860080)', 7);
DELETE FROM town.axis WHERE axis_id = 2;
SELECT 'of two new pieces the one beside takes it', (axis_id, abscissa) = (6, 2) FROM town.lane_override;
