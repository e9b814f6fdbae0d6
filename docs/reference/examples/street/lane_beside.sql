-- see subject
SELECT * FROM streetgen.lane_beside('town', (SELECT min(lane_id) FROM town.lane), 10, 'right');
