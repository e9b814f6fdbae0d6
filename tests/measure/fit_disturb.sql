-- Points of the kerbs of a model as :points, so many metres apart, then widths between 0.7 and 1.3 of theirs and each
-- vertex moved by a metre: psql -v model=MODEL -v points=TABLE -v apart=METRES -v noise=METRES -v seed=TEXT. Table
-- :points followed by _truth keeps what was. Equal places move alike.
CREATE OR REPLACE FUNCTION pg_temp.share(of text) RETURNS float8 LANGUAGE sql
    AS $$ SELECT (hashtextextended(of, 0) & 9007199254740991) / 9007199254740992.0::float8 $$;
CREATE OR REPLACE FUNCTION pg_temp.off(of text, reach float8) RETURNS float8 LANGUAGE sql
    AS $$ SELECT reach * sqrt(-2 * ln(1 - pg_temp.share(of || 'a'))) * cos(6.283185307 * pg_temp.share(of || 'b')) $$;
CREATE TABLE :points AS
SELECT row_number() OVER () AS id, ST_Translate(place, pg_temp.off(place::text || 'x' || :'seed', :noise),
    pg_temp.off(place::text || 'y' || :'seed', :noise)) AS geom
FROM :model.kerb k, LATERAL (SELECT greatest(1, round(ST_Length2D(k.geom) / :apart)) AS steps) s,
    generate_series(1, steps::integer) n, ST_Force2D(ST_LineInterpolatePoint(k.geom, (n - 0.5) / steps)) place
WHERE k.node_id IS NULL AND k.side <> 'start' AND k.side <> 'end';
SELECT :'points' || '_truth' AS truth \gset
CREATE TABLE :truth AS SELECT axis_id, a.geom, u.width FROM :model.axis a JOIN :model.axis_used u USING (axis_id);
UPDATE :model.axis a SET width = t.width * (0.7 + 0.6 * pg_temp.share(a.axis_id || 'w' || :'seed')), geom = m.geom
FROM :truth t, LATERAL (
    SELECT ST_MakeLine(ST_Translate(d.geom, cos(turn), sin(turn)) ORDER BY d.path) AS geom
    FROM ST_DumpPoints(t.geom) d,
        LATERAL (SELECT 6.283185307 * pg_temp.share(ST_AsText(d.geom, 3) || :'seed')) v(turn)) m
WHERE t.axis_id = a.axis_id;
