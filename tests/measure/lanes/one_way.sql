-- Variables file and srid: of the tables ways_…, rows of table guess.
SELECT set_config('measure.srid', :'srid', false), set_config('measure.file', :'file', false);
DO $$
DECLARE
    tenth integer;
BEGIN
    CREATE TEMPORARY TABLE said AS SELECT way_id, tags FROM ways_line;
    FOR tenth IN 0 .. 9 LOOP
        UPDATE ways_line l SET tags = s.tags FROM said s WHERE s.way_id = l.way_id AND l.tags IS DISTINCT FROM s.tags;
        UPDATE ways_line SET tags = tags - 'lanes' - 'lanes:forward' - 'lanes:backward' WHERE abs(hashtext(way_id::text)) % 10 = tenth;
        PERFORM streetgen.create_model('ways', current_setting('measure.srid')::integer, subjects => '{}');
        PERFORM FROM streetgen.import_osm('ways', 'ways');
        INSERT INTO guess
        SELECT current_setting('measure.file'), a.kind, (s.tags ->> 'lanes')::integer, u.lane_count
        FROM said s JOIN ways.axis a ON a.source_ref = s.way_id::text JOIN ways.axis_used u USING (axis_id)
        WHERE abs(hashtext(s.way_id::text)) % 10 = tenth AND u.direction <> 'both' AND s.tags ->> 'lanes' ~ '^[1-9]$';
        PERFORM streetgen.drop_model('ways');
    END LOOP;
END $$;
