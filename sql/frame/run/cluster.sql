-- Axes in clusters, and the plan of a run by clusters.

CREATE OR REPLACE FUNCTION streetgen._clusters(x float8[], y float8[], k integer) RETURNS integer[]
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 10000 AS 'MODULE_PATHNAME', 'streetgen_clusters';
COMMENT ON FUNCTION streetgen._clusters(float8[], float8[], integer) IS
    'The cluster, 1 to k, of each point: K-means by bisection, of equal sizes. k beyond the number of points: 22023.';

-- One place for all axes of the model, and for edges whose axis is gone.
CREATE OR REPLACE FUNCTION streetgen._axis_lines(model name) RETURNS TABLE(axis_id bigint, geom geometry)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT axis_id, ST_Force2D(geom) FROM axis
        UNION ALL (SELECT DISTINCT ON (axis_id) axis_id, ST_Force2D(geom) FROM edge e
            WHERE NOT EXISTS (SELECT FROM axis a WHERE a.axis_id = e.axis_id)
            ORDER BY axis_id, start_abscissa);
END $$;
COMMENT ON FUNCTION streetgen._axis_lines(name) IS
    'The line of each axis of a model, and one edge of each that is gone and has left edges behind.';

CREATE OR REPLACE FUNCTION streetgen.cluster(model name, k integer) RETURNS TABLE(axis_id bigint, cluster integer)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 10000 SET search_path = pg_catalog, public
    AS $$
DECLARE
    ids bigint[];
    x float8[];
    y float8[];
BEGIN
    PERFORM streetgen._require_reader(model);
    IF k IS NULL THEN
        RAISE EXCEPTION 'k, the number of clusters of model "%", is NULL', model USING ERRCODE = '22004',
            HINT = 'At least 1, at most one an axis.';
    END IF;
    SELECT coalesce(array_agg(c.axis_id), '{}'), array_agg(ST_X(centroid)), array_agg(ST_Y(centroid)) INTO ids, x, y
        FROM (SELECT l.axis_id, ST_Centroid(geom) AS centroid FROM streetgen._axis_lines(model) l
            ORDER BY 1 OFFSET 0) c;
    IF k < 1 OR k > greatest(cardinality(ids), 1) THEN
        RAISE EXCEPTION 'model "%" cannot be parted in % clusters', model, k USING ERRCODE = '22023',
            DETAIL = format('It has %s axes.', cardinality(ids)), HINT = 'At least 1, at most one an axis.';
    END IF;
    RETURN QUERY SELECT * FROM unnest(ids, streetgen._clusters(x, y, k));
END $$;
COMMENT ON FUNCTION streetgen.cluster(name, integer) IS
    'Parts the axes of a model, by their centroids, in clusters 1 to k of equal size (or one axis more): K-means by '
    'bisection. A set is cut by a straight line across its longest extent, then as K-means does: each axis goes to '
    'the nearer centre as far as the sizes allow, and the centres follow, until nothing changes; each half is cut the '
    'same way. The same axes give the same clusters; clusters that follow each other are neighbours. Axes that are '
    'gone and have left edges behind count. No axes: no rows. k that is NULL: 22004; beyond 1 to the number of axes: '
    '22023. Source: the StreetGen paper, figure 29.';

CREATE OR REPLACE FUNCTION streetgen._setting_hash(model name) RETURNS bigint
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    hash bigint;
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT setting_hash FROM axis_used LIMIT 1 INTO hash;
    RETURN coalesce(hash, 0);
END $$;
COMMENT ON FUNCTION streetgen._setting_hash(name) IS 'Hash of the settings of a model; 0 for one without axes.';

CREATE OR REPLACE FUNCTION streetgen.plan_clusters(model name, clusters integer DEFAULT NULL,
    sessions integer DEFAULT 1) RETURNS integer
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    -- Smaller ones spend more on their surroundings, larger ones more memory, and edits wait longer for them.
    axes_of_cluster constant integer := 2500;
    many bigint;
    planned integer;
    left_over integer;
    same integer;
    came integer;
    hash bigint;
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_owner(model);
    PERFORM streetgen._check_settings(model);
    IF clusters < 1 OR sessions IS NULL OR sessions < 1 THEN
        RAISE EXCEPTION 'model "%" cannot be computed in % clusters by % sessions', model,
            coalesce(clusters::text, 'some'), coalesce(sessions::text, 'NULL') USING ERRCODE = '22023',
            HINT = 'At least one of each.';
    END IF;
    -- Beside sessions that compute a cluster, but not beside another plan.
    LOCK TABLE cluster IN SHARE UPDATE EXCLUSIVE MODE;
    hash := streetgen._setting_hash(model);
    SELECT count(*), count(*) FILTER (WHERE setting_hash = hash), count(*) FILTER (WHERE ended IS NULL
        AND setting_hash = hash) FROM cluster INTO planned, same, left_over;
    IF left_over > 0 OR same > 0 AND streetgen._keys_are_missing(model) THEN
        -- Axes that came since, in no cluster, are one more.
        INSERT INTO cluster (cluster_id, axes, hull, setting_hash)
            SELECT max(k.cluster_id) + 1, n.ids, n.hull, hash FROM cluster k, (
                SELECT array_agg(a.axis_id) AS ids, ST_ConvexHull(ST_Collect(geom)) AS hull
                    FROM streetgen._axis_lines(model) a
                WHERE NOT EXISTS (SELECT FROM cluster c, unnest(c.axes) id WHERE id = a.axis_id)) n
                    WHERE n.ids IS NOT NULL GROUP BY n.ids, n.hull;
        GET DIAGNOSTICS came = ROW_COUNT;
        IF came > 0 THEN
            -- They may change what is computed already.
            PERFORM streetgen._lock_model(model, wait => true, alone => false);
        END IF;
        RAISE NOTICE 'model "%": % of % clusters are done, the run goes on', model, planned - left_over, planned;
        SELECT count(*) FROM cluster WHERE ended IS NULL INTO left_over;
        RETURN left_over;
    END IF;
    PERFORM streetgen._check_scale(lines), streetgen._check_length(model, lines)
        FROM format('SELECT ''axis '' || axis_id AS label, geom FROM %I.axis', model) lines;
    SELECT count(*) INTO many FROM streetgen._axis_lines(model);
    planned := least(many, coalesce(clusters, sessions * ceil(many / (axes_of_cluster::float8 * sessions))));
    DELETE FROM cluster;
    IF streetgen._keys_are_missing(model) OR streetgen._has_no_results(model) THEN
        PERFORM streetgen._lock_model(model, wait => true, alone => true);
        IF streetgen._has_no_results(model) THEN
            PERFORM streetgen._defer_keys(model);
        END IF;
    END IF;
    IF planned > 0 THEN
        INSERT INTO cluster (cluster_id, axes, hull, setting_hash)
            SELECT c.cluster, array_agg(c.axis_id ORDER BY c.axis_id), ST_ConvexHull(ST_Collect(geom)), hash
            FROM streetgen.cluster(model, planned) c JOIN streetgen._axis_lines(model) a USING (axis_id) GROUP BY
                c.cluster;
    END IF;
    RETURN planned;
END $$;
COMMENT ON FUNCTION streetgen.plan_clusters(name, integer, integer) IS
    'Plans a run of a model by clusters (about 2,500 axes each where their number is NULL, as many as sessions at '
    'least) in its table cluster, and returns how many are to be computed. A run that was planned with the same '
    'settings and has not ended goes on: what is done stays done, and axes that came since are one more cluster; 0 '
    'where only keys are left to make. Clusters are computed by streetgen.generate_cluster. Where nothing was derived '
    'yet, and of a thousand axes and more, foreign keys and indexes are taken off, all but those by which clusters '
    'find rows; streetgen.finish_clusters makes them after the last cluster, and an edit or streetgen.generate '
    'before. Needs the rights of the owner (42501); a number under 1: 22023; settings and scale as for '
    'streetgen.generate.';
