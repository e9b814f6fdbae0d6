-- The settings of the fit.

CREATE OR REPLACE FUNCTION streetgen._fit_setting()
    RETURNS TABLE(name text, value text, unit text, description text, minimum float8, maximum float8, choice text[])
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 19 SET search_path = pg_catalog
    AS $$ VALUES
    ('fit_loss', 'cauchy', NULL,
        'how observations far from the kerb count: cauchy (hardly), soft_l1 (as far as they are) or squares (most)',
        NULL::float8, NULL::float8, '{cauchy,soft_l1,squares}'::text[]),
    ('fit_scale', '0.05', 'm', 'residual from which the loss counts less than its square', 0.001, 10, NULL),
    ('fit_spacing', '1', 'm', 'a line observed counts as a point each', 0.05, 100, NULL),
    ('fit_objects', 'false', NULL, 'do objects of street_object that are imported or by hand count, as out of the '
        'roadway', NULL, NULL, '{true,false}'),
    ('fit_reach', '8', 'm', 'farthest that an observation lies from the kerb of its street', 0.5, 50, NULL),
    ('fit_move', '3', 'm', 'farthest that a fit moves a place of an axis, or a roadway beside it', 0, 50, NULL),
    ('fit_width_change', '8', 'm', 'greatest change of a width by a fit', 0, 100, NULL),
    ('fit_width_least', '2', 'm', 'least width that a fit gives', 0.5, 50, NULL),
    ('fit_width_greatest', '20', 'm', 'greatest width that a fit gives', 2, 200, NULL),
    ('fit_piece', '30', 'm', 'longest piece of an axis that moves as one', 2, 1000, NULL),
    ('fit_arc_tolerance', '0.05', 'm',
        'farthest that a point of an observed kerb lies from the arc of a corner: four times what kerbs are off',
        0.001, 1, NULL),
    ('fit_object_margin', '0.25', 'm', 'an object in or out of the roadway keeps so far from its kerb', 0, 5, NULL),
    ('fit_weight_observation', '0.5', NULL, 'factor of a kerb or marking observed', 0, 1000, NULL),
    ('fit_weight_observed_width', '2', NULL, 'factor of a width observed', 0, 1000, NULL),
    ('fit_weight_object', '50', NULL, 'factor of an object observed', 0, 1000, NULL),
    ('fit_weight_width', '0.2', NULL, 'factor by which a width keeps its value', 0, 1000, NULL),
    ('fit_weight_origin', '0.5', NULL, 'factor by which axes, and roadways beside them, stay', 0, 1000, NULL),
    ('fit_weight_spacing', '0.5', NULL, 'factor by which pieces of an axis keep their length', 0, 1000, NULL),
    ('fit_weight_angle', '2', NULL, 'factor by which an axis keeps its angles', 0, 1000, NULL) $$;
COMMENT ON FUNCTION streetgen._fit_setting() IS 'The settings of the fit, with their defaults and ranges.';

CREATE OR REPLACE FUNCTION streetgen._fit_setting_beside() RETURNS TABLE(name text)
    LANGUAGE sql STABLE PARALLEL SAFE ROWS 19 SET search_path = pg_catalog
    AS $$ SELECT name FROM streetgen._fit_setting() $$;
COMMENT ON FUNCTION streetgen._fit_setting_beside() IS 'The settings of the fit, on which no street depends.';
