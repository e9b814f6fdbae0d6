-- argument speed: km/h, 1 to 400
-- argument superelevation: banking of the curve, rise over run
-- argument friction: side friction; NULL: that of the norm
-- see horizontal_alignment
SELECT speed, round(streetgen.least_radius(speed)::numeric, 1) AS radius FROM unnest('{40, 60, 90, 120}'::float8[]) speed;
