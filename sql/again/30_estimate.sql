-- What a source lacks is estimated when read, never written back to axis.  The coefficients are
-- settings of the model and come in as arguments, so that no result depends on anything else.

CREATE OR REPLACE FUNCTION streetgen.estimated_width(
  lane_count integer, class_width float8, speed float8 DEFAULT NULL, lane_width float8 DEFAULT 3,
  lane_width_fast float8 DEFAULT 3.5, fast_speed float8 DEFAULT 70, width_margin float8 DEFAULT 1,
  default_width float8 DEFAULT 7) RETURNS float8
LANGUAGE sql IMMUTABLE PARALLEL SAFE
RETURN CASE WHEN lane_count IS NOT NULL
              THEN least(200, lane_count * CASE WHEN speed >= fast_speed THEN lane_width_fast ELSE lane_width END + width_margin)
            ELSE coalesce(class_width, default_width) END;
COMMENT ON FUNCTION streetgen.estimated_width(integer, float8, float8, float8, float8, float8, float8, float8)
  IS 'width kerb to kerb, metres: lanes times their width and a margin; without lanes the width of the class, else the default';

CREATE OR REPLACE FUNCTION streetgen.estimated_speed(
  speed_of_importance float8, width float8, speed_per_width float8 DEFAULT 7) RETURNS float8
LANGUAGE sql IMMUTABLE PARALLEL SAFE
RETURN coalesce(speed_of_importance, least(90, greatest(10, speed_per_width * width)));
COMMENT ON FUNCTION streetgen.estimated_speed(float8, float8, float8)
  IS 'speed, km/h: that of the importance, else from the width, between 10 and 90';

CREATE OR REPLACE FUNCTION streetgen.estimated_lane_count(
  width float8, speed float8, lane_width float8 DEFAULT 3, lane_width_fast float8 DEFAULT 3.5,
  fast_speed float8 DEFAULT 70, width_margin float8 DEFAULT 1) RETURNS integer
LANGUAGE sql IMMUTABLE PARALLEL SAFE
RETURN greatest(1, least(60, round((width - width_margin)
         / CASE WHEN speed >= fast_speed THEN lane_width_fast ELSE lane_width END)))::integer;
COMMENT ON FUNCTION streetgen.estimated_lane_count(float8, float8, float8, float8, float8, float8)
  IS 'number of lanes that a width holds at a speed, at least one';

-- The entry with the greatest importance number that is not above the axis' own.
CREATE OR REPLACE FUNCTION streetgen._of_importance(by_importance jsonb, importance integer) RETURNS jsonb
LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, pg_temp
AS $$
  SELECT e.value FROM jsonb_each(by_importance) e
  WHERE e.key::integer <= importance ORDER BY e.key::integer DESC LIMIT 1
$$;
COMMENT ON FUNCTION streetgen._of_importance(jsonb, integer)
  IS 'entry of a table by importance; a gap takes the entry before it; JSON null where that is the entry, NULL where there is none';

CREATE OR REPLACE FUNCTION streetgen.wanted_radius(
  own_radius float8, radius_of_importance jsonb, speed float8, width float8, mode text DEFAULT 'paper') RETURNS float8
LANGUAGE sql IMMUTABLE PARALLEL SAFE
RETURN CASE WHEN own_radius IS NOT NULL THEN own_radius
            WHEN radius_of_importance = 'null'::jsonb THEN 0
            WHEN radius_of_importance IS NOT NULL THEN radius_of_importance::float8
            ELSE streetgen.turning_radius(speed, width, mode) END;
COMMENT ON FUNCTION streetgen.wanted_radius(float8, jsonb, float8, float8, text)
  IS 'wanted radius of an axis'' corners, metres, 0 for none: its own, else that of its importance (JSON null: none), else turning_radius';

CREATE OR REPLACE FUNCTION streetgen._used_axes(model name, axes bigint[] DEFAULT NULL)
RETURNS TABLE (axis_id bigint, geom geometry, width float8, width_end float8, lane_count integer, direction text,
               speed float8, importance integer, level integer, radius float8, estimated text[],
               input_hash bigint, setting_hash bigint)
LANGUAGE plpgsql STABLE PARALLEL RESTRICTED ROWS 20000 SET search_path = streetgen, public, pg_catalog, pg_temp
AS $$
#variable_conflict use_column
DECLARE
  s jsonb := streetgen._settings(model);
  hashed bigint := hashtextextended(s::text, 0);
BEGIN
  RETURN QUERY EXECUTE replace(replace($q$
    WITH by_importance AS MATERIALIZED (
      SELECT i AS importance, streetgen._of_importance(($2->>'radius_by_importance')::jsonb, i) AS radius,
             nullif(streetgen._of_importance(($2->>'speed_by_importance')::jsonb, i), 'null')::float8 AS speed
      FROM generate_series(1, 99) i),
    known AS (
      SELECT a.*, coalesce(a.importance, c.importance) AS importance_used, c.width AS class_width,
             coalesce(a.speed, c.speed, i.speed) AS known_speed, i.radius AS radius_of_importance
      FROM @.axis a
      LEFT JOIN @.axis_class c ON c.class = a.kind
      LEFT JOIN by_importance i ON i.importance = coalesce(a.importance, c.importance)
      <filter>),
    wide AS (
      SELECT k.*, coalesce(k.width, streetgen.estimated_width(k.lane_count, k.class_width, k.known_speed,
               ($2->>'lane_width')::float8, ($2->>'lane_width_fast')::float8, ($2->>'fast_speed')::float8,
               ($2->>'width_margin')::float8, ($2->>'default_width')::float8)) AS width_used
      FROM known k),
    fast AS (
      SELECT w.*, streetgen.estimated_speed(w.known_speed, w.width_used, ($2->>'speed_per_width')::float8) AS speed_used
      FROM wide w),
    used AS (
      SELECT f.axis_id, f.geom, f.width_used AS width, coalesce(f.width_end, f.width_used) AS width_end,
             coalesce(f.lane_count, streetgen.estimated_lane_count(f.width_used, f.speed_used,
               ($2->>'lane_width')::float8, ($2->>'lane_width_fast')::float8, ($2->>'fast_speed')::float8,
               ($2->>'width_margin')::float8)) AS lane_count,
             f.direction, f.speed_used AS speed, f.importance_used AS importance, f.level,
             streetgen.wanted_radius(f.radius, f.radius_of_importance, f.speed_used, f.width_used, $2->>'radius_mode') AS radius,
             array_remove(ARRAY[CASE WHEN f.width IS NULL THEN 'width' END, CASE WHEN f.lane_count IS NULL THEN 'lane_count' END,
                                CASE WHEN f.speed IS NULL THEN 'speed' END, CASE WHEN f.importance IS NULL THEN 'importance' END,
                                CASE WHEN f.radius IS NULL THEN 'radius' END], NULL) AS estimated
      FROM fast f)
    SELECT u.*, hashtextextended(concat_ws('|', encode(u.geom::bytea, 'hex'), u.width, u.width_end, u.lane_count, u.direction,
                                           u.speed, u.importance, u.level, u.radius, u.estimated), 0), $3
    FROM used u$q$, '<filter>', CASE WHEN axes IS NULL THEN '' ELSE 'WHERE a.axis_id = ANY ($1)' END), '@', quote_ident(model))
    USING axes, s, hashed;
END
$$;
COMMENT ON FUNCTION streetgen._used_axes(name, bigint[])
  IS 'the axes of a model, or those asked for, with every value estimated where it is NULL, and hashes of what they come from';
