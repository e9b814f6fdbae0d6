-- see import_axes, import_osm
CREATE TABLE troncon_de_route (cleabs text, nature text, nom_voie_ban_gauche text, importance text, fictif boolean, largeur_de_chaussee numeric(5, 1),
    nombre_de_voies integer, position_par_rapport_au_sol text, sens_de_circulation text, vitesse_moyenne_vl integer, geometrie geometry(LineString, 2154));
INSERT INTO troncon_de_route VALUES ('TRONROUT17', 'Route à 1 chaussée', 'Rue Haute', '4', false, 5.5, 2, '0', 'Sens inverse', 30,
    'SRID=2154;LINESTRING(650000 6860000, 650000 6860090)');
SELECT what, class, count FROM streetgen.import_bdtopo('town', 'troncon_de_route');
SELECT name, width, lane_count, direction, speed, importance FROM town.axis WHERE source_ref = 'TRONROUT17';
