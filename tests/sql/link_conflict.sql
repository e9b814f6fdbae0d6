\set ECHO none
\ir shared/truths.sql
-- Two roads that cross at a right angle, and one more movement of another junction.
CREATE FUNCTION pg_temp.conflicts(ranks integer[], protected_states bigint[] DEFAULT '{0,0,0}',
    x float8[] DEFAULT '{-15,0,0}') RETURNS TABLE(first integer, second integer, kind text, precedence text,
    first_from float8, first_to float8, second_from float8, second_to float8)
    LANGUAGE sql AS $$ SELECT * FROM streetgen._link_conflicts('{1,1,2}', '{1,2,3}', '{4,5,6}', '{t,t,t}', '{t,t,t}',
        '{30,30,30}', '{3,3,3}', '{0,0,0}', ranks, '{0,0,0}', '{0,0,0}', protected_states, '{0,0,0}', '{1,1,1}',
        '{0,0,0}', x, '{0,-15,-15}', ARRAY[0, pi() / 2, pi() / 2], '{0,0,0}', false) $$;
SELECT 'two movements cross, who comes from the right first', count(*) = 1
    AND bool_and((first, second, kind, precedence) = (1, 2, 'crossing', 'gives_way')
        AND first_from BETWEEN 13.5 AND 14.1 AND first_to BETWEEN 20.9 AND 21.5)
FROM pg_temp.conflicts('{0,0,0}');
SELECT 'a rank decides before', bool_and(precedence = 'goes_first') FROM pg_temp.conflicts('{0,1,0}');
SELECT 'a signal decides before', bool_and(precedence = 'by_signal') FROM pg_temp.conflicts('{0,1,0}', '{1,2,0}');
SELECT 'no movements have no conflict', NOT EXISTS (SELECT FROM streetgen._link_conflicts('{}', '{}', '{}', '{}', '{}',
    '{}', '{}', '{}', '{}', '{}', '{}', '{}', '{}', '{}', '{}', '{}', '{}', '{}', '{}', false));
SELECT 'a place that is no number is refused',
    test.state($$SELECT pg_temp.conflicts('{0,0,0}', x => '{0,NaN,0}')$$) = '22023';
SELECT 'lists of different length are refused', test.state($$SELECT pg_temp.conflicts('{0,0}')$$) = '2202E';
