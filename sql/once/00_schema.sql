-- The extension's own schema and the registry of models.
CREATE SCHEMA streetgen;
COMMENT ON SCHEMA streetgen IS 'StreetGen: road axes in, a complete model of the streets out';
GRANT USAGE ON SCHEMA streetgen TO PUBLIC;

CREATE TABLE streetgen._model (
  name name PRIMARY KEY,
  srid integer NOT NULL,
  dimension integer NOT NULL CHECK (dimension IN (2, 3)),
  template_version text NOT NULL
);
COMMENT ON TABLE streetgen._model IS 'registry behind the view streetgen.model; written by _register_model and _forget_model only';
COMMENT ON COLUMN streetgen._model.name IS 'the model and its schema';
COMMENT ON COLUMN streetgen._model.srid IS 'reference system of every geometry of the model';
COMMENT ON COLUMN streetgen._model.dimension IS '2, or 3 where axes, nodes, edges and limits carry Z';
COMMENT ON COLUMN streetgen._model.template_version IS 'version of the extension whose tables the model has';
SELECT pg_catalog.pg_extension_config_dump('streetgen._model', '');

-- A schema dropped by hand is no model any more, without a trigger on every DROP of the database.
CREATE VIEW streetgen.model AS
  SELECT m.name, m.srid, m.dimension, m.template_version
  FROM streetgen._model m
  JOIN pg_catalog.pg_namespace n ON n.nspname = m.name
  WHERE EXISTS (SELECT FROM pg_catalog.pg_class c WHERE c.relnamespace = n.oid AND c.relname = 'axis')
    AND EXISTS (SELECT FROM pg_catalog.pg_class c WHERE c.relnamespace = n.oid AND c.relname = 'setting');
COMMENT ON VIEW streetgen.model IS 'the models of this database: name, SRID, dimension and template version';
COMMENT ON COLUMN streetgen.model.name IS 'the model and its schema';
COMMENT ON COLUMN streetgen.model.srid IS 'reference system of every geometry of the model';
COMMENT ON COLUMN streetgen.model.dimension IS '2, or 3 where axes, nodes, edges and limits carry Z';
COMMENT ON COLUMN streetgen.model.template_version IS 'version of the extension whose tables the model has';
GRANT SELECT ON streetgen.model TO PUBLIC;
