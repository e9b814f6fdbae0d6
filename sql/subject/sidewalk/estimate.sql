-- The width of a sidewalk that nobody stated.

CREATE OR REPLACE FUNCTION streetgen.estimated_sidewalk(importance integer, walked_along boolean, widths float8[])
    RETURNS float8
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE WHEN NOT walked_along THEN 0 ELSE coalesce(streetgen._of_importance(importance, widths), 0) END;
COMMENT ON FUNCTION streetgen.estimated_sidewalk(integer, boolean, float8[]) IS
    'Width in metres of the sidewalk on each side of an axis that says none, from its importance (1 the highest) and '
    'the widths from importance 1 on, the last also for what is less important. 0 where people do not walk along its '
    'class (axis_class.walked_along), and for an importance that is NULL. An argument that is NULL is unknown.';

CREATE OR REPLACE FUNCTION streetgen._sidewalk_value_used(places jsonb) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT 'LEFT JOIN LATERAL (SELECT streetgen.estimated_sidewalk(coalesce(importance_known, '
        'importance_default), walked_along, sidewalks) AS sidewalk_usual HAVING true) '
        'sidewalk ON true' $$;
COMMENT ON FUNCTION streetgen._sidewalk_value_used(jsonb) IS
    'The step of view axis_used that gives the usual width of sidewalks.';
