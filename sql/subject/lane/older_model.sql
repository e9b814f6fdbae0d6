-- Columns that models of older builds lack, with what they mean for the rows that are there.

CREATE OR REPLACE FUNCTION streetgen._add_both_ways(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    -- Filling in a column is no edit by hand.
    SET streetgen.computes = 'on'
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF NOT streetgen._lacks_column(model, 'axis', 'lanes_both') THEN
        RETURN;
    END IF;
    ALTER TABLE axis ADD lanes_both integer CHECK (lanes_both BETWEEN 0 AND 30);
    ALTER TABLE turn_restriction ADD except_kinds text
        CHECK (except_kinds ~ '^(bus|carpool|cycle)(\|(bus|carpool|cycle)){0,9}$');
    ALTER TABLE lane_override ADD both_ways boolean;
    ALTER TABLE interconnection_override ADD along_in boolean, ADD along_out boolean;
    ALTER TABLE edge ADD lanes_both integer NOT NULL DEFAULT 0;
    ALTER TABLE edge ALTER lanes_both DROP DEFAULT;
    -- Lanes computed before have one direction each.
    ALTER TABLE lane ADD both_ways boolean NOT NULL DEFAULT false CHECK (along_axis OR NOT both_ways);
    ALTER TABLE marking ADD along_axis boolean, DROP CONSTRAINT IF EXISTS marking_edge_id_kind_lane_position_key,
        ADD UNIQUE (edge_id, kind, lane_position, along_axis);
    UPDATE marking m SET along_axis = coalesce((SELECT l.along_axis FROM lane l
        WHERE (l.edge_id, l.lane_position) = (m.edge_id, m.lane_position)), true);
    ALTER TABLE marking ALTER along_axis SET NOT NULL;
    ALTER TABLE interconnection ADD along_in boolean, ADD along_out boolean,
        DROP CONSTRAINT IF EXISTS interconnection_lane_in_lane_out_key,
        ADD UNIQUE (lane_in, lane_out, along_in, along_out);
    UPDATE interconnection c SET along_in = i.along_axis, along_out = o.along_axis FROM lane i, lane o
        WHERE (i.lane_id, o.lane_id) = (c.lane_in, c.lane_out);
    ALTER TABLE interconnection ALTER along_in SET NOT NULL, ALTER along_out SET NOT NULL;
END $$;
COMMENT ON FUNCTION streetgen._add_both_ways(name) IS
    'Adds to the tables of a model what lanes for both directions and exceptions of turn restrictions are told by, '
    'where it was made before them.';

CREATE OR REPLACE FUNCTION streetgen._add_merging_lanes(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF NOT streetgen._lacks_column(model, 'lane', 'start_abscissa') THEN
        RETURN;
    END IF;
    ALTER TABLE lane ADD start_abscissa float8, ADD end_abscissa float8,
        DROP CONSTRAINT IF EXISTS lane_kind_check,
        ADD CONSTRAINT lane_kind_check CHECK (kind IN
            ('general', 'bus', 'carpool', 'cycle', 'parking', 'merging', 'closed'));
END $$;
COMMENT ON FUNCTION streetgen._add_merging_lanes(name) IS
    'Adds to the lanes of a model their kind merging and the columns that say where one begins and ends, where the '
    'model was made before them.';

CREATE OR REPLACE FUNCTION streetgen._add_lane_changes(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    -- No trigger takes this change for an edit by hand.
    SET streetgen.computes = 'on'
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF NOT streetgen._lacks_column(model, 'lane_separator', 'leftwards') THEN
        RETURN;
    END IF;
    ALTER TABLE lane_separator ADD leftwards boolean, ADD rightwards boolean;
    -- The next run reads lane changes of sources and those by hand, which the paint does not tell.
    UPDATE lane_separator SET leftwards = dashed, rightwards = dashed;
    ALTER TABLE lane_separator ALTER leftwards SET NOT NULL, ALTER rightwards SET NOT NULL;
END $$;
COMMENT ON FUNCTION streetgen._add_lane_changes(name) IS
    'Adds the columns of lane_separator that say who may cross a line between lanes, where a model was made before '
    'them: over a dashed line all may.';

CREATE OR REPLACE FUNCTION streetgen._add_carpool_lanes(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF EXISTS (SELECT FROM pg_constraint WHERE conrelid = format('%I.axis', model)::regclass
            AND conname = 'axis_kind_forward_check' AND pg_get_constraintdef(oid) ~ 'closed') THEN
        RETURN;
    END IF;
    ALTER TABLE axis DROP CONSTRAINT IF EXISTS axis_kind_forward_check,
        DROP CONSTRAINT IF EXISTS axis_kind_backward_check,
        ADD CONSTRAINT axis_kind_forward_check CHECK (kind_forward ~
            '^(general|bus|carpool|cycle|parking|closed)(\|(general|bus|carpool|cycle|parking|closed)){0,39}$'),
        ADD CONSTRAINT axis_kind_backward_check CHECK (kind_backward ~
            '^(general|bus|carpool|cycle|parking|closed)(\|(general|bus|carpool|cycle|parking|closed)){0,39}$');
    ALTER TABLE turn_restriction DROP CONSTRAINT IF EXISTS turn_restriction_except_kinds_check,
        ADD CONSTRAINT turn_restriction_except_kinds_check
            CHECK (except_kinds ~ '^(bus|carpool|cycle)(\|(bus|carpool|cycle)){0,9}$');
    ALTER TABLE lane DROP CONSTRAINT IF EXISTS lane_kind_check,
        ADD CONSTRAINT lane_kind_check CHECK (kind IN
            ('general', 'bus', 'carpool', 'cycle', 'parking', 'merging', 'closed'));
END $$;
COMMENT ON FUNCTION streetgen._add_carpool_lanes(name) IS
    'Lets axes and lanes of a model have carpool lanes and closed ones, where it was made before them.';

CREATE OR REPLACE FUNCTION streetgen._mend_lane_tables(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._add_both_ways(model), streetgen._add_merging_lanes(model), streetgen._add_lane_changes(model),
        streetgen._add_carpool_lanes(model);
END $$;
COMMENT ON FUNCTION streetgen._mend_lane_tables(name) IS 'Adds to the lanes of a model what older ones lack.';
