-- Decisions by hand that lie on no axis: what is known of the road where they lost theirs.

CREATE OR REPLACE FUNCTION streetgen._note_lost_places(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF EXISTS (SELECT FROM lost_place WHERE lanes IS NULL) THEN
        PERFORM streetgen._call_rooms('_note_lost_%s', model, streetgen._rooms_of(model));
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._note_lost_places(name) IS
    'Notes what rooms know of the road where decisions of a model just lost their axes, by functions _note_lost_ROOM.';

CREATE OR REPLACE FUNCTION streetgen._forget_lost_places(model name, extent geometry) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    -- Nobody waits for a row that another edit forgets just now.
    DELETE FROM lost_place WHERE (relation, override_id, role) IN (SELECT l.relation, l.override_id, l.role
        FROM lost_place l WHERE l.geom && ST_Expand(extent, 110) AND NOT EXISTS (SELECT FROM override_place p
            WHERE (p.relation, p.override_id, p.role, p.axis_id) = (l.relation, l.override_id, l.role, l.axis_id)
                AND NOT EXISTS (SELECT FROM axis a WHERE a.axis_id = p.axis_id
                    AND ST_DWithin(streetgen._remap_part_of_axis(p.anchor, ST_Force2D(a.geom)), p.geom, p.reach)))
        FOR UPDATE OF l SKIP LOCKED);
END $$;
COMMENT ON FUNCTION streetgen._forget_lost_places(name, geometry) IS
    'Forgets the lost places of a model near an extent whose decisions are gone or lie on an axis again.';
