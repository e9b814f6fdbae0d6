-- argument subject: the subject, one of [subject](#subject)
-- argument wanted: whether the model computes the subject from now on
-- see subject, create_model
SELECT * FROM streetgen.switch_subject('town', 'interconnection', false);
SELECT subject, wanted FROM streetgen.subject('town');
SELECT relation, inserted, unchanged FROM streetgen.switch_subject('town', 'interconnection', true);
