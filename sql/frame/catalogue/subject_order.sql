-- The list of subjects, in the order in which they are computed, with what each needs and how far it reaches.

CREATE OR REPLACE FUNCTION streetgen._subject()
    RETURNS TABLE(place integer, subject text, needs text[], reach text, always boolean, by_default boolean,
        cost text, description text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 5 SET search_path = pg_catalog
    AS $$ VALUES
    (1, 'network', '{}'::text[], 'near', true, true, 'is part of every model',
        'nodes where axes meet or end, edges between them, and what the network step noticed'),
    (2, 'surface', '{network}'::text[], 'near', true, true, 'is part of every model',
        'section limits, sections, corners and intersections: the roadway'),
    (3, 'lane', '{surface}'::text[], 'near', false, true,
        'with interconnection nearly half of the processor time of a first run',
        'lanes, the lines between them, and what is painted on them'),
    (4, 'interconnection', '{lane}'::text[], 'near', false, true,
        'with lane nearly half of the processor time of a first run',
        'paths from lane to lane at every node'),
    (5, 'kerb', '{surface}'::text[], 'near', false, false, 'a tenth of the processor time of a first run',
        'kerbs: the border of the roadway, and the strip of stones behind it'),
    (6, 'rail', '{surface}'::text[], 'group', false, false, 'nothing where no track lies',
        'tracks in streets: the stretches of the roadway that they share, and the sidewalks that they cut'),
    (7, 'alignment', '{network}'::text[], 'chain', false, false, 'little',
        'roads: edges that go on from each other, as straight pieces and arcs that touch them'),
    (9, 'block', '{kerb}'::text[], 'group', false, false, 'little beside kerb',
        'city blocks: what streets enclose, less the roadway, and which block lies on each side of an edge'),
    (8, 'roundabout', '{surface}'::text[], 'near', false, false, 'a tenth of the surfaces',
        'roundabouts: rings of the network with their scores; traffic on accepted ones goes round'),
    (10, 'sidewalk', '{kerb}', 'chain', false, false, 'more than the surfaces',
        'sidewalks: strips behind the kerbs'),
    (13, 'footway', '{sidewalk}', 'near', false, false,
        'little by itself; the wide sidewalks that it makes cost up to as much as the streets',
        'footways that a source maps apart from the streets, as the sidewalks of the sides along which they run'),
    (12, 'junction', '{interconnection}'::text[], 'group', false, false, 'a fifth of a run with lanes and paths',
        'nodes that are one junction, the kind of each, and the paths across them'),
    (11, 'ramp', '{interconnection}'::text[], 'near', false, false, 'nothing that shows',
        'ramps: where links meet highways, tangent to their lanes, and the merging lanes there'),
    (16, 'signal', '{junction}', 'group', false, false, 'about as much as junction',
        'signals: the program of each junction of kind signals, its states, and where lanes wait'),
    (14, 'overpass', '{network}'::text[], 'near', false, false, 'little',
        'overpasses: where two edges cross without a node, and which of them is above'),
    (15, 'height', '{overpass}'::text[], 'chain', false, false, 'little',
        'heights along edges, with clearances and grades where roads pass over and under each other'),
    (17, 'bridge', '{overpass}'::text[], 'group', false, false, 'little',
        'bridges and tunnels: stretches of edges over others, or off the ground by their level'),
    (18, 'object', '{kerb}'::text[], 'group', false, false, 'by the number of objects',
        'what stands at streets: objects that follow their axes, and the edge at which each stands'),
    (19, 'fit', '{surface}'::text[], 'group', false, false, 'by the number of observations',
        'how far observed kerbs lie from those of the streets, and proposals that bring streets nearer to them') $$;
COMMENT ON FUNCTION streetgen._subject() IS
    'The subjects of models in the order in which they are computed. needs: the subjects whose rows a subject reads. '
    'reach: how far what a row is computed from lies. near: within the reach around the axis. chain: as far as roads '
    'or kerbs lead on from each other; a first run by clusters leaves these subjects to its end. group: over rows of '
    'many axes, such as a junction or a block, when these are written. '
    'always: a model cannot do without it. by_default: a new model computes it unless told '
    'otherwise. For every subject there is a template of its computed tables (streetgen.template). What is near or a '
    'chain has a function _upsert_<subject> (places), its part of the one statement. A group has a function '
    '_update_<subject>, or is computed with a subject that it needs.';

CREATE OR REPLACE FUNCTION streetgen._subjects_of_reach(how_far text) RETURNS text[]
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT ARRAY(SELECT s.subject FROM streetgen._subject() s WHERE s.reach = how_far ORDER BY s.place) $$;
COMMENT ON FUNCTION streetgen._subjects_of_reach(text) IS
    'The subjects of one reach (near, chain or group), in their order.';

-- PL/pgSQL, so that a session plans it once: an edit asks several times.
CREATE OR REPLACE FUNCTION streetgen._subjects(model name) RETURNS text[]
    LANGUAGE plpgsql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
BEGIN
    RETURN ARRAY(SELECT s.subject FROM streetgen._subject() s
        WHERE s.subject NOT IN (SELECT t.subject FROM streetgen._computed_table() t
            WHERE to_regclass(format('%I.%I', model, t.relation)) IS NULL) ORDER BY s.place);
END $$;
COMMENT ON FUNCTION streetgen._subjects(name) IS
    'The subjects that a model computes, in their order: those whose tables are all there.';

CREATE OR REPLACE FUNCTION streetgen._require_words(subjects text[]) RETURNS void
    LANGUAGE plpgsql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
DECLARE
    word text;
    all_words constant text[] := ARRAY(SELECT s.subject FROM streetgen._subject() s ORDER BY s.place);
BEGIN
    FOREACH word IN ARRAY coalesce(subjects, '{}') LOOP
        IF word IS NULL OR word <> ALL (all_words) THEN
            RAISE EXCEPTION 'there is no subject "%"', coalesce(word, 'NULL') USING ERRCODE = '22023',
                HINT = 'The subjects are ' || array_to_string(all_words, ', ') || '.';
        END IF;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._require_words(text[]) IS 'Raises 22023 for the first word that is no subject.';

CREATE OR REPLACE FUNCTION streetgen._with_needs(subjects text[]) RETURNS text[]
    LANGUAGE plpgsql STABLE PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._require_words(ARRAY(SELECT unnest(subjects)
        EXCEPT SELECT unnest('{all,default,drawn}'::text[])));
    RETURN ARRAY(
        WITH RECURSIVE wanted(subject, needs) AS (
            SELECT s.subject, s.needs FROM streetgen._subject() s
            WHERE s.always OR s.subject = ANY (subjects) OR 'all' = ANY (subjects)
                OR s.by_default AND (subjects IS NULL OR 'default' = ANY (subjects))
                OR 'drawn' = ANY (subjects)
                    AND to_regprocedure(format('streetgen._%s_drawn(name, geometry, text[])', s.subject)) IS NOT NULL
            UNION SELECT s.subject, s.needs FROM wanted w JOIN streetgen._subject() s ON s.subject = ANY (w.needs))
        SELECT s.subject FROM streetgen._subject() s JOIN wanted w USING (subject) GROUP BY s.subject, s.place
        ORDER BY s.place);
END $$;
COMMENT ON FUNCTION streetgen._with_needs(text[]) IS
    'Subjects with all that they need and those of every model, in their order. The word all stands for every subject, '
    'drawn for those that pictures show, default or NULL for those that a new model computes where nothing is said. '
    'Another word: 22023.';
