-- The schema of the extension, and the list of models in it.

-- Bodies name PostGIS, whose schema the last file of the script pins.
SET LOCAL check_function_bodies = off;

CREATE SCHEMA streetgen;
COMMENT ON SCHEMA streetgen IS
    'StreetGen: road axes in, streets out. Models live in schemas of their owners. A function that gets NULL for an '
    'argument without a default raises 22004 and names the argument, unless its comment says what NULL means.';

CREATE TABLE streetgen.model (
    name name PRIMARY KEY,
    srid integer NOT NULL,
    dimension integer NOT NULL CHECK (dimension IN (2, 3)),
    template_version text NOT NULL,
    build text
);
COMMENT ON TABLE streetgen.model IS
    'The models of this database, one schema each. Written by create_model, adopt_model and drop_model.';
COMMENT ON COLUMN streetgen.model.name IS 'schema of the model';
COMMENT ON COLUMN streetgen.model.srid IS 'projected spatial reference, in metres';
COMMENT ON COLUMN streetgen.model.dimension IS '2, or 3 where axes, nodes, edges and limits carry Z';
COMMENT ON COLUMN streetgen.model.template_version IS 'version of the extension that made the tables';
COMMENT ON COLUMN streetgen.model.build IS
    'build of the extension that made its functions, views and triggers; another one, or NULL: a dump brought it';
SELECT pg_catalog.pg_extension_config_dump('streetgen.model', '');
GRANT USAGE ON SCHEMA streetgen TO PUBLIC;
GRANT SELECT ON streetgen.model TO PUBLIC;
