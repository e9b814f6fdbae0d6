-- The rules of a road: its class, the standard of its speed, and the prices among the settings.

CREATE OR REPLACE FUNCTION streetgen._design_settings() RETURNS text[]
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT ARRAY['link_factor', 'benefit', 'curve_radius', 'design_axis_length', 'design_live',
        'utilisation_cost']
        || streetgen._road_prices() $$;
COMMENT ON FUNCTION streetgen._design_settings() IS 'Settings that the design depends on, and streets do not.';

CREATE OR REPLACE FUNCTION streetgen._road_prices() RETURNS text[]
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT ARRAY['fill_cost', 'cut_cost', 'land_cost', 'pavement_cost', 'bridge_cost', 'tunnel_cost', 'use_cost',
        'climb_cost', 'side_slope', 'fill_greatest', 'cut_greatest'] $$;
COMMENT ON FUNCTION streetgen._road_prices() IS 'Settings that are rules of every road.';

CREATE OR REPLACE FUNCTION streetgen._road_rules(model name, network text) RETURNS jsonb
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
DECLARE
    class record;
    standard record;
    rules jsonb;
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT * FROM design_class c WHERE c.network = _road_rules.network AND NOT rejected INTO class;
    IF class.network IS NULL THEN
        PERFORM streetgen._refuse('22023', format('network "%s" has no row in design_class', network),
            hint => 'The networks are highway, secondary and rural, a row each.');
    END IF;
    SELECT * FROM design_standard WHERE speed = class.speed AND NOT rejected INTO standard;
    IF standard.speed IS NULL THEN
        PERFORM streetgen._refuse('22023',
            format('speed %s km/h of network %s has no row in design_standard', class.speed, network),
            hint => format('INSERT INTO %I.design_standard (speed, …), or take the speed of one of its rows.',
                model));
    END IF;
    SELECT jsonb_object_agg(p, streetgen._setting_number(model, p)) INTO rules FROM unnest(streetgen._road_prices()) p;
    RETURN rules || jsonb_build_object('width', class.width, 'radius', standard.radius, 'clothoid', standard.clothoid,
        'grade', standard.grade, 'crest', standard.crest, 'sag', standard.sag, 'curve_radius',
        CASE streetgen._setting_text(model, 'curve_radius') WHEN 'normal' THEN standard.radius_normal
            WHEN 'largest' THEN 10000 ELSE 0 END);
END $$;
COMMENT ON FUNCTION streetgen._road_rules(name, text) IS
    'The rules of the roads of a network: name to number. No class, or no standard for its speed: 22023.';

CREATE OR REPLACE FUNCTION streetgen._link_rules(model name, link bigint) RETURNS jsonb
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
DECLARE
    rules jsonb;
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT r || jsonb_build_object('use_cost', (r ->> 'use_cost')::float8
            + streetgen._setting_number(model, 'utilisation_cost') * coalesce(utilisation, 0))
        FROM design_link, streetgen._road_rules(model, network) r WHERE design_link_id = link INTO rules;
    RETURN rules;
END $$;
COMMENT ON FUNCTION streetgen._link_rules(name, bigint) IS
    'The rules of a link: those of its network, its use costing more by its utilisation.';

CREATE OR REPLACE FUNCTION streetgen._road_site(model name, area geometry, rules jsonb)
    RETURNS streetgen.road_site
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    site streetgen.road_site;
BEGIN
    PERFORM streetgen._use_model(model);
    site.tiles := streetgen._tiles_of(model, area);
    WITH class AS (SELECT class, cost, passage, row_number() OVER (ORDER BY zone_class_id) - 1 AS nth FROM zone_class
        WHERE NOT rejected)
    SELECT ARRAY(SELECT geom::bytea FROM zone JOIN class USING (class) WHERE geom && area AND NOT rejected
            ORDER BY zone_id),
        ARRAY(SELECT nth::float8 FROM zone JOIN class USING (class) WHERE geom && area AND NOT rejected
            ORDER BY zone_id),
        ARRAY(SELECT cost FROM class ORDER BY nth),
        ARRAY(SELECT (array_position(ARRAY['free', 'bridge', 'forbidden'], passage) - 1)::float8 FROM class
            ORDER BY nth) INTO site.zone_surfaces, site.zone_classes, site.class_costs, site.class_passages;
    SELECT array_agg(key ORDER BY key), array_agg(value::float8 ORDER BY key) INTO site.rule_names, site.rule_values
        FROM jsonb_each_text(rules);
    RETURN site;
END $$;
COMMENT ON FUNCTION streetgen._road_site(name, geometry, jsonb) IS
    'Terrain and zones about an area, and the rules of a road, as the core takes them.';

CREATE OR REPLACE FUNCTION streetgen._design_setting_beside() RETURNS TABLE(name text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 20 SET search_path = pg_catalog
    AS $$ SELECT unnest(streetgen._design_settings()) $$;
COMMENT ON FUNCTION streetgen._design_setting_beside() IS 'The settings of designs, on which no street depends.';
