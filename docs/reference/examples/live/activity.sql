-- see generate, progress
SELECT who = current_user AS mine, holds, waits_for FROM streetgen.activity('town') WHERE pid = pg_backend_pid();
