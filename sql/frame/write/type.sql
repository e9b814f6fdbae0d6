-- The one statement leaves things that moved to the groups that follow it.
CREATE TYPE streetgen.moved_row AS (room text, id bigint, ground geometry);
COMMENT ON TYPE streetgen.moved_row IS 'Something that a run for some axes moved, for a group that follows it.';
COMMENT ON COLUMN streetgen.moved_row.room IS 'the subject of the group';
COMMENT ON COLUMN streetgen.moved_row.id IS 'a key that the subject knows; NULL where ground alone says what moved';
COMMENT ON COLUMN streetgen.moved_row.ground IS 'where something changed, as it was or as it is';
