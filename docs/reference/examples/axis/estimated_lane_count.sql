-- see estimated_width, estimated_speed
SELECT width, streetgen.estimated_lane_count(width, 50, 3.5) FROM unnest(ARRAY[4, 7, 14]) width;
