-- A roadway of 6 m may lie 3 m beside its axis.
SELECT streetgen.believed_roadway_offset(2, 6, 8) AS two, streetgen.believed_roadway_offset(-5, 6, 8) AS five;
