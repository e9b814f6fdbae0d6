-- Each row that a file prints is a truth: its name, a tab, and t where it holds.
\pset format unaligned
\pset tuples_only on
\pset fieldsep '\t'
\set QUIET on
\ir statement.sql
SET client_min_messages = error;
