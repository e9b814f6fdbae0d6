-- Ids of files: numbers that programs of 32 bits read, from the ids of a model.

CREATE OR REPLACE FUNCTION streetgen._no_file_id(kind text, id bigint, part integer) RETURNS bigint
    LANGUAGE plpgsql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
BEGIN
    RAISE EXCEPTION '% %, part %, has no id in files: they number those from 1 to 33554431', kind, id, part
        USING ERRCODE = '22003', HINT = 'A new model of the same axes has ids that begin at 1.';
END $$;
COMMENT ON FUNCTION streetgen._no_file_id(text, bigint, integer) IS
    'An error, 22003, about an id that is beyond those that files have.';

-- The remainder by 64 says kind and part.
CREATE OR REPLACE FUNCTION streetgen._file_id(kind text, id bigint, part integer DEFAULT 0) RETURNS bigint
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE WHEN id BETWEEN 1 AND 33554431 AND part >= 0 THEN id * 64 + part + CASE
            WHEN kind = 'node' AND part < 1 THEN 0 WHEN kind = 'object' AND part < 1 THEN 1
            WHEN kind = 'lane' AND part < 4 THEN 2 WHEN kind = 'edge' AND part < 10 THEN 6
            WHEN kind = 'movement' AND part < 10 THEN 16 WHEN kind = 'entry' AND part < 2 THEN 26
            WHEN kind = 'bridge' AND part < 2 THEN 28 WHEN kind = 'tunnel' AND part < 2 THEN 30
            WHEN kind = 'interconnection' AND part < 32 THEN 32
            ELSE streetgen._no_file_id(kind, id, part) END
        ELSE streetgen._no_file_id(kind, id, part) END;
COMMENT ON FUNCTION streetgen._file_id(text, bigint, integer) IS
    'The id in files of an edge, a lane, the entry of a lane, a node, an interconnection, a movement, an object, a '
    'bridge or a tunnel: below 2^31, no two alike, and the same as long as the model keeps its own id. part: from 0, '
    'where one has several in a file, less than 2 of an entry, a bridge and a tunnel, 4 of a lane, 10 of an edge and '
    'of a movement, and 32 of an interconnection. An id beyond 33,554,431, a part beyond those of its kind, or an '
    'unknown kind: 22003.';
