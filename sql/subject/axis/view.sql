-- The axes of a model with the values used, and the settings that streets depend on.

CREATE OR REPLACE FUNCTION streetgen._make_axis_views(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    with_rings constant boolean := 'roundabout' = ANY (streetgen._subjects(model));
    places constant jsonb := jsonb_build_object('subjects', streetgen._subjects(model));
    decided record;
BEGIN
    PERFORM streetgen._use_model(model);
    -- Its seed is another one where input_hash is made otherwise: streets of a build before are then those of other
    -- settings.
    EXECUTE streetgen._fill_template(streetgen._part('setting_used'), jsonb_build_object(
        'rings', CASE WHEN with_rings THEN streetgen._part('rings_used') END,
        'beside', (SELECT quote_literal(array_agg(name)) FROM streetgen._setting_beside())));
    COMMENT ON VIEW setting_used IS 'The settings that streets depend on, as one row';
    COMMENT ON COLUMN setting_used.settings IS 'name of each to its value';
    COMMENT ON COLUMN setting_used.setting_hash IS 'their hash';
    SELECT string_agg('any_' || relation, ' OR ' ORDER BY n) AS any,
        -- Two tables may share a place in the order, and rows of them a key: then roads and heights come second.
        string_agg(format('SELECT %s AS place, o.%I AS key, hash_record_extended(%s, 0) AS says, %7$s AS later '
            'FROM %4$I.%5$I o WHERE any_%5$s AND (%6$s)', hash_place, key, hash, model, relation, (SELECT string_agg(
                format('o.%I = a.axis_id', role), ' OR ') FROM unnest(axes) role),
            (relation IN ('road_override', 'height_override'))::text), ' UNION ALL ' ORDER BY n) AS says,
        string_agg(format('EXISTS (SELECT FROM %I.%I) AS any_%2$s', model, relation), ', ' ORDER BY n) AS flags
        FROM streetgen._decisions_of(model) WHERE hash IS NOT NULL INTO decided;
    EXECUTE streetgen._fill_template(streetgen._part('axis_used'), jsonb_build_object('model', quote_literal(model),
        'rings', CASE WHEN with_rings THEN ', name, roundabout_tag' END, 'any', decided.any, 'says', decided.says,
        'flags', decided.flags,
        'bays', streetgen._bays_stand(streetgen._subjects(model), ''),
        'kerbs_beside', coalesce((streetgen._parts_of_rooms('_%s_kerbs_beside', places))[1], 'NULL::float8[]'),
        'surveyed', coalesce((streetgen._parts_of_rooms('_%s_surveyed', places))[1], 'NULL::float8[]'),
        'area', coalesce((streetgen._parts_of_rooms('_%s_area_used', places))[1], 'NULL::geometry'),
        'more', array_to_string(streetgen._parts_of_rooms('_%s_value_used', '{}'), E'\n')));
    COMMENT ON VIEW axis_used
        IS 'The axes with the values that generate uses: what the source lacks is estimated by named functions';
    COMMENT ON COLUMN axis_used.axis_id IS 'the axis';
    COMMENT ON COLUMN axis_used.geom IS 'the axis of the road';
    COMMENT ON COLUMN axis_used.level IS 'level of the axis';
    COMMENT ON COLUMN axis_used.width IS 'width kerb to kerb at the start, metres';
    COMMENT ON COLUMN axis_used.width_end IS 'width kerb to kerb at the end, metres';
    COMMENT ON COLUMN axis_used.lane_count IS 'number of general, bus and carpool lanes of both directions';
    COMMENT ON COLUMN axis_used.lanes_forward IS 'general, bus and carpool lanes along the axis';
    COMMENT ON COLUMN axis_used.lanes_backward IS 'general, bus and carpool lanes against the axis';
    COMMENT ON COLUMN axis_used.lanes_both IS 'lanes that both directions use';
    COMMENT ON COLUMN axis_used.direction IS 'direction of the traffic';
    COMMENT ON COLUMN axis_used.kind_forward IS 'kinds of the lanes along the axis, NULL: all general';
    COMMENT ON COLUMN axis_used.kind_backward IS 'kinds of the lanes against the axis, NULL: all general';
    COMMENT ON COLUMN axis_used.lane_width_forward IS 'widths of the lanes along the axis, metres';
    COMMENT ON COLUMN axis_used.lane_width_backward IS 'widths of the lanes against the axis, metres';
    COMMENT ON COLUMN axis_used.lane_width_maximal IS
        'lanes that say no width grow at most so wide, metres; NULL: they fill the roadway';
    COMMENT ON COLUMN axis_used.turn_forward IS 'movements of the lanes along the axis';
    COMMENT ON COLUMN axis_used.turn_backward IS 'movements of the lanes against the axis';
    COMMENT ON COLUMN axis_used.access IS 'who may drive, as in axis; NULL: all';
    COMMENT ON COLUMN axis_used.on_ring IS
        'does the source say that it is part of a roundabout, where setting roundabout_tags is true?';
    COMMENT ON COLUMN axis_used.street IS 'a number of its name, whatever its case; 0: none';
    COMMENT ON COLUMN axis_used.speed IS 'speed of the traffic, km/h';
    COMMENT ON COLUMN axis_used.importance IS 'importance, 1 the highest';
    COMMENT ON COLUMN axis_used.radius IS 'wanted radius of its corners, metres, 0: none';
    COMMENT ON COLUMN axis_used.estimated IS 'which of these values are estimated';
    COMMENT ON COLUMN axis_used.input_hash IS 'hash of the axis and the values used';
    COMMENT ON COLUMN axis_used.setting_hash IS 'hash of the settings';
    COMMENT ON COLUMN axis_used.sidewalk_left IS
        'width of the sidewalk on the left, with the bays between it and the roadway, metres; 0: none; an estimate '
        'holds where the city lies beside';
    COMMENT ON COLUMN axis_used.sidewalk_right IS 'the same on its right';
    COMMENT ON COLUMN axis_used.roadway_offset IS 'metres from the axis to the middle of the roadway, left positive';
    COMMENT ON COLUMN axis_used.by_area IS
        'are width and roadway_offset those of areas of kind roadway in street_area, by setting area_wins?';
    COMMENT ON COLUMN axis_used.width_moved IS
        'metres that an estimated width is less since its kerbs give way to what is mapped beside the street; 0: they '
        'lie as estimated';
    COMMENT ON COLUMN axis_used.area IS
        'these areas about it (MULTIPOLYGON, parts may overlap), at whose border its surfaces end; NULL: none';
END $$;
COMMENT ON FUNCTION streetgen._make_axis_views(name) IS
    'Makes the views setting_used and axis_used of a model, again and again.';
