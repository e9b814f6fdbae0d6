-- argument role: the role, or public: what everybody has
-- see grant
SELECT streetgen.grant('town', 'public', 'reader');
SELECT has_table_privilege('public', 'town.section', 'SELECT') AS reads;
SELECT streetgen.revoke('town', 'public');
SELECT has_table_privilege('public', 'town.section', 'SELECT') AS reads;
