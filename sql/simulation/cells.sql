-- Links in equal cells, for a flow.

CREATE OR REPLACE FUNCTION streetgen._network_cells(network bytea, size float8)
    RETURNS TABLE(cell_id bigint, link_id bigint, ordinality integer, starts float8, ends float8, next bigint[],
        before bigint[], at_left bigint, may_go_left boolean, opposite_left boolean, at_right bigint,
        may_go_right boolean, opposite_right boolean)
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 1000 ROWS 10000 AS 'MODULE_PATHNAME', 'streetgen_cells';
COMMENT ON FUNCTION streetgen._network_cells(bytea, float8) IS
    'What streetgen.cells gives, of a network. Bytes that are no network, a size that is not 0.1 to 10,000 m: 22023.';

CREATE OR REPLACE FUNCTION streetgen.cells(model name, size float8 DEFAULT 10)
    RETURNS TABLE(cell_id bigint, link_id bigint, ordinality integer, starts float8, ends float8, next bigint[],
        before bigint[], at_left bigint, may_go_left boolean, opposite_left boolean, at_right bigint,
        may_go_right boolean, opposite_right boolean)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 10000 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_reader(model), streetgen._check_given('size', size::text),
        streetgen._require_subject(model, 'interconnection');
    RETURN QUERY SELECT c.* FROM streetgen._network_cells(streetgen._network_of_links(model), size) c;
END $$;
COMMENT ON FUNCTION streetgen.cells(name, float8) IS
    'The links of a model in equal cells, as many a link as come nearest to size, metres. cell_id counts cells over '
    'all links by link_id, and with a size of 10 m is that of streetgen.simulate; ordinality counts those of a link, '
    'each from starts to ends, metres along it. next and before: cells that traffic goes on to, and comes from. '
    'at_left and at_right: the cell beside the middle of this one; NULL: none. may_go_left, may_go_right: may a car '
    'change to it? opposite_left, opposite_right: does its traffic come towards? A size that is not 0.1 to 10,000 m: '
    '22023; NULL: 22004; a model without subject interconnection: 55000; an unknown model: 3F000; not a reader of the '
    'model: 42501. Wilkie, Sewall and Lin, section 3.2.';
