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

CREATE OR REPLACE FUNCTION streetgen._design_number(model name, setting text) RETURNS float8
    LANGUAGE plpgsql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ BEGIN RETURN streetgen._design_text(model, setting)::float8; END $$;
COMMENT ON FUNCTION streetgen._design_number(name, text) IS 'A setting of the design as a number.';

CREATE OR REPLACE FUNCTION streetgen._design_text(model name, setting text) RETURNS text
    LANGUAGE plpgsql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
DECLARE
    value text;
BEGIN
    EXECUTE format('SELECT coalesce((SELECT s.value FROM %I.setting s WHERE s.name = $1), (SELECT d.value
        FROM streetgen._default_setting() d WHERE d.name = $1))', model) INTO value USING setting;
    RETURN value;
END $$;
COMMENT ON FUNCTION streetgen._design_text(name, text) IS
    'A setting of the design, also of a model that was made before the setting.';

CREATE OR REPLACE FUNCTION streetgen._road_rules(model name, network text) RETURNS jsonb
    LANGUAGE plpgsql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
DECLARE
    class record;
    standard record;
    rules jsonb;
BEGIN
    EXECUTE format('SELECT * FROM %I.design_class WHERE network = $1 AND NOT rejected', model) INTO class
        USING network;
    IF class.network IS NULL THEN
        PERFORM streetgen._refuse('22023', format('network "%s" has no row in design_class', network),
            hint => 'The networks are highway, secondary and rural, a row each.');
    END IF;
    EXECUTE format('SELECT * FROM %I.design_standard WHERE speed = $1 AND NOT rejected', model) INTO standard
        USING class.speed;
    IF standard.speed IS NULL THEN
        PERFORM streetgen._refuse('22023',
            format('speed %s km/h of network %s has no row in design_standard', class.speed, network),
            hint => format('INSERT INTO %I.design_standard (speed, …), or take the speed of one of its rows.',
                model));
    END IF;
    SELECT jsonb_object_agg(p, streetgen._design_number(model, p)) INTO rules FROM unnest(streetgen._road_prices()) p;
    RETURN rules || jsonb_build_object('width', class.width, 'radius', standard.radius, 'clothoid', standard.clothoid,
        'grade', standard.grade, 'crest', standard.crest, 'sag', standard.sag, 'curve_radius',
        CASE streetgen._design_text(model, 'curve_radius') WHEN 'normal' THEN standard.radius_normal
            WHEN 'largest' THEN 10000 ELSE 0 END);
END $$;
COMMENT ON FUNCTION streetgen._road_rules(name, text) IS
    'The rules of the roads of a network: name to number. No class, or no standard for its speed: 22023.';

CREATE OR REPLACE FUNCTION streetgen._link_rules(model name, link bigint) RETURNS jsonb
    LANGUAGE plpgsql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
DECLARE
    rules jsonb;
BEGIN
    EXECUTE format($sql$SELECT r || jsonb_build_object('use_cost', (r ->> 'use_cost')::float8
            + streetgen._design_number($2, 'utilisation_cost') * coalesce(utilisation, 0))
        FROM %I.design_link, streetgen._road_rules($2, network) r WHERE design_link_id = $1 $sql$, model)
        INTO rules USING link, model;
    RETURN rules;
END $$;
COMMENT ON FUNCTION streetgen._link_rules(name, bigint) IS
    'The rules of a link: those of its network, its use costing more by its utilisation.';

CREATE OR REPLACE FUNCTION streetgen._road_site(model name, area geometry, rules jsonb)
    RETURNS streetgen.road_site
    LANGUAGE plpgsql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    site streetgen.road_site;
BEGIN
    site.tiles := streetgen._tiles_of(model, area);
    EXECUTE format($sql$
WITH class AS (SELECT class, cost, passage, row_number() OVER (ORDER BY zone_class_id) - 1 AS nth FROM %1$I.zone_class
    WHERE NOT rejected)
SELECT ARRAY(SELECT geom::bytea FROM %1$I.zone JOIN class USING (class) WHERE geom && $1 AND NOT rejected
        ORDER BY zone_id),
    ARRAY(SELECT nth::float8 FROM %1$I.zone JOIN class USING (class) WHERE geom && $1 AND NOT rejected
        ORDER BY zone_id),
    ARRAY(SELECT cost FROM class ORDER BY nth),
    ARRAY(SELECT (array_position(ARRAY['free', 'bridge', 'forbidden'], passage) - 1)::float8 FROM class ORDER BY nth)
$sql$, model) INTO site.zone_surfaces, site.zone_classes, site.class_costs, site.class_passages USING area;
    SELECT array_agg(key ORDER BY key), array_agg(value::float8 ORDER BY key) INTO site.rule_names, site.rule_values
        FROM jsonb_each_text(rules);
    RETURN site;
END $$;
COMMENT ON FUNCTION streetgen._road_site(name, geometry, jsonb) IS
    'Terrain and zones about an area, and the rules of a road, as the core takes them.';
