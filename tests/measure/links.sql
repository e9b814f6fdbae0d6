-- The network of links of a model: psql -v model=NAME -f tests/measure/links.sql prints links, what does not join, who gives way, and what a value of it takes.
\set ON_ERROR_STOP on
SET client_min_messages = error;
CREATE TEMPORARY TABLE network AS SELECT streetgen._network_of_links(:'model') AS bytes;
CREATE TEMPORARY TABLE piece AS SELECT p.*, p.ends - p.starts AS length FROM network, streetgen._link_pieces(bytes) p;
CREATE TEMPORARY TABLE course AS
SELECT link_id, (array_agg(x ORDER BY starts))[1] AS x_from, (array_agg(y ORDER BY starts))[1] AS y_from, (array_agg(heading ORDER BY starts))[1] AS heading_from,
    (array_agg(x + chord * cos(direction) ORDER BY starts DESC))[1] AS x_to, (array_agg(y + chord * sin(direction) ORDER BY starts DESC))[1] AS y_to,
    (array_agg(heading + curvature * length ORDER BY starts DESC))[1] AS heading_to, max(ends) AS length, count(*) AS pieces
FROM (SELECT *, CASE WHEN curvature = 0 THEN length ELSE 2 * sin(curvature * length / 2) / curvature END AS chord, heading + curvature * length / 2 AS direction FROM piece) p GROUP BY link_id;
CREATE TEMPORARY TABLE joint AS
SELECT sqrt((a.x_to - b.x_from) ^ 2 + (a.y_to - b.y_from) ^ 2) AS gap, degrees(abs(atan2(sin(a.heading_to - b.heading_from), cos(a.heading_to - b.heading_from)))) AS turn
FROM (SELECT comes_from AS a, link_id AS b FROM :"model".link UNION ALL SELECT link_id, leads_to FROM :"model".link) j
    JOIN course a ON a.link_id = j.a JOIN course b ON b.link_id = j.b;
SELECT count(*) AS links, count(*) FILTER (WHERE kind = 'movement') AS movements, (SELECT count(*) FROM :"model".movement WHERE connecting) AS connecting,
    round(avg(pieces), 1) AS pieces, round((SELECT length(bytes) FROM network)::numeric / count(*)) AS bytes_a_link, round(max(abs(c.length - l.length))::numeric, 2) AS longer_at_most
FROM :"model".link l JOIN course c USING (link_id);
SELECT count(*) AS joints, count(*) FILTER (WHERE gap > 1e-6) AS gaps, count(*) FILTER (WHERE turn > 0.1) AS turns_over_a_tenth_of_a_degree FROM joint;
SELECT precedence, count(*) FROM network, streetgen._link_conflict_rows(bytes) GROUP BY precedence ORDER BY precedence;
