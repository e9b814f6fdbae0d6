-- The tables that osm2pgsql wrote get back the ids of the file, in place of those that osmium gave. Variable: tables, parted by commas; rows "type own given" come by standard input.
CREATE TEMPORARY TABLE own_id (type text, own bigint, given bigint, PRIMARY KEY (type, given));
\copy own_id FROM pstdin (DELIMITER ' ')
ANALYZE own_id;
-- The name of a column says whose id it holds: way_id, from_way; via_ways holds several, parted by commas. Column nodes counts them.
SELECT CASE WHEN named[2] = '' THEN format('UPDATE %s t SET %I = own FROM own_id WHERE type = %L AND given = %2$I', attrelid::regclass, attname, named[1])
    ELSE format('UPDATE %s t SET %I = (SELECT string_agg(own::text, '','' ORDER BY nth) FROM string_to_table(%2$I, '','') WITH ORDINALITY u(id, nth), own_id WHERE type = %L AND given = id::bigint)',
        attrelid::regclass, attname, named[1]) END
FROM string_to_table(:'tables', ', ') name JOIN pg_attribute ON attrelid = quote_ident(name)::regclass, regexp_match(attname, '(?:^|_)(node|way|relation)(?:_id|(s)|)$') m,
    LATERAL (SELECT ARRAY[m[1], coalesce(m[2], '')] AS named) n
WHERE attnum > 0 AND NOT attisdropped AND m IS NOT NULL AND attname <> 'nodes' \gexec
