-- Who may drive: words of sources as those of axis.access.

CREATE OR REPLACE FUNCTION streetgen._access_word(said text) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE lower(btrim(said))
        WHEN 'no' THEN 'no' WHEN 'none' THEN 'no' WHEN 'closed' THEN 'no' WHEN 'agricultural' THEN 'no'
        WHEN 'forestry' THEN 'no' WHEN 'emergency' THEN 'no' WHEN 'military' THEN 'no' WHEN 'construction' THEN 'no'
        WHEN 'foot' THEN 'no'
        WHEN 'bus' THEN 'bus' WHEN 'psv' THEN 'bus' WHEN 'taxi' THEN 'bus'
        WHEN 'carpool' THEN 'carpool' WHEN 'hov' THEN 'carpool'
        WHEN 'cycle' THEN 'cycle' WHEN 'bicycle' THEN 'cycle'
        WHEN 'private' THEN 'private' WHEN 'permit' THEN 'private' WHEN 'residents' THEN 'private'
        WHEN 'resident' THEN 'private' WHEN 'employees' THEN 'private' WHEN 'restricted' THEN 'private'
        WHEN 'customers' THEN 'customers' WHEN 'customer' THEN 'customers'
        WHEN 'delivery' THEN 'delivery' WHEN 'loading' THEN 'delivery'
        WHEN 'destination' THEN 'destination' WHEN 'local' THEN 'destination'
        WHEN 'yes' THEN '' WHEN 'permissive' THEN '' WHEN 'public' THEN '' WHEN 'designated' THEN ''
        WHEN 'official' THEN '' WHEN 'discouraged' THEN '' WHEN 'use_sidepath' THEN '' WHEN 'unknown' THEN ''
        WHEN 'dismount' THEN 'no' WHEN '' THEN ''
        ELSE '?' END;
COMMENT ON FUNCTION streetgen._access_word(text) IS
    'The word of axis.access that a word of a source means; empty: all may drive; ?: it means nothing; NULL for NULL.';

CREATE OR REPLACE FUNCTION streetgen._read_access(said text) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    SELECT CASE WHEN cardinality(words) > 2 OR '?' = ANY (words) THEN '?'
        WHEN words[1] = coalesce(words[2], words[1]) THEN nullif(words[1], '') ELSE words[1] || '|' || words[2] END
    FROM (SELECT ARRAY(SELECT streetgen._access_word(word) FROM regexp_split_to_table(said, '\|') WITH ORDINALITY
        w(word, i) ORDER BY i) AS words) w $$;
COMMENT ON FUNCTION streetgen._read_access(text) IS
    'What a source says of who may drive, a word or two parted by |, as axis.access has it; ? where it means nothing.';

CREATE OR REPLACE FUNCTION streetgen._osm_access_of(said text) RETURNS text
    LANGUAGE plpgsql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
BEGIN
    IF strpos(said, ';') = 0 THEN
        RETURN streetgen._access_word(said);
    END IF;
    -- Of several words the one that lets most in.
    RETURN (SELECT word FROM (SELECT streetgen._access_word(w) AS word FROM regexp_split_to_table(said, ';') w) w
        ORDER BY array_position('{"",?,destination,customers,delivery,private,carpool,bus,cycle,no}'::text[], word)
        LIMIT 1);
END $$;
COMMENT ON FUNCTION streetgen._osm_access_of(text) IS
    'The word of axis.access that a value of an access tag of OSM means; empty: open, ?: it means nothing.';

CREATE OR REPLACE FUNCTION streetgen._osm_access_way(tags jsonb, class text, way text) RETURNS text
    -- A session plans it once.
    LANGUAGE plpgsql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
BEGIN
    -- The tag that is nearest to a vehicle decides, and of one tag that of the direction.
    RETURN (SELECT CASE WHEN car = '' AND reserved THEN 'carpool'
        -- Buses drive through where cars of the owner alone may drive.
        WHEN car = 'private' AND bus NOT IN ('no', '?', 'private') THEN 'bus'
        WHEN car NOT IN ('no', 'bus', 'carpool', 'cycle') THEN replace(car, '?', '')
        WHEN car <> 'no' THEN car
        WHEN coalesce(bus, CASE WHEN alone <> 'no' THEN '' END) NOT IN ('no', '?', 'private') THEN 'bus'
        WHEN hov NOT IN ('no', '?') THEN 'carpool'
        WHEN bicycle NOT IN ('no', '?', 'private') THEN 'cycle' ELSE 'no' END
    FROM (SELECT
            streetgen._osm_access_of(coalesce(tags ->> ('motorcar:' || way), tags ->> 'motorcar')) AS motorcar,
            streetgen._osm_access_of(coalesce(tags ->> ('motor_vehicle:' || way), tags ->> 'motor_vehicle')) AS motor,
            streetgen._osm_access_of(coalesce(tags ->> ('vehicle:' || way), tags ->> 'vehicle')) AS vehicle,
            streetgen._osm_access_of(coalesce(tags ->> ('access:' || way), tags ->> 'access')) AS every,
            streetgen._osm_access_of(coalesce(tags ->> ('bus:' || way), tags ->> 'bus', tags ->> ('psv:' || way),
                tags ->> 'psv', tags ->> 'taxi')) AS bus,
            streetgen._osm_access_of(coalesce(tags ->> ('hov:' || way), tags ->> 'hov')) AS hov,
            streetgen._osm_access_of(coalesce(tags ->> ('bicycle:' || way), tags ->> 'bicycle')) AS cycle,
            CASE class WHEN 'busway' THEN 'bus' WHEN 'bus_guideway' THEN 'bus' WHEN 'cycleway' THEN 'cycle'
                WHEN 'path' THEN 'cycle' WHEN 'pedestrian' THEN 'no' WHEN 'footway' THEN 'no' WHEN 'steps' THEN 'no'
                ELSE '' END AS usual) t,
        LATERAL (SELECT coalesce(motorcar, motor, vehicle, every, usual) AS car,
            -- Cars alone are shut out: other motor traffic is not.
            CASE WHEN motorcar = 'no' THEN coalesce(motor, vehicle, every, usual) ELSE 'no' END AS alone,
            coalesce(cycle, vehicle, CASE WHEN every IS NULL THEN nullif(usual, 'cycle') ELSE every END, '') AS bicycle,
            -- A list says which lanes are those of carpools.
            coalesce(tags ->> ('hov:' || way), tags ->> 'hov') = 'designated' AND NOT tags ?| ARRAY['hov:lanes',
                'hov:lanes:forward', 'hov:lanes:backward'] AS reserved) c);
END $$;
COMMENT ON FUNCTION streetgen._osm_access_way(jsonb, text, text) IS
    'Who may drive a way of OSM with such tags and of a class, in one direction (forward or backward), as a word of '
    'axis.access; empty: all.';

CREATE OR REPLACE FUNCTION streetgen._osm_access_both(tags jsonb, class text) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    SELECT CASE WHEN forward = backward THEN nullif(forward, '') ELSE forward || '|' || backward END
    FROM (SELECT streetgen._osm_access_way(tags, class, 'forward') AS forward,
        streetgen._osm_access_way(tags, class, 'backward') AS backward) w $$;
COMMENT ON FUNCTION streetgen._osm_access_both(jsonb, text) IS 'streetgen._osm_access, whatever the tags.';

-- Few ways say anything of it: the others are told by this alone, which is inlined.
CREATE OR REPLACE FUNCTION streetgen._osm_access(tags jsonb, class text) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE WHEN tags ?| ARRAY['access', 'access:forward', 'access:backward', 'vehicle', 'vehicle:forward',
            'vehicle:backward', 'motor_vehicle', 'motor_vehicle:forward', 'motor_vehicle:backward', 'motorcar',
            'motorcar:forward', 'motorcar:backward', 'hov', 'hov:forward', 'hov:backward']
            OR class IN ('busway', 'bus_guideway', 'cycleway', 'path', 'pedestrian', 'footway', 'steps')
        THEN streetgen._osm_access_both(tags, class) END;
COMMENT ON FUNCTION streetgen._osm_access(jsonb, text) IS
    'Who may drive a way of OSM with such tags and of a class, as axis.access has it.';
