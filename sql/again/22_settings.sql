-- Settings of a model: what they are, read and set.

CREATE OR REPLACE FUNCTION streetgen._create_settings(model name) RETURNS void
LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = streetgen, public, pg_catalog, pg_temp
AS $$
BEGIN
  EXECUTE format($q$
INSERT INTO %1$I.setting (name, value, unit, description, minimum, maximum, allowed, optional) VALUES
  ('tolerance', '0.5', 'm', 'ends and vertices this near meet', 0.001, 10, NULL, false),
  ('crossing', 'over', NULL, 'axes of one level that cross without a vertex pass over each other, or are split there', NULL, NULL, '{over,split}', false),
  ('max_arc_distance', '60', 'm', 'a corner whose arc has its centre farther from the node gets the minimal radius', 1, 1000, NULL, false),
  ('radius_minimal', '0.15', 'm', 'radius of such a corner: that of a kerb stone', 0, 10, NULL, false),
  ('radius_rule', 'min', NULL, 'the radius of a corner from those of its two axes', NULL, NULL, '{min,max,mean}', false),
  ('radius_by_importance', '{"1": 8, "2": 6.25, "3": 6.25, "4": 3}', 'm', 'wanted radius by importance as JSON; the last entry holds for all beyond; null: no arc; {}: from speed', NULL, NULL, NULL, false),
  ('radius_mode', 'paper', NULL, 'mode of turning_radius', NULL, NULL, '{paper,setra}', false),
  ('transition_length', '10', 'm', 'length of the transition where two axes of different width meet', 0, 1000, NULL, false),
  ('transition_kind', 'symmetric', NULL, 'which side of a transition moves', NULL, NULL, '{symmetric,left,right}', false),
  ('round_dead_ends', 'false', NULL, 'do dead ends end round or flat', NULL, NULL, '{true,false}', false),
  ('max_hole_area', '0.5', 'm2', 'smaller holes between surfaces go to a neighbour', 0, 1000, NULL, false),
  ('reach', '60', 'm', 'how far along the network an axis can have influence', 1, 1000, NULL, false),
  ('cell_size', '200', 'm', 'size of the cells that generate locks', 10, 100000, NULL, false),
  ('default_width', '7', 'm', 'width where neither width, lanes nor class are known', 0.5, 200, NULL, false),
  ('lane_width', '3', 'm', 'width of a lane', 1, 10, NULL, false),
  ('lane_width_fast', '3.5', 'm', 'width of a lane at fast_speed and above', 1, 10, NULL, false),
  ('fast_speed', '70', 'km/h', 'from this speed on lanes are wider', 1, 500, NULL, false),
  ('width_margin', '1', 'm', 'what a roadway is wider than its lanes', 0, 10, NULL, false),
  ('max_width_per_lane', '5.5', 'm', 'a source''s width over this for each lane that the source states is not believed; NULL: all are', 1, 100, NULL, true),
  ('speed_by_importance', '{"1": 90, "2": 70, "3": 50, "4": 50, "5": 30}', 'km/h', 'speed by importance as JSON; the last entry holds for all beyond', NULL, NULL, NULL, false),
  ('speed_per_width', '7', 'km/h/m', 'speed for each metre of width where importance is unknown', 0.1, 100, NULL, false),
  ('import_tolerance', '0.3', 'm', 'cleaning: points nearer to each other than this are one', 0, 10, NULL, false),
  ('import_radius', '3', 'm', 'cleaning: a bend tighter than this radius is straightened', 0, 100, NULL, false)
$q$, model);
  EXECUTE format($q$
INSERT INTO %1$I.axis_class (class, taken, width, speed, importance) VALUES
  ('motorway', true, 8, 120, 1), ('motorway_link', true, 5, 60, 1),
  ('trunk', true, 8, 90, 1), ('trunk_link', true, 5, 60, 1),
  ('primary', true, 8, 50, 2), ('primary_link', true, 5, 50, 2),
  ('secondary', true, 7.5, 50, 3), ('secondary_link', true, 5, 50, 3),
  ('tertiary', true, 7, 50, 4), ('tertiary_link', true, 5, 50, 4),
  ('unclassified', true, 6, 50, 5), ('residential', true, 6, 30, 5), ('living_street', true, 5, 20, 5),
  ('road', true, 6, 50, 5), ('service', true, 4, 20, 6),
  ('runway', true, 40, 300, 1), ('taxiway', true, 20, 50, 2),
  ('highway', true, 8, 90, 1), ('major', true, 8, 50, 3), ('minor', true, 6, 30, 5),
  ('track', false, 3, 20, 7), ('pedestrian', false, 5, 10, 7), ('footway', false, 2, 5, 8),
  ('path', false, 1.5, 5, 8), ('cycleway', false, 2, 20, 8), ('steps', false, 2, 5, 8)
$q$, model);
END
$$;
COMMENT ON FUNCTION streetgen._create_settings(name) IS 'fills the settings and classes of a new model';

CREATE OR REPLACE FUNCTION streetgen.setting(model name)
RETURNS TABLE (name text, value text, unit text, description text, minimum float8, maximum float8, allowed text[])
LANGUAGE plpgsql STABLE PARALLEL RESTRICTED SET search_path = streetgen, public, pg_catalog, pg_temp
AS $$
BEGIN
  PERFORM streetgen._need_model(model, false);
  RETURN QUERY EXECUTE format('SELECT s.name, s.value, s.unit, s.description, s.minimum, s.maximum, s.allowed '
                              'FROM %I.setting s ORDER BY s.name', model);
END
$$;
COMMENT ON FUNCTION streetgen.setting(name) IS 'the settings of a model, with units and ranges';

CREATE OR REPLACE FUNCTION streetgen._settings(model name) RETURNS jsonb
LANGUAGE plpgsql STABLE STRICT PARALLEL RESTRICTED SET search_path = streetgen, public, pg_catalog, pg_temp
AS $$
DECLARE
  result jsonb;
BEGIN
  EXECUTE format('SELECT jsonb_object_agg(s.name, s.value) FROM %I.setting s', model) INTO result;
  RETURN result;
END
$$;
COMMENT ON FUNCTION streetgen._settings(name) IS 'the settings of a model as one object of texts';

-- A table by importance: {"1": 8, "4": null}.
CREATE OR REPLACE FUNCTION streetgen._is_importance_table(value text, minimum float8, maximum float8) RETURNS boolean
LANGUAGE plpgsql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog, pg_temp
AS $$
BEGIN
  RETURN jsonb_typeof(value::jsonb) = 'object'
     AND NOT EXISTS (SELECT FROM jsonb_each(value::jsonb) e
                     WHERE e.key !~ '^[1-9][0-9]?$'
                        OR CASE jsonb_typeof(e.value)
                             WHEN 'number' THEN NOT (e.value::float8 BETWEEN minimum AND maximum)
                             WHEN 'null' THEN false ELSE true END);
EXCEPTION WHEN invalid_text_representation OR numeric_value_out_of_range THEN
  RETURN false;
END
$$;
COMMENT ON FUNCTION streetgen._is_importance_table(text, float8, float8) IS 'is a text a JSON object from importance to number or null';

CREATE OR REPLACE FUNCTION streetgen.set(model name, name text, value text) RETURNS void
LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = streetgen, public, pg_catalog, pg_temp
AS $$
#variable_conflict use_variable
DECLARE
  old record;
  number float8;
BEGIN
  PERFORM streetgen._need_model(model, true);
  EXECUTE format('SELECT * FROM %I.setting s WHERE s.name = $1 FOR UPDATE', model) INTO old USING name;
  IF old.name IS NULL THEN
    RAISE EXCEPTION 'there is no setting "%"', coalesce(name, 'NULL')
      USING ERRCODE = '22023', HINT = format('SELECT * FROM streetgen.setting(%L) lists them.', model);
  ELSIF value IS NULL THEN
    IF NOT old.optional THEN
      RAISE EXCEPTION 'setting "%" cannot be NULL', name USING ERRCODE = '22004';
    END IF;
  ELSIF old.minimum IS NOT NULL THEN
    BEGIN
      number := value::float8;
    EXCEPTION WHEN invalid_text_representation OR numeric_value_out_of_range THEN
      RAISE EXCEPTION 'setting "%" is a number, not "%"', name, value USING ERRCODE = '22023';
    END;
    IF NOT number BETWEEN old.minimum AND old.maximum THEN
      RAISE EXCEPTION 'setting "%" is % to %, not %', name, old.minimum, old.maximum, value USING ERRCODE = '22023';
    END IF;
  ELSIF old.allowed IS NOT NULL THEN
    IF NOT value = ANY (old.allowed) THEN
      RAISE EXCEPTION 'setting "%" is one of %, not "%"', name, array_to_string(old.allowed, ', '), value
        USING ERRCODE = '22023';
    END IF;
  ELSIF name = 'radius_by_importance' AND NOT streetgen._is_importance_table(value, 0, 1000)
        OR name = 'speed_by_importance' AND NOT streetgen._is_importance_table(value, 1, 500) THEN
    RAISE EXCEPTION 'setting "%" is a JSON object from importance to number or null, not "%"', name, value
      USING ERRCODE = '22023', HINT = 'For example {"1": 8, "2": 6.25, "4": null}.';
  END IF;
  EXECUTE format('UPDATE %I.setting SET value = $2 WHERE name = $1 AND value IS DISTINCT FROM $2', model) USING name, value;
END
$$;
COMMENT ON FUNCTION streetgen.set(name, text, text) IS 'sets a setting of a model, within its range; generate again to see the effect';
