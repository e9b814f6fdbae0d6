-- Countries where one drives on the left, for models whose one-way streets tell nothing.

CREATE OR REPLACE FUNCTION streetgen._left_hand_country(place geometry) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    -- Degrees of longitude and latitude. Boxes keep clear of countries that drive on the right, so that some land along
    -- borders lies in none.
    SELECT country FROM (VALUES
        ('Britain or Ireland', -8.7, 49.8, 0.1, 61), ('Britain', 0.1, 50.6, 1.3, 61),
        ('Britain', 1.3, 51.1, 1.8, 53.5),
        ('Jersey and Guernsey', -2.75, 49.1, -1.98, 49.78), ('Ireland', -11, 51.3, -5.3, 55.5),
        ('Malta', 14.1, 35.7, 14.7, 36.1), ('Cyprus', 32.2, 34.5, 34.7, 35.8),
        ('Japan', 129.55, 30, 137, 37.2), ('Japan', 136, 37.2, 142.5, 41.6), ('Japan', 139.3, 41.3, 145.2, 45.55),
        ('Japan', 145.2, 42.9, 145.8, 43.35),
        ('Japan', 122.9, 24, 131.5, 30), ('Hong Kong', 113.83, 22.15, 114.45, 22.4),
        ('Hong Kong', 114, 22.4, 114.2, 22.5),
        ('Macau', 113.547, 22.11, 113.6, 22.21),
        ('Thailand', 99.3, 13, 100.9, 14.5), ('Thailand', 98.9, 14.5, 100.9, 19),
        ('Thailand', 100.9, 13.6, 102.3, 17.3),
        ('Thailand', 102.3, 14.6, 104.5, 16.2), ('Thailand', 98.9, 9.5, 100.2, 10.6),
        ('Thailand', 98, 7, 102, 9.5), ('Thailand or Malaysia', 98, 4.5, 104.8, 7),
        ('Malaysia or Singapore', 100, 1.15, 104.7, 4.5),
        ('Borneo', 108.5, 0, 118, 7.2), ('Borneo', 118, 0, 119.2, 5.95), ('Indonesia', 94.9, -11.2, 141, 4.6),
        ('Papua New Guinea', 140.8, -11.7, 155, -1), ('Solomon Islands', 155, -12.5, 168, -6.5),
        ('Australia', 110, -45, 155, -9), ('New Zealand', 165.5, -48, 180, -33.5), ('Fiji', 176.8, -19.3, 180, -16),
        ('Tonga', -176.3, -22, -173.6, -15.4), ('Samoa', -172.9, -14.1, -171.3, -13.4),
        ('India', 68.1, 7.9, 88, 23.5), ('Sri Lanka', 79.4, 5.8, 82, 10), ('India', 70, 23.5, 88, 27),
        ('Maldives', 72.5, -0.8, 73.9, 7.2), ('Pakistan', 66.7, 24.7, 67.2, 30.4),
        ('Pakistan or India', 67.2, 23.5, 80, 30.3),
        ('Nepal', 81.8, 27, 85, 28.3), ('Nepal', 85, 26.4, 87.8, 27.7),
        ('Pakistan or India', 71.3, 30.3, 78.5, 34.2), ('Bangladesh or India', 88, 21.5, 92.1, 26.6),
        ('India', 92.1, 24.1, 94, 26.9), ('Southern Africa', 11.6, -35, 41, -18),
        ('Zambia, Malawi or Mozambique', 24.1, -18, 41, -13.6), ('Tanzania, Malawi or Mozambique', 33, -13.6, 41, -8.4),
        ('Tanzania or Kenya', 30.9, -8.4, 40.9, -1), ('Kenya', 34, -1, 40.9, 3.4), ('Uganda', 31.4, -1, 35, 3.4),
        ('Uganda', 30.3, -0.9, 31.4, 1), ('Mauritius', 57.2, -20.6, 57.9, -19.9), ('Seychelles', 55, -5, 56.1, -4),
        ('Jamaica', -78.5, 17.6, -76.1, 18.6), ('Bahamas', -79.3, 23.4, -74, 27.3),
        ('Bahamas', -74.5, 20.85, -71, 23.4), ('Cayman Islands', -81.5, 19.2, -79.7, 19.8),
        ('Virgin Islands', -65.1, 17.65, -64.2, 18.8), ('Anguilla', -63.2, 18.15, -62.95, 18.3),
        ('Saint Kitts and Nevis', -62.9, 17.05, -62.5, 17.45), ('Antigua and Barbuda', -62, 16.95, -61.65, 17.75),
        ('Montserrat', -62.25, 16.65, -62.1, 16.85), ('Dominica', -61.5, 15.2, -61.2, 15.65),
        ('Saint Lucia', -61.1, 13.7, -60.85, 14.15), ('Saint Vincent', -61.5, 12.5, -61.1, 13.4),
        ('Grenada', -61.85, 11.95, -61.35, 12.3), ('Barbados', -59.7, 13, -59.4, 13.4),
        ('Trinidad and Tobago', -61.8, 10, -60.5, 11.4), ('Guyana or Suriname', -59.7, 4.6, -54.6, 7.2),
        ('Bermuda', -64.95, 32.2, -64.6, 32.45), ('Falkland Islands', -61.5, -52.5, -57.6, -51)
        ) c(country, west, south, east, north)
    WHERE ST_X(place) BETWEEN west AND east AND ST_Y(place) BETWEEN south AND north LIMIT 1
    $$;
COMMENT ON FUNCTION streetgen._left_hand_country(geometry) IS
    'The country about a POINT in longitude and latitude where one drives on the left; NULL: on the right, or unknown.';

CREATE OR REPLACE FUNCTION streetgen._left_hand_country_of(model name) RETURNS text
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN streetgen._left_hand_country(ST_Transform(ST_StartPoint(ST_Force2D(geom)), 4326))
        FROM axis WHERE streetgen._outside(ST_StartPoint(ST_Force2D(geom))) = 0 ORDER BY axis_id LIMIT 1;
EXCEPTION WHEN internal_error THEN
    -- No country is known where the projection is not defined.
    RETURN NULL;
END $$;
COMMENT ON FUNCTION streetgen._left_hand_country_of(name) IS
    'The country of a model where one drives on the left, by its first axis; NULL: on the right, or unknown.';
