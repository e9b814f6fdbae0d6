-- A log of drives, sample by sample.

CREATE OR REPLACE FUNCTION streetgen._drive_report(network bytea, actors integer[], times float8[], x float8[],
    y float8[], heights float8[], speeds float8[], lengths float8[])
    RETURNS TABLE(link bigint, metres float8, lane_offset float8, against boolean, speed float8, over_limit float8,
        leader integer, gap float8, time_to_collision float8, finding text)
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100000 ROWS 10000 AS 'MODULE_PATHNAME', 'streetgen_drive_report';
COMMENT ON FUNCTION streetgen._drive_report(bytea, integer[], float8[], float8[], float8[], float8[], float8[],
    float8[]) IS
    'What streetgen.drive_report gives, of samples on a network. Actors are numbered from 0, NaN is not logged. A '
    'length out of 0.5 to 100 m: 22023.';

CREATE OR REPLACE FUNCTION streetgen._network_about(model name, x float8[], y float8[]) RETURNS bytea
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    SET plan_cache_mode = force_custom_plan
    AS $$
DECLARE
    box geometry;
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT ST_MakeEnvelope(min(s.x), min(s.y), max(s.x), max(s.y), m.srid) INTO box
        FROM unnest(x, y) s(x, y), streetgen.model m
        WHERE m.name = model AND abs(s.x) < 'infinity' AND abs(s.y) < 'infinity' GROUP BY m.srid;
    RETURN streetgen._network_of_lanes(model, ARRAY(SELECT l.lane_id FROM lane l WHERE l.geom && ST_Expand(box, 200)));
END $$;
COMMENT ON FUNCTION streetgen._network_about(name, float8[], float8[]) IS
    'The network of the lanes within 200 m of the box of some points, NaN left out.';

CREATE OR REPLACE FUNCTION streetgen.drive_report(model name, samples regclass, mapping jsonb DEFAULT '{}')
    RETURNS TABLE(sample bigint, t float8, actor text, link bigint, metres float8, lane_offset float8,
        against boolean, speed float8, over_limit float8, leader text, gap float8, time_to_collision float8,
        finding text, geom geometry)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 10000 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    log record;
    names text[];
    own_srid integer;
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_reader(model), streetgen._check_given('samples', samples::text, 'mapping',
        mapping::text), streetgen._require_subject(model, 'interconnection');
    EXECUTE streetgen._log_query(model, samples, mapping) INTO log;
    IF log.times IS NULL THEN
        RETURN;
    END IF;
    own_srid := (SELECT m.srid FROM streetgen.model m WHERE m.name = model);
    names := ARRAY(SELECT DISTINCT ON (n.number) n.actor FROM unnest(log.numbers, log.actors) n(number, actor)
        ORDER BY n.number);
    RETURN QUERY SELECT r.sample, nullif(r.t, 'NaN'), r.actor, r.link, r.metres, r.lane_offset, r.against, r.speed,
            r.over_limit, names[r.leader + 1], r.gap, r.time_to_collision, r.finding,
            CASE WHEN r.finding = 'no_place' THEN NULL
                WHEN r.z = 'NaN' THEN ST_SetSRID(ST_MakePoint(r.x, r.y), own_srid)
                ELSE ST_SetSRID(ST_MakePoint(r.x, r.y, r.z), own_srid) END
        FROM ROWS FROM (streetgen._drive_report(streetgen._network_about(model, log.x, log.y), log.numbers, log.times,
                log.x, log.y, log.z, log.speeds, log.lengths), unnest(log.times), unnest(log.actors), unnest(log.x),
                unnest(log.y), unnest(log.z)) WITH ORDINALITY
            r(link, metres, lane_offset, against, speed, over_limit, leader, gap, time_to_collision, finding, t, actor,
                x, y, z, sample);
END $$;
COMMENT ON FUNCTION streetgen.drive_report(name, regclass, jsonb) IS
    'A row for each sample of a log of drives, such as one of a driving simulator, in the order of time and actor. '
    'mapping names the columns of the log: time (seconds, or a timestamp), x and y, z, or geom (POINT, without SRID in '
    'that of the model) in place of these, actor (who drives; none: one alone), speed (km/h; none: from the places) '
    'and length (m; none: 5). Without it a column has the name itself. A place is that of the front of a car. link and '
    'metres: the lane or movement there, found for all samples of an actor together; lane_offset: metres to the left '
    'of its middle; against: does it drive against the traffic of the lane? over_limit: km/h above the speed that is '
    'allowed. leader: the next actor on its way, of those logged in the second before, of one that drives against the '
    'traffic on its link alone; gap: metres from bumper to bumper; time_to_collision: seconds, where both come nearer. '
    'finding: NULL, off_road (over 2 m beyond each lane), no_place or no_time (none, NaN), or twice (an actor has two '
    'samples of one time; one counts). The order of rows of the log does not count. A missing column: 42703; one of no '
    'numbers, a mapping that is none, a length out of 0.5 to 100 m: 22023; NULL: 22004; a model without subject '
    'interconnection: 55000; an unknown model: 3F000; not a reader of the model: 42501. Campos, section 3.4; Newson '
    'and Krumm 2009.';
