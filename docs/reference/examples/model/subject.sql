-- see switch_subject, create_model
SELECT subject, wanted, needs, needed_by, tables FROM streetgen.subject('town');
