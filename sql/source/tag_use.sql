-- What becomes of each tag and column that importers of known sources look at.

CREATE OR REPLACE FUNCTION streetgen.tag_use() RETURNS TABLE(source text, tag text, becomes text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 100 SET search_path = pg_catalog
    AS $$
    SELECT 'OpenStreetMap, lanes', u.* FROM streetgen._osm_tag_use() u
    UNION ALL VALUES
    ('OpenStreetMap, ways', 'width:carriageway, width, est_width',
        'The width of the roadway from kerb to kerb: the first of them that is a length.'),
    ('OpenStreetMap, ways', 'maxspeed[|:forward|:backward|:lanes], zone:maxspeed, source:maxspeed', 'The speed.'),
    ('OpenStreetMap, ways', 'layer', 'The level; without it a bridge is on level 1 and a tunnel on level -1.'),
    ('OpenStreetMap, ways', 'bridge', 'Level 1 where layer says none.'),
    ('OpenStreetMap, ways', 'tunnel', 'Level -1 where layer says none.'),
    ('OpenStreetMap, ways', 'name', 'The name of the street.'),
    ('OpenStreetMap, ways', 'ref', 'The number of the route.'),
    ('OpenStreetMap, ways', 'area', 'A way with value yes is no street.'),
    ('OpenStreetMap, ways', 'aeroway', 'The class, where there is no highway.'),
    ('OpenStreetMap, ways', 'sidewalk[|:left|:right|:both]', 'Whether there are sidewalks.'),
    ('OpenStreetMap, ways', 'sidewalk[:left|:right|:both]:width', 'The widths of the sidewalks.'),
    ('BD TOPO', 'largeur_de_chaussee, largeur', 'The width of the roadway from kerb to kerb.'),
    ('BD TOPO', 'nombre_de_voies, nb_voies', 'The number of general and bus lanes.'),
    ('BD TOPO', 'sens_de_circulation, sens', 'The direction of the traffic.'),
    ('BD TOPO', 'reserve_aux_bus, bus', 'A bus lane of the direction that it names; else of that of the traffic.'),
    ('BD TOPO', 'bande_cyclable, cyclable', 'A cycle lane of the direction that it names.'),
    ('BD TOPO', 'amenagement_cyclable_droit, amenagement_cyclable_gauche',
        'Bande cyclable is a cycle lane at this kerb; what else it says is no lane of the roadway.'),
    ('BD TOPO', 'sens_amenagement_cyclable_droit, sens_amenagement_cyclable_gauche',
        'The direction of that cycle lane; else that of its kerb.'),
    ('BD TOPO', 'vitesse_moyenne_vl, vit_moy_vl', 'The speed.'),
    ('BD TOPO', 'importance', 'The importance.'),
    ('BD TOPO', 'position_par_rapport_au_sol, pos_sol', 'The level.'),
    ('BD TOPO', 'nature', 'The class; Rond-point is a roundabout.'),
    ('BD TOPO', 'nom_voie_ban_gauche, nom_collaboratif_gauche, nom_1_gauche, nom_coll_g, nom_1_g, nom_rue_g, '
        'nom_voie_g', 'The name of the street.'),
    ('BD TOPO', 'cpx_numero, numero', 'The number of the route.'),
    ('BD TOPO', 'fictif', 'A fictitious axis is no street.'),
    ('BD TOPO', 'cleabs, id, ogc_fid, gid, fid', 'The identity in the source.') $$;
COMMENT ON FUNCTION streetgen.tag_use() IS
    'What becomes of each tag of OpenStreetMap and each column of BD TOPO that importers look at; alternatives of a '
    'key stand in brackets.';
