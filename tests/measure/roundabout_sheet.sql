-- A contact sheet of what roundabouts.sql counts as wrong (framed red) and missed (framed blue), as SVG: -v sheet=FILE of roundabouts.sql, within its transaction.
-- Axes with the arrow of a stated direction, rings of the source thick and violet, faces of the network dotted; below the number the score, the terms of shape, names and
-- network, and the names about the ring.
\ir ../../data/colours.sql
CREATE TEMP TABLE sheet_cell ON COMMIT DROP AS
SELECT row_number() OVER (ORDER BY missed, way % 2, score DESC, x) - 1 AS i, * FROM (
    SELECT false AS missed, half AS way, k.centre, ST_X(k.centre) AS x, k.radius, score, format('%s %s %s', round(shape::numeric, 2), round(name::numeric, 2), round(network::numeric, 2)) AS terms, geom
    FROM known k JOIN ring USING (number) WHERE known = 'all' AND hit IS NULL AND score >= (SELECT value::float8 FROM :"model".setting WHERE name = 'roundabout_accept')
    UNION ALL SELECT true, way, t.centre, ST_X(t.centre), t.radius, k.score, coalesce(k.terms, 'no face'), t.geom
    FROM truth t LEFT JOIN LATERAL (SELECT max(score) AS score, min(format('%s %s %s%s', round(shape::numeric, 2), round(name::numeric, 2), round(network::numeric, 2), CASE WHEN hit IS NULL THEN ' elsewhere' END)) AS terms
        FROM known k JOIN ring r USING (number) WHERE known = 'all' AND ST_DWithin(k.centre, t.centre, greatest(10, t.radius))) k ON true
    WHERE NOT EXISTS (SELECT FROM known k WHERE known = 'all' AND hit = t.number AND score >= (SELECT value::float8 FROM :"model".setting WHERE name = 'roundabout_accept'))) c;
CREATE TEMP TABLE sheet_line ON COMMIT DROP AS
SELECT c.i, a.axis_id, a.direction, x.roundabout_tag IS NOT NULL AS tagged, x.name, a.level, ST_Intersection(ST_Force2D(a.geom), ST_Expand(c.centre, 1.8 * c.radius + 15)) AS geom,
    c.centre, 1.8 * c.radius + 15 AS half, ST_DWithin(a.geom, c.geom, 1) AS beside
FROM sheet_cell c JOIN :"model".axis_used a ON a.geom && ST_Expand(c.centre, 1.8 * c.radius + 15) JOIN :"model".axis x ON x.axis_id = a.axis_id;
CREATE TEMP TABLE sheet_path ON COMMIT DROP AS
SELECT i, direction, tagged, level, string_agg('M' || translate(substring(ST_AsText(ST_SnapToGrid(ST_TransScale(d.geom, half - ST_X(centre), half - ST_Y(centre), 100 / half, 100 / half), 0.1)) FROM '\((.*)\)'), ',', 'L'), ' ') AS path
FROM sheet_line, ST_Dump(ST_CollectionExtract(geom, 2)) d GROUP BY i, direction, tagged, level;
COPY (
    SELECT format('<svg xmlns="http://www.w3.org/2000/svg" width="1640" height="%s" font-family="sans-serif" font-size="11"><rect width="100%%" height="100%%" fill="%s"/>', 20 + 245 * (1 + max(i) / 8), pg_temp.colour('paper')) FROM sheet_cell
    UNION ALL SELECT '<defs><marker id="a" markerUnits="userSpaceOnUse" markerWidth="9" markerHeight="9" refX="4" refY="4" orient="auto"><path d="M0 0 9 4 0 8z"/></marker></defs>'
    UNION ALL SELECT format('<g transform="translate(%s %s)"><rect width="200" height="200" fill="none" stroke="%s"/><text y="212">%s%s %s | %s</text><text y="225">r %s at %s %s</text><text y="237">%s</text><g transform="translate(0 200) scale(1 -1)" fill="none">%s</g></g>',
        10 + 204 * (i % 8), 10 + 245 * (i / 8), CASE WHEN missed THEN pg_temp.colour('arc') ELSE pg_temp.colour('structure') END, i, CASE WHEN way % 2 = 0 THEN 'e' ELSE 'o' END, round(score::numeric, 2), terms, round(radius), round(x), round(ST_Y(centre)),
        (SELECT left(replace(replace(string_agg(DISTINCT name, '; '), '&', '&amp;'), '<', '&lt;'), 36) FROM sheet_line l WHERE l.i = c.i AND beside),
        (SELECT string_agg(format('<path d="%s" stroke="%s" stroke-width="%s"%s%s/>', path, CASE WHEN tagged THEN pg_temp.colour('ring') WHEN direction = 'both' THEN pg_temp.colour('limit') ELSE pg_temp.colour('ink') END, CASE WHEN tagged THEN 5 ELSE 2 END,
            CASE WHEN level <> 0 THEN ' stroke-dasharray="6 3"' END, CASE direction WHEN 'direct' THEN ' marker-mid="url(#a)" marker-end="url(#a)"' WHEN 'reverse' THEN ' marker-mid="url(#a)" marker-start="url(#a)"' END), '' ORDER BY tagged DESC, level) FROM sheet_path p WHERE p.i = c.i))
    FROM sheet_cell c
    UNION ALL SELECT '</svg>') TO STDOUT \g :sheet
