-- Random networks in storeys, which tests/battery/heights runs: after each edit a run over the whole model changes no overpass and no height.
CREATE SCHEMA heights;

-- A network lies in a model, flat or on hills. Do roads sink in it, too, and are there holes in what is known of its ground?
CREATE TYPE heights.network AS (model text, sinks boolean, holes boolean);

SELECT streetgen.create_model('flat', 2154, subjects => '{height}'), streetgen.create_model('hilly', 2154, 3, subjects => '{height}'),
  -- Edits reach little by themselves.
  streetgen.set('flat', 'reach', '25'), streetgen.set('hilly', 'reach', '25') \g /dev/null

CREATE TABLE heights.place (geom geometry);

CREATE FUNCTION heights.between(low float8, high float8) RETURNS float8 LANGUAGE sql VOLATILE RETURN round((low + (high - low) * random())::numeric, 2)::float8;

CREATE FUNCTION heights.one_of(VARIADIC words text[]) RETURNS text LANGUAGE sql VOLATILE RETURN words[1 + floor(random() * cardinality(words))::integer];

-- A place where roads end.
CREATE FUNCTION heights.place(near geometry DEFAULT NULL) RETURNS geometry LANGUAGE sql VOLATILE
  RETURN (SELECT geom FROM heights.place WHERE near IS NULL OR ST_Distance(geom, near) BETWEEN 30 AND 200 ORDER BY random() LIMIT 1);

-- A line of a network with the heights of its ground: hills of 12 m, each 250 m.
CREATE FUNCTION heights.drawn(network heights.network, line geometry) RETURNS geometry LANGUAGE sql VOLATILE AS $$
  SELECT CASE network.model WHEN 'flat' THEN line ELSE (SELECT ST_SetSRID(ST_MakeLine(ST_MakePoint(ST_X(geom), ST_Y(geom),
    CASE WHEN network.holes AND random() < 0.2 THEN -1000 ELSE 50 + 6 * sin(ST_X(geom) / 40) + 6 * cos(ST_Y(geom) / 40) END) ORDER BY path), 2154) FROM ST_DumpPoints(line)) END $$;

CREATE FUNCTION heights.road(network heights.network) RETURNS text LANGUAGE plpgsql VOLATILE AS $$
DECLARE
  a constant geometry := heights.place();
  b constant geometry := coalesce(heights.place(a), ST_Translate(a, 90, 20));
BEGIN
  RETURN format('(%L, %s, %s, %s)', heights.drawn(network, ST_MakeLine(ARRAY[a, ST_Translate(ST_LineInterpolatePoint(ST_MakeLine(a, b), heights.between(0.3, 0.7)), heights.between(-20, 20), heights.between(-20, 20)), b])),
    CASE WHEN network.sinks THEN heights.one_of('0', '0', '1', '-1', '-2') ELSE heights.one_of('0', '0', '1', '2') END, heights.one_of('30', '50', '50', '90'), heights.one_of('1', '3', '5'));
END $$;

-- One edit, as statements.
CREATE FUNCTION heights.edit(network heights.network) RETURNS text LANGUAGE plpgsql VOLATILE AS $$
DECLARE
  axis_id bigint;
  line geometry;
  other record;
  edit text := heights.one_of('move end', 'move end', 'move', 'draw', 'draw', 'delete', 'delete', 'level', 'level', 'level', 'speed', 'turn round', 'split', 'height', 'height', 'no height', 'overpass', 'overpass', 'no overpass', 'width');
BEGIN
  EXECUTE format('SELECT axis_id, geom FROM %I.axis ORDER BY axis_id OFFSET floor(random() * (SELECT count(*) FROM %1$I.axis)) LIMIT 1', network.model) INTO axis_id, line;
  CASE edit
    WHEN 'draw' THEN RETURN format('INSERT INTO @.axis (geom, level, speed, importance) VALUES %s', heights.road(network));
    WHEN 'delete' THEN RETURN format('DELETE FROM @.axis WHERE axis_id = %s', axis_id);
    WHEN 'level' THEN RETURN format('UPDATE @.axis SET level = %s WHERE axis_id = %s', CASE WHEN network.sinks THEN heights.one_of('0', '1', '2', '-1', '-2') ELSE heights.one_of('0', '1', '2') END, axis_id);
    WHEN 'speed' THEN RETURN format('UPDATE @.axis SET speed = %s WHERE axis_id = %s', heights.one_of('30', '50', '90', '130'), axis_id);
    WHEN 'width' THEN RETURN format('UPDATE @.axis SET width = %s WHERE axis_id = %s', heights.between(4, 12), axis_id);
    WHEN 'turn round' THEN RETURN format('UPDATE @.axis SET geom = ST_Reverse(geom) WHERE axis_id = %s', axis_id);
    WHEN 'move end' THEN
      RETURN format('UPDATE @.axis SET geom = %L WHERE axis_id = %s', heights.drawn(network, ST_SetPoint(ST_Force2D(line), heights.one_of('0', '-1')::integer, heights.place())), axis_id);
    WHEN 'move' THEN
      RETURN format('UPDATE @.axis SET geom = %L WHERE axis_id = %s', heights.drawn(network, ST_Translate(ST_Force2D(line), heights.between(-60, 60), heights.between(-60, 60))), axis_id);
    WHEN 'split' THEN
      RETURN format('INSERT INTO @.axis (geom, level, speed) SELECT ST_LineSubstring(geom, 0.5, 1), level, speed FROM @.axis WHERE axis_id = %s; UPDATE @.axis SET geom = ST_LineSubstring(geom, 0, 0.5) WHERE axis_id = %1$s', axis_id);
    WHEN 'height' THEN
      RETURN format('INSERT INTO @.height_override (axis_id, abscissa, height) VALUES (%s, %s, %s)', axis_id, heights.between(0, ST_Length(line)), CASE network.model WHEN 'flat' THEN heights.between(-2, 9) ELSE heights.between(45, 65) END);
    WHEN 'no height' THEN RETURN 'DELETE FROM @.height_override WHERE height_override_id = (SELECT min(height_override_id) FROM @.height_override)';
    WHEN 'no overpass' THEN RETURN 'DELETE FROM @.overpass_override WHERE overpass_override_id = (SELECT min(overpass_override_id) FROM @.overpass_override)';
    WHEN 'overpass' THEN
      EXECUTE format('SELECT ST_AsEWKT(o.geom) AS geom, a.axis_id AS above, b.axis_id AS below FROM %1$I.overpass o JOIN %1$I.edge a ON a.edge_id = edge_above JOIN %1$I.edge b ON b.edge_id = edge_below
        ORDER BY ST_X(o.geom) OFFSET floor(random() * (SELECT count(*) FROM %1$I.overpass)) LIMIT 1', network.model) INTO other;
      RETURN format('INSERT INTO @.overpass_override (geom, axis_above, axis_below, clearance) VALUES (%L, %s, %s, %s)', other.geom, coalesce(other.below, 0), coalesce(other.above, 0), heights.one_of('NULL', '4', '8'));
  END CASE;
END $$;

-- The rows that a whole run over a model changes, NULL where there are none; the model is as after the run then.
CREATE FUNCTION heights.changed_by_run(model text) RETURNS text LANGUAGE plpgsql VOLATILE AS $$
DECLARE
  changed text;
BEGIN
  EXECUTE format('CREATE TEMPORARY TABLE edited ON COMMIT DROP AS SELECT edge_id, p::text AS profile FROM %I.profile p', model);
  SELECT string_agg(format('%s: %s inserted, %s updated, %s deleted', relation, inserted, updated, deleted), '; ') INTO changed
    FROM streetgen.generate(model) WHERE inserted + updated + deleted > 0 AND relation IN ('node', 'edge', 'overpass', 'profile');
  EXECUTE format('SELECT concat_ws(E''\n'', $1, (SELECT string_agg(format(''  edge %%s: %%s | %%s'', edge_id, e.profile, p::text), E''\n'') FROM edited e FULL JOIN %I.profile p USING (edge_id) WHERE e.profile IS DISTINCT FROM p::text))', model)
    INTO changed USING changed;
  DROP TABLE edited;
  RETURN nullif(changed, '');
END $$;

CREATE TABLE heights.failure (seed integer, number integer, network text, statement text, what text);
-- The states that were tried, and how much was lifted, sunk and not kept in them.
CREATE TABLE heights.tried (edits integer, lifted integer, sunk integer, unkept integer);

-- The network of a seed, and so many edits of it.
CREATE PROCEDURE heights.run(seed integer, edits integer) LANGUAGE plpgsql AS $$
DECLARE
  network heights.network;
  statement text;
  what text;
BEGIN
  PERFORM setseed((seed::bigint * 7919 % 1000003) / 1000003.0);
  network := (heights.one_of('flat', 'flat', 'hilly'), random() < 0.7, random() < 0.5);
  EXECUTE replace('DELETE FROM @.axis; DELETE FROM @.height_override; DELETE FROM @.overpass_override', '@', network.model);
  DELETE FROM heights.place;
  INSERT INTO heights.place SELECT ST_SetSRID(ST_MakePoint(650000 + heights.between(0, 400), 6860000 + heights.between(0, 400)), 2154) FROM generate_series(1, 14);
  EXECUTE format('INSERT INTO %I.axis (geom, level, speed, importance) VALUES %s', network.model, (SELECT string_agg(heights.road(network), ', ') FROM generate_series(1, 18)));
  FOR i IN 0 .. edits LOOP
    BEGIN
      statement := CASE i WHEN 0 THEN 'SELECT' ELSE heights.edit(network) END;
      EXECUTE replace(statement, '@', network.model);
      what := heights.changed_by_run(network.model);
    EXCEPTION WHEN check_violation OR unique_violation OR invalid_parameter_value THEN
      what := NULL;
    END;
    IF what IS NOT NULL THEN
      INSERT INTO heights.failure VALUES (seed, i, network::text, statement, what);
    END IF;
    EXECUTE format('INSERT INTO heights.tried SELECT 1, count(*) FILTER (WHERE method = ''lifted''), count(*) FILTER (WHERE method = ''sunk''), (SELECT count(*) FROM streetgen.check_model(%L) WHERE rule = ''clearance not kept, m'') FROM %I.profile',
      network.model, network.model);
    COMMIT;
  END LOOP;
END $$;
