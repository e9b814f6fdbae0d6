-- What each transaction edited: its rows in edit_log as one.

--{activity
CREATE OR REPLACE VIEW activity WITH (security_invoker = true) AS
SELECT min(edit_log_id) AS activity_id, coalesce(began, at) AS began, max(at) AS ended, who, count(*) AS statements,
    string_agg(DISTINCT relation, ', ' ORDER BY relation) AS relations,
    ST_SetSRID(ST_Extent(extent)::geometry, {srid})::geometry(Polygon, {srid}) AS extent
FROM edit_log GROUP BY coalesce(began, at), who
