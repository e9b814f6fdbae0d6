-- Links that a model follows, the words of sources at the last delivery, and conflicts that wait for somebody.

CREATE TABLE :"model".followed (
    source text PRIMARY KEY,
    mapping jsonb NOT NULL);
COMMENT ON TABLE :"model".followed IS
    'Tables that the model is in step with: streetgen.follow and unfollow write it, adopt_model reads it';
COMMENT ON COLUMN :"model".followed.source IS 'the table, as in axis.source';
COMMENT ON COLUMN :"model".followed.mapping IS 'column of axis -> column of the table, or {"value": constant}';

CREATE TABLE :"model".delivered (
    relation text NOT NULL, source text NOT NULL, source_ref text NOT NULL, row_id bigint NOT NULL, said jsonb,
    source_geom geometry, cleaned geometry, gone boolean NOT NULL DEFAULT false,
    PRIMARY KEY (source, source_ref, relation));
COMMENT ON TABLE :"model".delivered IS
    'What sources said last: importers write it, and tell by it what is by hand. Delete a row that has no axis any '
    'more, and the next delivery brings the axis anew';
COMMENT ON COLUMN :"model".delivered.relation IS 'key: the table that it became a row of';
COMMENT ON COLUMN :"model".delivered.source IS 'key: the source, as in that table';
COMMENT ON COLUMN :"model".delivered.source_ref IS 'key: its identity in the source';
COMMENT ON COLUMN :"model".delivered.row_id IS 'the key of that row, which may have been deleted by hand';
COMMENT ON COLUMN :"model".delivered.said IS
    'what the source said last, column by column; NULL: an older build did not keep it';
COMMENT ON COLUMN :"model".delivered.source_geom IS
    'its line or point as the source has it, in the reference of the model';
COMMENT ON COLUMN :"model".delivered.cleaned IS 'its line as it was cleaned; NULL: as source_geom';
COMMENT ON COLUMN :"model".delivered.gone IS
    'has the source deleted it since? The row stays for what was edited by hand';

CREATE TABLE :"model".open_conflict (
    relation text NOT NULL, row_id bigint NOT NULL, column_name text NOT NULL, source text, source_ref text,
    by_hand text, source_old text, source_new text, stands text NOT NULL CHECK (stands IN ('hand', 'source')),
    PRIMARY KEY (relation, row_id, column_name));
COMMENT ON TABLE :"model".open_conflict IS 'Conflicts of view import_conflict: streetgen.settle_conflict ends one';
COMMENT ON COLUMN :"model".open_conflict.relation IS 'key: the table of the row';
COMMENT ON COLUMN :"model".open_conflict.row_id IS 'key: the key of the row';
COMMENT ON COLUMN :"model".open_conflict.column_name IS
    'key: the column; *: the whole row, deleted by hand or by the source';
COMMENT ON COLUMN :"model".open_conflict.source IS 'the source, as in that table';
COMMENT ON COLUMN :"model".open_conflict.source_ref IS 'its identity in the source';
COMMENT ON COLUMN :"model".open_conflict.by_hand IS
    'the value by hand; geometry as EWKB; NULL: empty, or of *: deleted by hand';
COMMENT ON COLUMN :"model".open_conflict.source_old IS
    'what the source said when that was edited; of *: what it said otherwise';
COMMENT ON COLUMN :"model".open_conflict.source_new IS
    'what the source says now; NULL: nothing, or of *: deleted by the source';
COMMENT ON COLUMN :"model".open_conflict.stands IS 'hand or source: whose value the row has, by setting delivery_wins';
