-- argument class_width: width of the class, metres; NULL: unknown
-- argument width_default: width of an axis of which nothing is known, metres
-- see believed_width, estimated_lane_count
SELECT streetgen.estimated_width(2, 9, 3.5, 6) AS by_lanes, streetgen.estimated_width(NULL, 9, 3.5, 6) AS by_class, streetgen.estimated_width(NULL, NULL, 3.5, 6) AS by_default;
