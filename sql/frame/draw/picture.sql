-- Pictures of a model as files: one at a time, or one that moves.

CREATE OR REPLACE FUNCTION streetgen._picture_frame(model name, extent geometry, width integer, scale float8,
    OUT box geometry, OUT pixels integer, OUT height numeric, OUT pixel float8, OUT at_scale float8)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    wide float8;
    high float8;
    by_scale boolean;
    across float8;
BEGIN
    IF ST_IsEmpty(extent) THEN
        RAISE EXCEPTION 'the extent is empty: %', ST_AsText(extent) USING ERRCODE = '22023',
            HINT = 'NULL draws the whole model.';
    END IF;
    IF NOT scale BETWEEN 1 AND 1e8 THEN
        RAISE EXCEPTION 'the scale is 1:%, expected 1:1 to 1:100000000', scale USING ERRCODE = '22023',
            HINT = '1000 draws as for 1:1,000; NULL: as the width says.';
    END IF;
    box := ST_SetSRID(coalesce(ST_Envelope(extent), streetgen._model_extent(model),
        ST_MakeEnvelope(0, 0, 1, 1)), (SELECT m.srid FROM streetgen.model m WHERE m.name = model));
    -- A metre of ground at least, about what was asked for.
    box := ST_Expand(box, greatest(0, 0.5 - (ST_XMax(box) - ST_XMin(box)) / 2),
        greatest(0, 0.5 - (ST_YMax(box) - ST_YMin(box)) / 2));
    wide := ST_XMax(box) - ST_XMin(box);
    high := ST_YMax(box) - ST_YMin(box);
    IF extent IS NULL AND coalesce(width, scale) IS NULL THEN
        -- A model of one long road is a strip that one can look at.
        box := ST_Expand(box, greatest(0, high / 12 - wide) / 2, greatest(0, wide / 12 - high) / 2);
        wide := ST_XMax(box) - ST_XMin(box);
        high := ST_YMax(box) - ST_YMin(box);
    END IF;
    IF width NOT BETWEEN 16 AND 20000 THEN
        RAISE EXCEPTION 'the width is %, expected 16 to 20000 pixels', width USING ERRCODE = '22023',
            HINT = 'Leave it out for 1200 pixels, or as many as the scale says.';
    END IF;
    by_scale := width IS NULL AND scale IS NOT NULL;
    across := coalesce(width, CASE WHEN by_scale THEN greatest(16, round(wide / scale / streetgen._pixel_on_paper()))
        ELSE greatest(16, least(1200, floor(20000 * wide / high))) END);
    height := greatest(1, round((across * high / wide)::numeric));
    IF greatest(across, height) > 20000 THEN
        RAISE EXCEPTION 'the picture would be % pixels wide and % high, expected up to 20000', across::numeric, height
            -- So much narrower than high, it has 16 pixels at any scale.
            USING ERRCODE = '22023', HINT = CASE WHEN by_scale AND high < 1200 * wide THEN format('1:%s fits.',
                ceil(wide / streetgen._pixel_on_paper() / (20000 * least(1, wide / high) - 0.5))::numeric)
            ELSE 'Take a smaller width, a greater scale, or an extent that is less high: behind the model, as '
                'XMIN,YMIN,XMAX,YMAX, for data/streetgen draw.' END;
    END IF;
    pixels := across;
    pixel := wide / pixels;
    at_scale := coalesce(scale, pixel / streetgen._pixel_on_paper());
END $$;
COMMENT ON FUNCTION streetgen._picture_frame(name, geometry, integer, float8) IS
    'The box of a picture, its pixels across and in height, the metres of one, and the scale as which it is drawn. An '
    'empty extent, a width or scale out of range: 22023.';

CREATE OR REPLACE FUNCTION streetgen._svg_of_map(map text, box geometry, pixels integer, height numeric,
    attributes text) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$ SELECT format(E'<svg %swidth="%s" height="%s" viewBox="0 0 %s %s">\n%s</svg>\n', attributes, pixels, height,
        round((ST_XMax(box) - ST_XMin(box))::numeric, 3), round((ST_YMax(box) - ST_YMin(box))::numeric, 3), map) $$;
COMMENT ON FUNCTION streetgen._svg_of_map(text, geometry, integer, numeric, text) IS
    'A map of a box as SVG, so many pixels wide and high.';

CREATE OR REPLACE FUNCTION streetgen.svg(model name, extent geometry DEFAULT NULL, width integer DEFAULT NULL,
    legend boolean DEFAULT false, theme text DEFAULT 'street', scale float8 DEFAULT NULL, run text DEFAULT NULL,
    at float8 DEFAULT 0) RETURNS text
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public SET jit = off
    AS $$
DECLARE
    frame record;
    map record;
BEGIN
    PERFORM streetgen._require_reader(model), streetgen._check_given('legend', legend::text, 'theme', theme, 'at',
        at::text), streetgen._check_extent(model, extent), streetgen._check_theme(theme);
    IF at = 'NaN' THEN
        RAISE EXCEPTION 'at is not a number' USING ERRCODE = '22023', HINT = 'It counts seconds of the run.';
    END IF;
    frame := streetgen._picture_frame(model, extent, width, scale);
    map := streetgen._svg_map(model, frame.box, frame.pixel, theme, frame.at_scale, run, at);
    PERFORM streetgen._tell_unused_rules(model, frame.box, theme, frame.at_scale, map.symbols);
    IF NOT legend THEN
        RETURN streetgen._svg_of_map(map.drawing, frame.box, frame.pixels, frame.height,
            'xmlns="http://www.w3.org/2000/svg" ');
    END IF;
    RETURN streetgen._svg_beside_legend(model, streetgen._svg_of_map(map.drawing, frame.box, frame.pixels,
        frame.height, ''), frame.pixels, frame.height, frame.pixel, theme, frame.at_scale, map.symbols);
END $$;
COMMENT ON FUNCTION streetgen.svg(name, geometry, integer, boolean, text, float8, text, float8) IS
    'One picture (SVG) of a model, or of an extent of it (geometry in the model''s SRID), drawn as table symbol_rule '
    'says. width: in pixels; NULL: 1200, or as the scale says. legend: beside the map, in addition to its width, with '
    'what is drawn and a scale. theme: street, as one sees it from above; dark; print, in black and white; or '
    'construction, how it was computed. '
    'scale: drawn as for 1:scale, where a pixel is 0.28 mm; NULL: as extent and width say. run: a simulation that was '
    'kept, whose cars or densities are drawn as they are at seconds at; NULL: the cars of table car. A theme, width or '
    'scale that is none, an empty extent, a run that was not kept, or that an older build kept of cars: 22023.';

CREATE OR REPLACE FUNCTION streetgen.animated_svg(model name, run text, extent geometry DEFAULT NULL,
    width integer DEFAULT NULL, theme text DEFAULT 'street', scale float8 DEFAULT NULL, pace float8 DEFAULT 1)
    RETURNS text
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public SET jit = off
    AS $$
DECLARE
    frame record;
BEGIN
    PERFORM streetgen._require_reader(model), streetgen._check_given('run', run, 'theme', theme, 'pace', pace::text),
        streetgen._check_extent(model, extent), streetgen._check_theme(theme);
    IF NOT pace BETWEEN 0.01 AND 1000 THEN
        RAISE EXCEPTION 'pace is %, expected 0.01 to 1000', pace USING ERRCODE = '22023',
            HINT = 'It counts seconds of the run in a second of the picture.';
    END IF;
    frame := streetgen._picture_frame(model, extent, width, scale);
    RETURN (SELECT streetgen._svg_of_map(m.drawing, frame.box, frame.pixels, frame.height,
            'xmlns="http://www.w3.org/2000/svg" ')
        FROM streetgen._svg_map(model, frame.box, frame.pixel, theme, frame.at_scale, run, pace => pace) m);
END $$;
COMMENT ON FUNCTION streetgen.animated_svg(name, text, geometry, integer, text, float8, float8) IS
    'A picture (SVG) that moves: a run that streetgen.keep_simulation kept, pace times as fast, again and again; a '
    'browser shows it. What does not move is drawn as streetgen.svg does. Cars move straight between the states that '
    'were kept, so that an output of 0.5 s or less shows turns. A theme, width, scale or pace that is none, an empty '
    'extent, a run that was not kept, or that an older build kept of cars: 22023; a model without traffic: 55000; '
    'NULL: 22004; an unknown model: 3F000; not a reader of the model: 42501.';
