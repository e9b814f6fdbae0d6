-- This says what each column of a design means, in its tables and in the views to edit them.
CREATE OR REPLACE FUNCTION streetgen._design_column() RETURNS TABLE(relation name, attribute name, description text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 200 SET search_path = pg_catalog
    AS $$
WITH own(relation, attribute, description) AS (VALUES
    ('terrain_tile'::name, 'geom'::name, 'the box of the tile'),
    ('terrain_tile', 'heights', 'heights of the ground, metres: raster WKB, first band'),
    ('terrain_tile', 'content', 'hash of the heights'),
    ('zone_class', 'class', 'name of the class'),
    ('zone_class', 'cost', 'cost of each square metre that a road crosses'),
    ('zone_class', 'passage', 'free, bridge: on a bridge or in a tunnel alone, or forbidden'),
    ('zone', 'class', 'its class, see zone_class'),
    ('zone', 'geom', 'its ground'),
    ('zone', 'content', 'hash of its ground'),
    ('design_standard', 'speed', 'base speed, km/h'),
    ('design_standard', 'radius', 'least radius of a curve, metres'),
    ('design_standard', 'radius_normal', 'normal radius of a curve, metres'),
    ('design_standard', 'clothoid', 'parameter A of clothoids at the least radius, metres'),
    ('design_standard', 'grade', 'greatest grade, rise over run'),
    ('design_standard', 'crest', 'least radius of a parabola on a crest, metres'),
    ('design_standard', 'sag', 'least radius of a parabola in a sag, metres'),
    ('design_standard', 'stopping', 'stopping distance, metres'),
    ('design_class', 'network', 'highway, secondary or rural'),
    ('design_class', 'speed', 'base speed, km/h, a row of design_standard'),
    ('design_class', 'width', 'width of the formation, which costs are reckoned with, metres'),
    ('design_class', 'carriageways', '1, or 2 that are one-way axes beside the alignment'),
    ('design_class', 'lane_count', 'lanes of each carriageway'),
    ('design_class', 'roadway_width', 'width of each carriageway kerb to kerb, metres'),
    ('design_class', 'median_width', 'width between two carriageways, metres'),
    ('design_class', 'taper', 'length over which two carriageways come together at a node, metres'),
    ('design_class', 'importance', 'importance of the axes, 1 the highest'),
    ('design_node', 'name', 'name of the town'),
    ('design_node', 'kind', 'city, town, village, or interchange'),
    ('design_node', 'importance', 'people, as a rule; 0 of interchanges'),
    ('design_node', 'geom', 'place'),
    ('design_link', 'node_a', 'node where it begins'),
    ('design_link', 'node_b', 'node where it ends'),
    ('design_link', 'network', 'highway, secondary or rural'),
    ('design_link', 'length', 'straight length of the link before it was cut at interchanges, km'),
    ('design_link', 'utilisation', 'equation 1: thousands of people squared per km2'),
    ('design_link', 'benefit', 'equation 2 times setting link_factor, km of road; infinite: there is no other way'),
    ('design_link', 'cost', 'cost of the link, km of road'),
    ('design_link', 'method', 'NULL: as wanted; breaks radius, grade, crest, sag: rules of its standard that it '
        'breaks; no_path: and what bars it (terrain, zone, grade or turn)'),
    ('design_link', 'geom', 'the road, chords of a centimetre of sagitta'),
    ('design_link', 'town_a', 'town where it began before it was cut at interchanges; NULL: not known'),
    ('design_link', 'town_b', 'town where it ended before it was cut at interchanges; NULL: not known'),
    ('design_vertex', 'design_link_id', 'the link'),
    ('design_vertex', 'ordinality', 'place among the vertices of the link; parts of a number are fine'),
    ('design_vertex', 'geom', 'place'),
    ('design_vertex', 'radius', 'radius of the curve there by hand, metres; NULL: by setting curve_radius'),
    ('design_vertex', 'clothoid_in', 'parameter A of the clothoid before the arc, metres, where radius is given'),
    ('design_vertex', 'clothoid_out', 'parameter A of the clothoid behind the arc, metres, where radius is given'),
    ('design_vertex', 'straight_in', 'by hand: is the side before it straight? Else the search fills it'),
    ('design_vertex', 'straight_out', 'by hand: is the side behind it straight? Both ends of a side have to say so'),
    ('alignment_element', 'design_link_id', 'the link'),
    ('alignment_element', 'ordinality', 'number along the link, from 1'),
    ('alignment_element', 'kind', 'line, clothoid or arc'),
    ('alignment_element', 'abscissa', 'of its start along the link, metres'),
    ('alignment_element', 'start', 'where it starts'),
    ('alignment_element', 'heading', 'at its start, radians counter-clockwise from the x axis'),
    ('alignment_element', 'length', 'metres'),
    ('alignment_element', 'curvature_start', '1/m, positive on left bends'),
    ('alignment_element', 'curvature_end', '1/m, positive on left bends'),
    ('grade_point', 'design_link_id', 'the link'),
    ('grade_point', 'abscissa', 'along the link, metres'),
    ('grade_point', 'height', 'where the straight grades meet, metres'),
    ('grade_point', 'radius', 'radius of the parabola, metres; 0 or NULL: none'),
    ('grade_point', 'geom', 'its place at its height'),
    ('design_crossing', 'design_link_id', 'the link that is built later'),
    ('design_crossing', 'other_link_id', 'the link that it crosses'),
    ('design_crossing', 'abscissa', 'along the link, metres; -1: by hand, and the links do not cross now'),
    ('design_crossing', 'other_abscissa', 'along the other link, metres; -1 as abscissa'),
    ('design_crossing', 'kind', 'over or under the other link, by setting clearance, or at its level'),
    ('design_crossing', 'geom', 'place'),
    ('structure', 'design_link_id', 'the link'),
    ('structure', 'kind', 'bridge or tunnel'),
    ('structure', 'start_abscissa', 'where it begins along the link, metres'),
    ('structure', 'end_abscissa', 'where it ends along the link, metres'),
    ('structure', 'geom', 'the road on it'),
    ('design_input', 'stage', 'the stage'),
    ('design_input', 'design_link_id', 'the link; 0: a stage of all links'),
    ('design_input', 'input_hash', 'hash of what the stage was computed from')),
shared AS (SELECT relation, u.attribute, u.description FROM streetgen._design_table() t,
    LATERAL (VALUES (t.relation || '_id', 'key'),
        ('by_hand', 'was the row made or changed by hand? It stays then, and is input'),
        ('rejected', 'is the row out of the design? By hand: it was deleted and never comes back; not by hand: it is '
            'no longer wanted, and waits for the rows by hand of a link')) u(attribute, description)),
each AS (SELECT * FROM own UNION ALL SELECT relation, attribute::name, description FROM shared)
SELECT * FROM each UNION ALL SELECT relation || '_editing', attribute, description FROM each
    WHERE attribute <> 'content' AND relation <> 'design_input' $$;
COMMENT ON FUNCTION streetgen._design_column() IS
    'The columns of the tables of a design and of their views, and what each is.';

CREATE OR REPLACE FUNCTION streetgen._comment_design(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
DECLARE
    remark record;
BEGIN
    FOR remark IN SELECT * FROM streetgen._design_column() c
        WHERE to_regclass(format('%I.%I', model, c.relation)) IS NOT NULL
    LOOP
        EXECUTE format('COMMENT ON COLUMN %I.%I.%I IS %L', model, remark.relation, remark.attribute,
            remark.description);
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._comment_design(name) IS 'Comments every column of a design''s tables and views.';
