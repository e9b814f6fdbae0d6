-- argument role: the role, or public: everybody
-- argument kind: reader, or editor: also edits axes, turn restrictions and overrides
-- see revoke, create_model
SELECT streetgen.grant('town', 'public', 'reader');
SELECT has_table_privilege('public', 'town.section', 'SELECT') AS reads, has_table_privilege('public', 'town.axis', 'INSERT') AS edits;
