-- A subject switched off with all that need it, and these switched on again: in the set-up owner a model has more than a file asks for.

-- What needed it, the last first.
CREATE FUNCTION test.switch_off(model name, off text) RETURNS text[] LANGUAGE plpgsql AS $$
DECLARE
  needing text;
  went text[] := '{}';
BEGIN
  FOR needing IN
    WITH RECURSIVE above(subject) AS (SELECT unnest(needed_by) FROM streetgen.subject(model) WHERE subject = off
      UNION SELECT unnest(s.needed_by) FROM above a JOIN streetgen.subject(model) s USING (subject))
    SELECT s.subject FROM (SELECT row_number() OVER () AS place, * FROM streetgen.subject(model)) s JOIN above USING (subject) WHERE s.wanted ORDER BY s.place DESC
  LOOP
    PERFORM streetgen.switch_subject(model, needing, false);
    went := went || needing;
  END LOOP;
  PERFORM streetgen.switch_subject(model, off, false);
  RETURN went;
END $$;

CREATE FUNCTION test.switch_on(model name, subjects text[]) RETURNS void LANGUAGE plpgsql AS $$
BEGIN
  FOR i IN REVERSE cardinality(subjects) .. 1 LOOP
    PERFORM streetgen.switch_subject(model, subjects[i], true);
  END LOOP;
END $$;
