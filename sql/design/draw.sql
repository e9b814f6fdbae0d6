-- Designs and their profiles are drawn by these rules.

INSERT INTO streetgen.symbol_rule (theme, layer, place, fill) VALUES
    ('construction', 'hill_shade', 0, '#1a1812');
INSERT INTO streetgen.symbol_rule (theme, layer, kind, place, fill) VALUES
    ('construction', 'zone', 'bridge', 1, '#93c5fd'),
    ('construction', 'zone', 'free', 2, '#86a97c'),
    ('construction', 'zone', 'forbidden', 3, '#7c2d12'),
    ('construction', 'profile', 'ground', 1, '#d6c7a1'),
    ('construction', 'profile', 'bridge', 2, '#dc262640'),
    ('construction', 'profile', 'tunnel', 2, '#1f293740');
INSERT INTO streetgen.symbol_rule (theme, layer, place, line, width, unit, dash) VALUES
    ('construction', 'design_link', 4, '#6b7280', 1.2, 'pixel', '5 3');
INSERT INTO streetgen.symbol_rule (theme, layer, place, line, width, unit) VALUES
    ('construction', 'straight_alignment', 5, '#111827', 1.4, 'pixel'),
    ('construction', 'design_alignment', 6, '#1d4ed8', 2, 'pixel'),
    ('construction', 'structure', 7, '#dc2626', 5, 'pixel'),
    ('construction', 'design_axis', 8, '#f97316', 2.4, 'pixel');
INSERT INTO streetgen.symbol_rule (theme, layer, kind, place, line, width, unit) VALUES
    ('construction', 'profile', 'road', 3, '#1d4ed8', 2, 'pixel');
INSERT INTO streetgen.symbol_rule (theme, layer, place, fill, line, width, unit) VALUES
    ('construction', 'design_node', 9, '#facc15', '#111827', 1, 'pixel'),
    ('construction', 'design_name', 10, '#111827', '#ffffff', 3, 'pixel');
INSERT INTO streetgen.symbol_rule (theme, layer, kind, place, fill, line, width, unit) VALUES
    ('construction', 'design_node', 'interchange', 9, '#9ca3af', '#111827', 1, 'pixel');
