-- argument axes: axis_id of those to compute; NULL: all
-- argument wait: waits for rows and places that other sessions hold, instead of failing or skipping
-- see live, plan_clusters, check_model
SELECT streetgen.live('town', false);
UPDATE town.axis SET width = 8 WHERE name = 'mill lane';
SELECT relation, inserted, updated, deleted, unchanged FROM streetgen.generate('town') WHERE updated > 0;
