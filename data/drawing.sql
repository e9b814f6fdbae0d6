-- pg_temp.drawing: a small SVG of geometries, for the pictures of the pages, in the colours of theme construction.
\ir colours.sql

-- QUERY gives rows (geom, look, label): later rows are drawn over earlier ones. look: section, intersection, contested, axis, kerb, helper,
-- result, point. Equal rows give an equal text.
CREATE FUNCTION pg_temp.drawing(query text, width integer DEFAULT 420) RETURNS text LANGUAGE plpgsql AS $$
DECLARE
    box geometry;
    scale float8;
    height integer;
    margin CONSTANT integer := 14;
    parts text;
BEGIN
    EXECUTE 'CREATE TEMP TABLE drawn AS SELECT row_number() OVER () AS turn, CASE WHEN ST_HasArc(geom) THEN ST_CurveToLine(geom, 32) ELSE geom END AS geom,
        look, label::text AS label FROM (' || query || ') given(geom, look, label) WHERE NOT ST_IsEmpty(geom)';
    SELECT ST_SetSRID(ST_Extent(geom)::geometry, 0) INTO box FROM drawn;
    scale := (width - 2 * margin) / (ST_XMax(box) - ST_XMin(box));
    height := ceil(scale * (ST_YMax(box) - ST_YMin(box))) + 2 * margin;
    UPDATE drawn SET geom = ST_Affine(ST_SetSRID(geom, 0), scale, 0, 0, scale, margin - scale * ST_XMin(box), margin - height - scale * ST_YMin(box));
    SELECT string_agg(text, E'\n' ORDER BY turn) INTO parts FROM (
        SELECT turn, CASE WHEN GeometryType(geom) = 'POINT' THEN format('<circle class="%s" cx="%s" cy="%s" r="3.5"/>', look, round(ST_X(geom)::numeric, 1), round(-ST_Y(geom)::numeric, 1))
            ELSE format('<path class="%s" d="%s"/>', look || CASE WHEN ST_Dimension(geom) = 2 THEN ' area' ELSE '' END, ST_AsSVG(geom, 0, 1)) END AS text FROM drawn
        UNION ALL
        SELECT turn + 1000000, format('<text x="%s" y="%s"%s>%s</text>', round(ST_X(place)::numeric, 1) + CASE WHEN leftwards THEN -5 ELSE 5 END,
            round(-ST_Y(place)::numeric, 1) - 5, CASE WHEN leftwards THEN ' text-anchor="end"' ELSE '' END, label) FROM drawn,
            LATERAL (SELECT CASE ST_Dimension(geom) WHEN 1 THEN ST_LineInterpolatePoint(ST_GeometryN(geom, 1), 0.6) ELSE ST_PointOnSurface(geom) END AS place) p,
            LATERAL (SELECT ST_X(place) + 7 * length(label) > width - 10 AS leftwards) l WHERE label IS NOT NULL) t;
    DROP TABLE drawn;
    RETURN format($svg$<svg xmlns="http://www.w3.org/2000/svg" width="%1$s" height="%2$s" viewBox="0 0 %1$s %2$s">
<style>
path { fill: none; stroke: none; stroke-width: 1.2 }
.section.area { fill: %4$s; stroke: %5$s }
.intersection.area { fill: %6$s; stroke: %5$s }
.contested.area { fill: %7$s; stroke: %5$s }
.result.area { fill: %8$s; fill-opacity: 0.25; stroke: %8$s; stroke-width: 1.6 }
.axis { stroke: %5$s; stroke-dasharray: 7 3 }
.kerb { stroke: %9$s; stroke-width: 1.4 }
.helper { stroke: %5$s; stroke-dasharray: 2 3 }
.result { stroke: %8$s; stroke-width: 2.6 }
circle { fill: %9$s } circle.result { fill: %10$s }
text { font: 12px sans-serif; fill: %9$s; stroke: %11$s; stroke-width: 3; paint-order: stroke }
</style>
<rect width="%1$s" height="%2$s" fill="%11$s"/>
%3$s
</svg>$svg$, width, height, parts, pg_temp.colour('section'), pg_temp.colour('limit'), pg_temp.colour('intersection'),
        pg_temp.colour('intersection', 'contested'), pg_temp.colour('arc'), pg_temp.colour('ink'), pg_temp.colour('arc', 'fallback'), pg_temp.colour('paper'));
END $$;

-- The surfaces, border lines and axes of a model, as rows for a drawing; contested surfaces have a colour of their own.
CREATE FUNCTION pg_temp.streets(model name) RETURNS TABLE (geom geometry, look text, label text) LANGUAGE plpgsql AS $$
BEGIN
    RETURN QUERY EXECUTE format('
        SELECT surface::geometry, ''section'', NULL FROM (SELECT * FROM %1$I.section ORDER BY level, edge_id) s
        UNION ALL SELECT surface, CASE contested_area WHEN 0 THEN ''intersection'' ELSE ''contested'' END, NULL FROM (SELECT * FROM %1$I.intersection ORDER BY level, node_id) i
        UNION ALL SELECT border_line, ''kerb'', NULL FROM (SELECT * FROM %1$I.section_limit ORDER BY section_limit_id) l
        UNION ALL SELECT a.geom, ''axis'', name FROM (SELECT * FROM %1$I.axis ORDER BY axis_id) a', model);
END $$;
