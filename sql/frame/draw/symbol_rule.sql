-- Rules say how each layer looks, and nothing else does: rooms add theirs in their files draw.sql.

CREATE TABLE streetgen.symbol_rule (
    theme text NOT NULL CHECK (theme IN ('street', 'dark', 'print', 'construction')),
    layer text NOT NULL, kind text NOT NULL DEFAULT '',
    from_scale float8 NOT NULL DEFAULT 0 CHECK (from_scale >= 0 AND from_scale < 'Infinity'),
    to_scale float8 NOT NULL DEFAULT 'Infinity' CHECK (to_scale <> 'NaN'),
    place float8 NOT NULL CHECK (place BETWEEN -1e6 AND 1e6),
    fill text CHECK (fill ~ '^#[0-9a-f]{6}([0-9a-f]{2})?$'),
    line text CHECK (line ~ '^#[0-9a-f]{6}([0-9a-f]{2})?$'),
    width float8 CHECK (width > 0 AND width <= 1e6), unit text CHECK (unit IN ('metre', 'pixel')),
    dash text CHECK (dash ~ '^\d+(\.\d+)?( \d+(\.\d+)?)*$'),
    marker text CHECK (marker IN ('shadow', 'hatch', 'dots')),
    meaning text,
    PRIMARY KEY (theme, layer, kind, from_scale, place),
    CONSTRAINT symbol_rule_scales CHECK (from_scale < to_scale),
    CONSTRAINT symbol_rule_name_has_size CHECK (layer NOT IN ('name', 'ref') OR width IS NOT NULL),
    CONSTRAINT symbol_rule_width_has_unit CHECK (num_nulls(width, unit) IN (0, 2)),
    CONSTRAINT symbol_rule_line_has_width CHECK (line IS NULL OR width IS NOT NULL),
    CONSTRAINT symbol_rule_shadow_has_width CHECK (marker IS NULL OR width IS NOT NULL));
COMMENT ON TABLE streetgen.symbol_rule IS
    'How layers of a model are drawn: by theme, kind and scale. A kind without a rule of its own at a scale is drawn '
    'by the rules of kind '''', and a layer without a rule is not drawn. Several rules of one kind are drawn one above '
    'the other, such as a casing and a fill';
COMMENT ON COLUMN streetgen.symbol_rule.theme IS
    'street: as one sees it from above; dark: the same at night; print: in black and white, for printers and copies; '
    'construction: how it was computed, for engineers';
COMMENT ON COLUMN streetgen.symbol_rule.layer IS
    'name of what is drawn, such as lane; name: those of streets; ref: numbers of routes in a box, whose border '
    'and letters have the colour of the line; ground lies below all, paper and ink are those of a legend; '
    'handle: what one edits or looks through in QGIS';
COMMENT ON COLUMN streetgen.symbol_rule.kind IS 'part of the layer, such as bus of lane; empty: any other';
COMMENT ON COLUMN streetgen.symbol_rule.from_scale IS
    'drawn beyond this scale, as the number below the line: 1500 is 1:1,500';
COMMENT ON COLUMN streetgen.symbol_rule.to_scale IS 'drawn up to this scale';
COMMENT ON COLUMN streetgen.symbol_rule.place IS 'order on its level from below, less than 10; or above all levels';
COMMENT ON COLUMN streetgen.symbol_rule.fill IS 'colour of its ground, #rrggbb or #rrggbbaa; NULL: none';
COMMENT ON COLUMN streetgen.symbol_rule.line IS 'colour of its line or border, #rrggbb or #rrggbbaa; NULL: none';
COMMENT ON COLUMN streetgen.symbol_rule.width IS
    'width of the line; of a shadow, how far it falls to the south-east; of hatching and dots, how far they are apart; '
    'of names and refs, the size of the font';
COMMENT ON COLUMN streetgen.symbol_rule.unit IS 'unit of width and dash: metre or pixel';
COMMENT ON COLUMN streetgen.symbol_rule.dash IS 'lengths of dashes and gaps in turn, such as 3 2; NULL: none';
COMMENT ON COLUMN streetgen.symbol_rule.marker IS
    'shadow: the geometry falls to the south-east; hatch or dots: its ground has lines or dots of this fill; NULL: as '
    'it is';
COMMENT ON COLUMN streetgen.symbol_rule.meaning IS 'what a legend says of it; NULL: nothing';
GRANT SELECT ON streetgen.symbol_rule TO PUBLIC;

INSERT INTO streetgen.symbol_rule (theme, layer, place, fill) VALUES
    ('street', 'ground', 0, '#f1ebdf'), ('dark', 'ground', 0, '#0f1216'), ('print', 'ground', 0, '#ffffff'),
    ('construction', 'ground', 0, '#f3f1ea'),
    ('street', 'paper', 0, '#ffffff'), ('dark', 'paper', 0, '#14171c'), ('print', 'paper', 0, '#ffffff'),
    ('construction', 'paper', 0, '#ffffff'),
    ('street', 'ink', 0, '#1f2937'), ('dark', 'ink', 0, '#e5e7eb'), ('print', 'ink', 0, '#000000'),
    ('construction', 'ink', 0, '#1f2937');
INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, fill, line, width, unit, meaning) VALUES
    ('street', 'building', 15000, -0.8, '#d8c9b4', '#b09c80', 0.7, 'pixel', 'building'),
    ('dark', 'building', 15000, -0.8, '#343b46', '#4a5361', 0.7, 'pixel', 'building'),
    ('print', 'building', 15000, -0.8, '#ffffff', '#000000', 0.5, 'pixel', 'building'),
    ('construction', 'building', 11000, -0.8, '#e3ddd2', '#bdb4a4', 0.7, 'pixel', 'building');

-- In QGIS one drags, types in or looks through these.
INSERT INTO streetgen.symbol_rule (theme, layer, kind, place, fill, line, width, unit, meaning) VALUES
    ('construction', 'handle', '', 980, '#1d4ed8', '#1d4ed8', 1, 'pixel', 'handle to drag or type in'),
    ('construction', 'handle', 'by_hand', 980, '#d9480f', '#d9480f', 1, 'pixel', 'decided by hand'),
    ('construction', 'handle', 'error', 980, '#dc2626', '#dc2626', 1, 'pixel', 'error'),
    ('construction', 'handle', 'warning', 980, '#f08c00', '#f08c00', 1, 'pixel', 'warning'),
    ('construction', 'handle', 'notice', 980, '#1d4ed8', '#1d4ed8', 1, 'pixel', 'notice');

CREATE OR REPLACE FUNCTION streetgen._rules(model name, theme text, scale float8)
    RETURNS SETOF streetgen.symbol_rule
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 60 SET search_path = pg_catalog
    AS $$
#variable_conflict use_column
DECLARE
    wrong record;
BEGIN
    PERFORM streetgen._use_model(model);
    IF NOT has_table_privilege('symbol_rule', 'SELECT') THEN
        RAISE EXCEPTION 'role "%" may not read the rules by which model "%" is drawn', current_user, model
            USING ERRCODE = '42501', HINT = format('GRANT SELECT ON %I.symbol_rule TO %I by its owner allows it.',
                model, current_user);
    END IF;
    -- Its owner may have dropped the constraints, and these words stand in the SVG as they are.
    SELECT theme, layer, place, word INTO wrong FROM symbol_rule o, LATERAL (VALUES (fill, '^#[0-9a-f]+$'),
            (line, '^#[0-9a-f]+$'), (dash, '^[0-9. ]+$')) v(word, form) WHERE word !~ form LIMIT 1;
    IF FOUND THEN
        RAISE EXCEPTION 'a rule of %.symbol_rule has the colour or dash %, which is none', quote_ident(model),
            quote_literal(left(wrong.word, 80)) USING ERRCODE = '22023',
            DETAIL = format('Its theme is %s, its layer %s, its place %s.', wrong.theme, wrong.layer, wrong.place),
            HINT = 'Expected a colour as #rrggbb or #rrggbbaa, or a dash such as 3 1.5.';
    END IF;
    SELECT * FROM symbol_rule o WHERE layer NOT IN (SELECT d.layer FROM streetgen.symbol_rule d) LIMIT 1 INTO wrong;
    IF FOUND THEN
        RAISE EXCEPTION 'a rule of %.symbol_rule draws layer "%", which is none', quote_ident(model), wrong.layer
            USING ERRCODE = '22023', DETAIL = format('Its theme is %s, its place %s.', wrong.theme, wrong.place),
            HINT = 'SELECT DISTINCT layer FROM streetgen.symbol_rule lists them.';
    END IF;
    RETURN QUERY SELECT r.* FROM (SELECT m.theme, m.layer, m.kind, m.from_scale, m.to_scale, m.place, m.fill, m.line,
                m.width, m.unit, m.dash, m.marker, m.meaning FROM symbol_rule m
            UNION ALL SELECT * FROM streetgen.symbol_rule d
            WHERE (d.theme, d.layer, d.kind, d.from_scale, d.place) NOT IN (
                SELECT o.theme, o.layer, o.kind, o.from_scale, o.place FROM symbol_rule o)) r
        WHERE r.theme = _rules.theme AND scale > r.from_scale AND scale <= r.to_scale;
END $$;
COMMENT ON FUNCTION streetgen._rules(name, text, float8) IS
    'The rules of a theme at a scale (the number below the line) for a model: its own, and the others of '
    'streetgen.symbol_rule. A rule of its own for a layer that is none: 22023.';

CREATE OR REPLACE FUNCTION streetgen._symbols(model name, theme text, scale float8)
    RETURNS TABLE(symbol bigint, layer text, kind text, place float8, fill text, line text, width float8, unit text,
        dash text, marker text, meaning text)
    LANGUAGE sql STABLE STRICT PARALLEL UNSAFE ROWS 60 SET search_path = pg_catalog
    AS $$ SELECT row_number() OVER (ORDER BY r.place, r.layer, r.kind), r.layer, r.kind, r.place, r.fill, r.line,
            r.width, r.unit, r.dash, r.marker, r.meaning
        FROM streetgen._rules(model, theme, scale) r WHERE num_nonnulls(r.fill, r.line) > 0 $$;
COMMENT ON FUNCTION streetgen._symbols(name, text, float8) IS
    'The rules of a theme at a scale for a model that have a colour, each with a number.';

CREATE OR REPLACE FUNCTION streetgen._pixel_on_paper() RETURNS float8
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog AS $$ SELECT 0.00028::float8 $$;
COMMENT ON FUNCTION streetgen._pixel_on_paper() IS
    'Metres of paper that a pixel stands for, as map services have it.';

CREATE OR REPLACE FUNCTION streetgen._check_theme(theme text) RETURNS void
    LANGUAGE plpgsql STABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
DECLARE
    themes constant text[] := ARRAY(SELECT DISTINCT r.theme FROM streetgen.symbol_rule r ORDER BY 1);
BEGIN
    IF theme <> ALL (themes) THEN
        RAISE EXCEPTION 'there is no theme "%"', theme USING ERRCODE = '22023',
            HINT = format('Themes are %s.', array_to_string(themes, ', '));
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._check_theme(text) IS 'Raises 22023 for a theme that no rule has. NULL passes.';

CREATE OR REPLACE FUNCTION streetgen._page(model name, theme text, scale float8, OUT paper text, OUT ink text)
    LANGUAGE sql STABLE PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$ SELECT coalesce((array_agg(fill ORDER BY symbol DESC) FILTER (WHERE layer = 'paper'))[1], 'none'),
        coalesce((array_agg(fill ORDER BY symbol DESC) FILTER (WHERE layer = 'ink'))[1], 'none')
        FROM streetgen._symbols(model, theme, scale) $$;
COMMENT ON FUNCTION streetgen._page(name, text, float8) IS
    'The colours of paper and ink of a theme, by the rule that lies above others of the layer; none without a rule.';

CREATE OR REPLACE FUNCTION streetgen._drawn_metres(width float8, unit text, pixel float8) RETURNS float8
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT width * CASE unit WHEN 'pixel' THEN pixel ELSE 1 END $$;
COMMENT ON FUNCTION streetgen._drawn_metres(float8, text, float8) IS
    'A width of a rule in metres, where a pixel is so many metres wide.';

CREATE OR REPLACE FUNCTION streetgen._as_css(fill text, line text, width float8, unit text, dash text, pixel float8)
    RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT format('fill:%s;fill-rule:evenodd', coalesce(fill, 'none')) || CASE WHEN line IS NULL THEN '' ELSE
            format(';stroke:%s;stroke-width:%s', line, round(streetgen._drawn_metres(width, unit, pixel)::numeric, 4))
            || coalesce(';stroke-dasharray:' || (SELECT string_agg(round(streetgen._drawn_metres(d::float8, unit,
                pixel)::numeric, 4)::text, ' ' ORDER BY n) FROM string_to_table(dash, ' ') WITH ORDINALITY t(d, n)),
                '') END $$;
COMMENT ON FUNCTION streetgen._as_css(text, text, float8, text, text, float8) IS
    'A rule as properties of SVG, for a drawing in metres whose pixel is so many metres wide.';

CREATE OR REPLACE FUNCTION streetgen._plan_styles(model name, scale float8) RETURNS jsonb
    LANGUAGE sql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
    SELECT jsonb_object_agg(concat_ws(' ', layer, nullif(kind, '')), style) FROM (
        SELECT layer, kind, coalesce((array_agg(streetgen._as_css(s.fill, s.line, s.width, s.unit, s.dash, 1)
            ORDER BY s.symbol DESC) FILTER (WHERE symbol IS NOT NULL))[1], 'display:none') AS style
        FROM streetgen.symbol_rule LEFT JOIN streetgen._symbols(model, 'construction', scale) s USING (layer, kind)
        WHERE theme = 'construction' GROUP BY layer, kind) r $$;
COMMENT ON FUNCTION streetgen._plan_styles(name, float8) IS
    'The uppermost rules of theme construction at a scale as properties of SVG, for a plan that is drawn in pixels: by '
    'layer and kind, such as "lane bus".';

CREATE OR REPLACE FUNCTION streetgen._pattern_as_svg(marker text, fill text, apart float8, pixel float8)
    RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    -- Those that are alike have one name.
    SELECT format('<pattern id="p%s" %s', left(md5(drawn), 12), drawn)
    FROM (SELECT round(apart::numeric, 4) AS every, round((apart / 2)::numeric, 4) AS half) r,
        format('patternUnits="userSpaceOnUse" width="%1$s" height="%1$s" patternTransform="rotate(45)">%2$s</pattern>',
            every, CASE marker WHEN 'hatch' THEN format('<path d="M%s 0v%s" stroke="%s" stroke-width="%s"/>', half,
                every, fill, round((0.5 * pixel)::numeric, 4))
            WHEN 'dots' THEN format('<circle cx="%1$s" cy="%1$s" r="%2$s" fill="%3$s"/>', half,
                round((0.6 * pixel)::numeric, 4), fill) END) drawn
    WHERE marker IN ('hatch', 'dots') $$;
COMMENT ON FUNCTION streetgen._pattern_as_svg(text, text, float8, float8) IS
    'The pattern of a marker in SVG, lines half a pixel wide or dots, so far apart; NULL of a marker that is none. A '
    'pixel is so many metres wide.';

CREATE OR REPLACE FUNCTION streetgen._pattern_name(pattern text) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT format('url(#%s)', substring(pattern, 'id="(\w+)"')) $$;
COMMENT ON FUNCTION streetgen._pattern_name(text) IS 'A pattern of SVG as what fills a shape.';

CREATE OR REPLACE FUNCTION streetgen._mend_frame_tables(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
DECLARE
    rules constant regclass := to_regclass(format('%I.symbol_rule', model));
    part record;
    broken jsonb;
BEGIN
    FOR part IN SELECT d.holds, format('SELECT to_jsonb(r) FROM %s r WHERE (%s) IS FALSE LIMIT 1', rules,
                coalesce(d.holds, 'true')) AS breaks, format('ALTER TABLE %s ', rules) || concat_ws(', ',
                'DROP CONSTRAINT ' || quote_ident(o.conname),
                'ADD CONSTRAINT ' || quote_ident(d.conname) || ' ' || d.says) AS change
        FROM (SELECT conname, pg_get_constraintdef(oid) AS says, pg_get_expr(conbin, conrelid) AS holds
            FROM pg_constraint WHERE conrelid = 'streetgen.symbol_rule'::regclass AND contype = 'c') d
        FULL JOIN (SELECT conname, pg_get_constraintdef(oid) AS says
            FROM pg_constraint WHERE conrelid = rules AND contype = 'c') o USING (conname)
        -- Earlier builds gave no name to what holds for several columns.
        WHERE rules IS NOT NULL AND CASE WHEN d.says IS NULL THEN o.conname ~ '^symbol_rule_check\d*$'
            ELSE d.says IS DISTINCT FROM o.says END
        ORDER BY conname
    LOOP
        EXECUTE part.breaks INTO broken;
        IF broken IS NOT NULL THEN
            RAISE EXCEPTION 'a rule of %.symbol_rule cannot be what it is', quote_ident(model)
                USING ERRCODE = '23514', DETAIL = format('It is %s, and %s does not hold.', broken, part.holds),
                HINT = format('Change or delete it in %s; then repeat the call.', rules);
        END IF;
        EXECUTE part.change;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._mend_frame_tables(name) IS
    'Gives the rules of a model of an older build the conditions of this one. A rule that breaks one: 23514.';
