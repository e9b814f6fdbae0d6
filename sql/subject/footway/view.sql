-- The ground of footways and areas, beside the roadway and the sidewalks.

CREATE OR REPLACE FUNCTION streetgen._area_kinds() RETURNS text[]
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN ARRAY['roadway', 'cycle', 'sidewalk', 'walk', 'steps', 'square', 'parking_area', 'platform'];
COMMENT ON FUNCTION streetgen._area_kinds() IS
    'The kinds of ground of a street, in the order in which these take ground from each other.';

CREATE OR REPLACE FUNCTION streetgen._ground_beside(box text, with_rails boolean) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._fill_template(concat(streetgen._part('ground_beside'),
            CASE WHEN with_rails THEN streetgen._part('tracks_beside') END),
        jsonb_build_object('box', box)) $$;
COMMENT ON FUNCTION streetgen._ground_beside(text, boolean) IS
    'A query of what lies beside ground g within the box of an expression, for the views of footways and areas.';

CREATE OR REPLACE FUNCTION streetgen._ground_view(part text, model name) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._fill_template(streetgen._part(part), jsonb_build_object('srid', m.srid,
            'wanted_ground', streetgen._fill_template(streetgen._part('wanted_ground'),
                jsonb_build_object('footway_ground', streetgen._part('footway_ground'))),
            'ground_at_box', streetgen._ground_beside('g.surface', with_rails),
            'ground_near_box', streetgen._ground_beside('ST_Expand(g.surface, 5)', with_rails)))
        FROM streetgen.model m, LATERAL (SELECT 'rail' = ANY (streetgen._subjects(model)) AS with_rails) r
        WHERE m.name = model $$;
COMMENT ON FUNCTION streetgen._ground_view(text, name) IS
    'The statement that makes a view of what footways or areas have of the ground beside the streets of a model.';

CREATE OR REPLACE FUNCTION streetgen._make_footway_views(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'footway' <> ALL (streetgen._subjects(model)) THEN
        RETURN;
    END IF;
    EXECUTE streetgen._ground_view('footway_surface', model);
    COMMENT ON VIEW footway_surface IS
        'The ground of each footway beside the roadway, tracks, the sidewalks and what comes before it: cycle tracks, '
        'then walks, then steps, of each the areas before the lines, and of these the older one. Computed when it is '
        'asked for; a footway whose ground is that of others, but for 0.01 m2, has no row';
    COMMENT ON COLUMN footway_surface.footway_id IS 'the footway';
    COMMENT ON COLUMN footway_surface.use IS 'walk, cycle or steps, as axis_class.use of its kind';
    COMMENT ON COLUMN footway_surface.level IS 'its level';
    COMMENT ON COLUMN footway_surface.width IS
        'its width, or that of its class, or setting mapped_sidewalk_minimal, metres';
    COMMENT ON COLUMN footway_surface.paved IS 'what it is paved with, as footway.surface; NULL: unknown';
    COMMENT ON COLUMN footway_surface.geom IS 'its middle';
    COMMENT ON COLUMN footway_surface.surface IS 'its ground';
    EXECUTE streetgen._ground_view('area_surface', model);
    COMMENT ON VIEW area_surface IS
        'The ground of each area of the street beside the roadway, tracks, the sidewalks, and the footways and areas '
        'that come before it: cycle, sidewalk, walk, steps, square, parking_area, platform, of each the areas before '
        'the lines, and of these the older one. Holes under setting max_hole_area are filled. Computed when it is '
        'asked for; an area whose ground is that of others, but for 0.01 m2, has no row, and an area of kind roadway '
        'neither';
    COMMENT ON COLUMN area_surface.street_area_id IS 'the area';
    COMMENT ON COLUMN area_surface.kind IS 'its kind, as street_area.kind';
    COMMENT ON COLUMN area_surface.level IS 'its level';
    COMMENT ON COLUMN area_surface.paved IS 'what it is paved with, as street_area.surface; NULL: unknown';
    COMMENT ON COLUMN area_surface.geom IS 'its ground as it is drawn';
    COMMENT ON COLUMN area_surface.surface IS 'its ground beside the others';
    EXECUTE streetgen._fill_template(streetgen._part('walk_link'), jsonb_build_object('model', quote_literal(model)));
    COMMENT ON VIEW walk_link IS
        'The network of what people walk on, a row for each piece between two nodes, in metres along geom. Computed '
        'when it is asked for, and so live; streetgen.walk_links has those of an extent alone';
    COMMENT ON COLUMN walk_link.walk_link_id IS 'key, of its shape: kept while the link lies where it lies';
    COMMENT ON COLUMN walk_link.kind IS
        'sidewalk: along a street; crossing: of a roadway; walk: another way; steps; elevator; square: over an '
        'area; street: on a roadway that has no sidewalk';
    COMMENT ON COLUMN walk_link.from_node IS 'node at its start, as in walk_node';
    COMMENT ON COLUMN walk_link.to_node IS 'node at its end';
    COMMENT ON COLUMN walk_link.level IS 'level that it lies on; 0: the ground';
    COMMENT ON COLUMN walk_link.metres IS 'length, metres';
    COMMENT ON COLUMN walk_link.width IS 'width, metres; of a street that of its roadway; NULL: unknown';
    COMMENT ON COLUMN walk_link.kerb_from IS
        'kerb where a crossing starts: raised, lowered, rolled, flush or no; NULL: unknown, or no crossing';
    COMMENT ON COLUMN walk_link.kerb_to IS 'the same where it ends';
    COMMENT ON COLUMN walk_link.marking IS
        'how a crossing is painted, as pedestrian_crossing.painted_as; NULL: nothing is known, or no crossing';
    COMMENT ON COLUMN walk_link.surface IS 
        'what it is paved with, as footway.surface or street_area.surface; NULL: unknown';
    COMMENT ON COLUMN walk_link.incline IS 'how steep it is from start to end, percent, up positive; NULL: unknown';
    COMMENT ON COLUMN walk_link.climb IS 'whether it leads up or down from start to end; NULL: unknown';
    COMMENT ON COLUMN walk_link.tactile_paving IS 'whether its paving guides the blind, as footway.tactile_paving';
    COMMENT ON COLUMN walk_link.wheelchair IS
        'whether a wheelchair gets along: yes, limited or no, as is said or follows from steps, kerbs, width and '
        'incline; NULL: nothing speaks against it';
    COMMENT ON COLUMN walk_link.foot IS 'who may walk there, as footway.foot; NULL: nothing is said, and all may';
    COMMENT ON COLUMN walk_link.barriers IS 'types of objects that protect, such as bollards, on it; NULL: none';
    COMMENT ON COLUMN walk_link.footway_id IS 'the footway that maps it; NULL: no source does';
    COMMENT ON COLUMN walk_link.edge_id IS 'the edge that it lies along or crosses; NULL: a mapped one';
    COMMENT ON COLUMN walk_link.side IS 'of a sidewalk that no source maps, the side of its kerb, as kerb.side';
    COMMENT ON COLUMN walk_link.street_object_id IS 'the object that the crossing is; NULL: none';
    COMMENT ON COLUMN walk_link.geom IS 'its middle, from from_node to to_node';
    CREATE OR REPLACE VIEW walk_node WITH (security_invoker = true) AS
    SELECT node_id, count(*) AS links, (array_agg(place))[1] AS geom
    FROM walk_link, LATERAL (VALUES (from_node, ST_StartPoint(geom)), (to_node, ST_EndPoint(geom))) v(node_id, place)
    GROUP BY node_id;
    COMMENT ON VIEW walk_node IS 'Where links of what people walk on meet or end';
    COMMENT ON COLUMN walk_node.node_id IS 'key, of its place: kept while links meet there';
    COMMENT ON COLUMN walk_node.links IS 'how many links start or end there';
    COMMENT ON COLUMN walk_node.geom IS 'place';
END $$;
COMMENT ON FUNCTION streetgen._make_footway_views(name) IS
    'Makes the views of a model that computes footways: their ground, that of areas, and the network of what '
    'people walk on.';

CREATE OR REPLACE FUNCTION streetgen._footway_view() RETURNS TABLE(name name, subject text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 4 SET search_path = pg_catalog
    AS $$ VALUES ('footway_surface'::name, 'footway'), ('area_surface', 'footway'), ('walk_node', 'footway'),
        ('walk_link', 'footway') $$;
COMMENT ON FUNCTION streetgen._footway_view() IS 'The views of footways, and the subject whose tables they read.';
