-- A model's network in PostGIS topologies, and back.

-- What ValidateTopology finds in the topologies that were made.
CREATE FUNCTION test.topology_errors(made name[]) RETURNS bigint LANGUAGE plpgsql AS $$
BEGIN
  RETURN (SELECT count(*) FROM unnest(made) m, topology.ValidateTopology(m::varchar));
END $$;

-- Whether the network comes back equal, up to ids and without the edges that another doubled.
CREATE FUNCTION test.comes_back(model name, made name[], levels integer[], doubled bigint[]) RETURNS boolean LANGUAGE plpgsql AS $$
DECLARE
  equal boolean;
BEGIN
  PERFORM streetgen.create_model('come_back', srid, dimension) FROM streetgen.model m WHERE m.name = model;
  PERFORM streetgen.import_topology('come_back', t, l) FROM unnest(made, levels) m(t, l);
  PERFORM streetgen.generate('come_back');
  EXECUTE replace(replace(replace($q$
    SELECT NOT EXISTS ((@a EXCEPT ALL @b) UNION ALL (@b EXCEPT ALL @a))
       AND (SELECT array_agg(geom::text ORDER BY geom::text) FROM @.node) = (SELECT array_agg(geom::text ORDER BY geom::text) FROM come_back.node)$q$,
    '@a', '(SELECT level, geom::text FROM @.edge WHERE edge_id <> ALL ($1))'), '@b', '(SELECT level, geom::text FROM come_back.edge)'), '@', quote_ident(model))
    INTO equal USING doubled;
  PERFORM streetgen.drop_model('come_back');
  RETURN equal;
END $$;
