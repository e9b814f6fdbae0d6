-- see estimated_width
SELECT streetgen.believed_width(10, 2, 5.5) AS ten, streetgen.believed_width(30, 2, 5.5) AS thirty;
