-- Every highway, aeroway, tram and light rail line of an OSM file, with the tags that speak of its street, its turn
-- restrictions, a row for each pair of ways, its signals, signs and crossings, what stands at
-- streets, routes, a row for each way, ways on which
-- people cross, areas of streets, and tags that are misspelt.  STREETGEN_PREFIX names the tables (PREFIX_line,
-- PREFIX_restriction, PREFIX_control, PREFIX_object, PREFIX_route, PREFIX_crossing_way, PREFIX_area, PREFIX_misspelt),
-- STREETGEN_SRID their projection.
local prefix = os.getenv('STREETGEN_PREFIX') or 'osm'
local srid = tonumber(os.getenv('STREETGEN_SRID') or '4326')

-- A tag speaks of the street where the first part of its key, or that after "source:", is one of these.
local street_keys = {}
for key in ([[lanes width est_width lane_markings oneway junction layer bridge tunnel maxheight maxspeed zone turn change
    placement overtaking access vehicle motor_vehicle motorcar motorcycle bus psv taxi tourist_bus coach hov carpool
    hgv goods bicycle foot trolley_bus minibus cycleway busway parking sidewalk shoulder centre_turn_lane
    bus_bay minor_lanes service motorroad dual_carriageway]]):gmatch('%S+') do
    street_keys[key] = true
end

-- What footways, cycle tracks and steps say beside that.
local walked = { footway = true, path = true, pedestrian = true, cycleway = true, steps = true, corridor = true }
local walk_keys = { 'footway', 'path', 'crossing', 'crossing:markings', 'indoor', 'location', 'level', 'incline',
                    'wheelchair', 'tactile_paving' }

-- Tags that say what is a track, and what tracks and streets with rails say beside that.
local tracked = { tram = true, light_rail = true }
local rail_keys = { 'gauge', 'tracks', 'indoor', 'location', 'level' }

-- Words that are a letter away from each other are alike with a letter taken out of either.
local function each_worn(word, take)
    take(word)
    for i = 1, #word > 4 and #word or 0 do
        take(word:sub(1, i - 1) .. word:sub(i + 1))
    end
end

local worn_keys = {}
for key in pairs(street_keys) do
    if #key >= 4 then
        each_worn(key, function(worn) worn_keys[worn] = true end)
    end
end

-- A word before others that people write without a mark between.
local function first_word(word)
    for _, last in ipairs({ 'lanes', 'lane', 'forward', 'backward', 'left', 'right', 'both' }) do
        local first = word:match('^(.-)' .. last .. '$')
        if street_keys[first] then
            return first
        end
    end
    return word:match('^%a*')
end

-- Does a key begin as one of a street does, or with a misspelt word, or list lanes?  The import names what it does not
-- know.
local speaks_of_street = setmetatable({}, { __index = function(known, key)
    local small = key:lower():gsub('^source:', '')
    local word = small:match('^[^:]*')
    local speaks = street_keys[word] or street_keys[first_word(word)] or (small .. ':'):find(':lanes:', 1, true)
        and true or false
    if #word >= 4 then
        each_worn(word, function(worn) speaks = speaks or worn_keys[worn] or false end)
    end
    known[key] = speaks
    return speaks
end })

local misspelt = osm2pgsql.define_table({ name = prefix .. '_misspelt', columns = {
    { column = 'node_id', type = 'bigint' }, -- one of these is the object's
    { column = 'way_id', type = 'bigint' },
    { column = 'relation_id', type = 'bigint' },
    { column = 'tag', type = 'text', not_null = true },
    { column = 'value', type = 'text', not_null = true },
    { column = 'meant', type = 'text', not_null = true }, -- the key or the word that is known
} })

-- What somebody means who wrote a word: one of these in another case, or with one letter more, less or swapped.
local function meant_by(word, words)
    local small = word:lower()
    local worn = {}
    for i = 1, #small > 3 and #small or 0 do
        worn[small:sub(1, i - 1) .. small:sub(i + 1)] = true
    end
    for _, known in ipairs(words) do
        if known == word then
            return nil
        end
    end
    for _, known in ipairs(words) do
        local near = known == small or #known > 2 and worn[known]
        if #known > 3 then
            each_worn(known, function(each) near = near or each == small or worn[each] end)
        end
        if near then
            return known
        end
    end
end

-- Tags of an object (node, way or relation) that nobody reads since a key, or a word of a key, is misspelt.
local function tell_misspelt(object, kind, known)
    for key, value in pairs(object.tags) do
        local words = known.words[key]
        local meant = meant_by(words and value or key, words or known.keys)
        if meant and (words or not object.tags[meant]) then
            misspelt:insert({ [kind .. '_id'] = object.id, tag = key, value = value, meant = meant })
        end
    end
end

-- The words of each key that are looked for.
local function known_tags(words)
    local keys = {}
    for key in pairs(words) do
        keys[#keys + 1] = key
    end
    table.sort(keys)
    return { keys = keys, words = words }
end

local line = osm2pgsql.define_way_table(prefix .. '_line', {
    { column = 'class', type = 'text', not_null = true },
    { column = 'name', type = 'text' },
    { column = 'ref', type = 'text' },
    { column = 'tags', type = 'jsonb', not_null = true },
    { column = 'nodes', type = 'integer' }, -- of which the file may lack some: then the line has fewer vertices
    { column = 'geom', type = 'linestring', projection = srid },
})

local function node_count(object)
    local count = 0
    for i, node in ipairs(object.nodes) do
        if node ~= object.nodes[i - 1] then
            count = count + 1
        end
    end
    return count
end

local crossing_way = osm2pgsql.define_way_table(prefix .. '_crossing_way', {
    { column = 'crossing', type = 'text' },
    { column = 'markings', type = 'text' },
    { column = 'geom', type = 'linestring', projection = srid, not_null = true },
})

-- A way on which people cross a street says how it is painted there.
local function insert_crossing_way(object)
    local tags = object.tags
    if (tags.footway == 'crossing' or tags.path == 'crossing' or tags.cycleway == 'crossing') and
        (tags.crossing or tags['crossing:markings']) then
        crossing_way:insert({ crossing = tags.crossing, markings = tags['crossing:markings'],
                              geom = object:as_linestring() })
    end
end

local area = osm2pgsql.define_table({ name = prefix .. '_area', columns = {
    { column = 'way_id', type = 'bigint' }, -- one of these is the area's
    { column = 'relation_id', type = 'bigint' },
    { column = 'name', type = 'text' },
    { column = 'tags', type = 'jsonb', not_null = true },
    { column = 'geom', type = 'geometry', projection = srid }, -- of a way its closed line, which may cross itself
} })

local area_keys = { 'area:highway', 'highway', 'place', 'amenity', 'public_transport', 'railway', 'parking', 'footway',
                    'indoor', 'location', 'level', 'layer', 'bridge', 'tunnel', 'surface', 'foot', 'access' }

-- Is what goes round an area one of streets?  Lines of other highways go round a block as well.
local function is_area_of_street(tags, round)
    return tags['area:highway'] or tags.place == 'square' or tags.amenity == 'parking' or
        tags.area ~= 'no' and (tags.highway == 'platform' or tags.railway == 'platform' or
                               tags.public_transport == 'platform') or
        tags.highway and (tags.area == 'yes' or not round)
end

local function insert_area(object, id, geom)
    local tags = {}
    for _, key in ipairs(area_keys) do
        tags[key] = object.tags[key]
    end
    area:insert({ [id] = object.id, name = object.tags.name, tags = tags, geom = geom })
end

local standing = osm2pgsql.define_table({ name = prefix .. '_object', columns = {
    { column = 'class', type = 'text', not_null = true },
    { column = 'direction', type = 'text' },
    { column = 'geom', type = 'point', projection = srid, not_null = true },
}, ids = { type = 'any', id_column = 'node_id' } }) -- of a way less than 0

local standing_classes = { crossing = true, street_lamp = true, bus_stop = true, traffic_signals = true,
                           stop = true, give_way = true, tree = true, bench = true, bollard = true, tram_stop = true }

-- Platforms on which people wait for trams; that of buses is a bus stop.
local function is_tram_platform(tags)
    return tags.railway == 'platform' or
        tags.public_transport == 'platform' and (tags.tram == 'yes' or tags.light_rail == 'yes')
end

-- Types of what slows traffic, by the value of traffic_calming.
local calming_classes = { bump = 'speed_bump', mini_bumps = 'speed_bump', hump = 'speed_hump', table = 'speed_table',
                          cushion = 'speed_cushion', rumble_strip = 'rumble_strip', choker = 'choker',
                          chicane = 'chicane', island = 'traffic_island' }

-- The word of one of the keys for what stands at a place, or what slows traffic there.
local function standing_class(tags)
    for _, key in ipairs({ 'highway', 'natural', 'amenity', 'barrier', 'railway' }) do
        if standing_classes[tags[key]] then
            return tags[key]
        end
    end
    return is_tram_platform(tags) and 'platform' or calming_classes[tags.traffic_calming]
end

local known_of_way = known_tags({ highway = {}, aeroway = {}, railway = { 'tram', 'light_rail' } })

function osm2pgsql.process_way(object)
    if object.is_closed and is_area_of_street(object.tags, true) then
        insert_area(object, 'way_id', object:as_linestring())
    elseif not object.is_closed and is_tram_platform(object.tags) then
        standing:insert({ class = 'platform', geom = object:as_linestring():centroid() })
    end
    local track = tracked[object.tags.railway] and object.tags.railway
    local class = object.tags.highway or object.tags.aeroway or track
    if not class then
        tell_misspelt(object, 'way', known_of_way)
    end
    if not class then
        return
    end
    insert_crossing_way(object)
    local tags = { area = object.tags.area }
    for key, value in pairs(object.tags) do
        if speaks_of_street[key] then
            tags[key] = value
        end
    end
    for _, key in ipairs(walked[class] and walk_keys or {}) do
        tags[key] = object.tags[key]
    end
    tags.surface = object.tags.surface
    tags.railway = class ~= track and track or nil
    tags.embedded_rails = tracked[object.tags.embedded_rails] and object.tags.embedded_rails or nil
    for _, key in ipairs((track or tags.embedded_rails) and rail_keys or {}) do
        tags[key] = object.tags[key]
    end
    line:insert({ class = class, name = object.tags.name, ref = object.tags.ref, tags = tags,
                  nodes = node_count(object), geom = object:as_linestring() })
end

local control = osm2pgsql.define_node_table(prefix .. '_control', {
    { column = 'class', type = 'text', not_null = true },
    { column = 'direction', type = 'text' },
    { column = 'traffic_signals_direction', type = 'text' },
    { column = 'stop', type = 'text' }, -- of a stop or give-way on a junction: the arms that it binds
    { column = 'lights', type = 'boolean' }, -- a crossing with lights, or signals with a crossing
    { column = 'crossing', type = 'text' },
    { column = 'markings', type = 'text' }, -- of the crossing
    { column = 'kerb', type = 'text' }, -- at both of its ends; of class kerb: where a footway comes over it
    { column = 'kerb_height', type = 'text' },
    { column = 'island', type = 'text' }, -- in the middle of the crossing
    { column = 'geom', type = 'point', projection = srid, not_null = true },
})

local controls = { traffic_signals = true, stop = true, give_way = true, mini_roundabout = true, crossing = true,
                   turning_circle = true, turning_loop = true, passing_place = true }

-- A place of which somebody says that nobody crosses there.
local function no_crossing(tags)
    return tags.highway == 'crossing' and tags.crossing == 'no'
end

local function has_lights(tags)
    return (tags.highway == 'crossing' or tags.highway == 'traffic_signals') and
        (tags.crossing == 'traffic_signals' or tags['crossing:signals'] == 'yes')
end

local known_of_node = known_tags({
    highway = { 'traffic_signals', 'stop', 'give_way', 'mini_roundabout', 'crossing', 'turning_circle', 'turning_loop',
                'passing_place', 'street_lamp', 'bus_stop' },
    natural = { 'tree' }, amenity = { 'bench' }, barrier = { 'bollard', 'kerb' }, railway = { 'tram_stop' },
    traffic_calming = { 'bump', 'hump', 'table', 'cushion', 'rumble_strip', 'choker', 'chicane', 'island' },
    crossing = { 'traffic_signals', 'uncontrolled', 'unmarked', 'zebra' }, ['crossing:signals'] = { 'yes' },
    ['crossing:markings'] = { 'zebra', 'ladder', 'lines', 'dashes', 'dots', 'surface' },
    direction = { 'forward', 'backward', 'both' }, stop = { 'minor', 'all' }, ['traffic_signals:direction'] = { 'forward', 'backward', 'both' },
})

function osm2pgsql.process_node(object)
    tell_misspelt(object, 'node', known_of_node)
    if no_crossing(object.tags) then
        return
    end
    local class = standing_class(object.tags)
    if class then
        standing:insert({ class = class, direction = object.tags.direction, geom = object:as_point() })
    end
    if controls[object.tags.highway] then
        control:insert({ class = object.tags.highway, direction = object.tags.direction,
                         traffic_signals_direction = object.tags['traffic_signals:direction'],
                         stop = object.tags.stop or object.tags.give_way, lights = has_lights(object.tags),
                         crossing = object.tags.crossing, markings = object.tags['crossing:markings'],
                         kerb = object.tags.kerb, kerb_height = object.tags['kerb:height'],
                         island = object.tags['crossing:island'] or object.tags.crossing == 'island' and 'yes' or nil,
                         geom = object:as_point() })
    elseif object.tags.barrier == 'kerb' or object.tags.kerb then
        control:insert({ class = 'kerb', kerb = object.tags.kerb, kerb_height = object.tags['kerb:height'],
                         geom = object:as_point() })
    end
end

local restriction = osm2pgsql.define_relation_table(prefix .. '_restriction', {
    { column = 'restriction', type = 'text' },
    { column = 'excepted', type = 'text' }, -- traffic that it does not hold for
    -- The traffic that alone it holds for, and that of further keys, parted by commas; conditional, hours: times;
    -- empty: all.
    { column = 'held_for', type = 'text' },
    { column = 'from_way', type = 'bigint' },
    { column = 'to_way', type = 'bigint' },
    { column = 'via_ways', type = 'text' }, -- in their order, parted by commas
    { column = 'geom', type = 'geometry', projection = srid }, -- of all members; points: via nodes
})

local route = osm2pgsql.define_relation_table(prefix .. '_route', {
    { column = 'kind', type = 'text', not_null = true },
    { column = 'ref', type = 'text' },
    { column = 'name', type = 'text' },
    { column = 'ordinality', type = 'integer' }, -- of the way among the members
    { column = 'role', type = 'text' },
    { column = 'way_id', type = 'bigint' },
})

local route_kinds = { bus = 'bus', trolleybus = 'bus', tram = 'tram', bicycle = 'bicycle', truck = 'truck', hgv = 'truck' }

-- A row for each way of a route of buses, trams, bicycles or trucks, but for those of stops; where route has several
-- values, parted by ;, for each kind.
local function insert_route(object)
    local kinds = {}
    for word in (object.tags.type == 'route' and object.tags.route or ''):gmatch('[^;%s]+') do
        kinds[route_kinds[word] or word] = route_kinds[word]
    end
    for i, member in ipairs(object.members) do
        if member.type == 'w' and not member.role:find('^platform') and not member.role:find('^stop') then
            for _, kind in pairs(kinds) do
                route:insert({ kind = kind, ref = object.tags.ref, name = object.tags.name, ordinality = i,
                               role = member.role, way_id = member.ref })
            end
        end
    end
end

-- Whom a turn restriction holds for, by its type, keys such as restriction:hgv, or tags of its times.
local function held_for(tags)
    local traffic = {}
    for key in pairs(tags) do
        traffic[#traffic + 1] = key:match('^restriction:(.*)$')
    end
    table.sort(traffic)
    local by_type = tags.type:match('^restriction:(.*)$')
    if by_type then
        table.insert(traffic, 1, by_type)
    elseif tags.restriction then
        local at_hours = tags.day_on or tags.day_off or tags.hour_on or tags.hour_off
        table.insert(traffic, 1, at_hours and 'hours' or '')
    end
    return table.concat(traffic, ',')
end

local known_of_relation = known_tags({
    type = { 'restriction', 'route', 'multipolygon' }, route = { 'bus', 'trolleybus', 'tram', 'bicycle', 'truck', 'hgv' },
    restriction = {}, except = { 'psv', 'bus', 'bicycle', 'hov' },
})

function osm2pgsql.process_relation(object)
    tell_misspelt(object, 'relation', known_of_relation)
    insert_route(object)
    if object.tags.type == 'multipolygon' and is_area_of_street(object.tags, false) then
        insert_area(object, 'relation_id', object:as_multipolygon())
    end
    if not (object.tags.type or ''):match('^restriction%f[:\0]') then
        return
    end
    local limits = held_for(object.tags)
    local from, to, via = {}, {}, {}
    for _, member in ipairs(object.members) do
        if member.type == 'w' and member.role == 'from' then
            from[#from + 1] = member.ref
        elseif member.type == 'w' and member.role == 'to' then
            to[#to + 1] = member.ref
        elseif member.type == 'w' and member.role == 'via' then
            via[#via + 1] = member.ref
        end
    end
    local geom = object:as_geometrycollection()
    -- One that lacks a way, or whose way the file cuts off, has a row too: the import reports it.
    for i = 1, math.max(#from, 1) do
        for j = 1, math.max(#to, 1) do
            restriction:insert({ restriction = object.tags.restriction, excepted = object.tags.except,
                                 held_for = limits, from_way = from[i], to_way = to[j], geom = geom,
                                 via_ways = #via > 0 and table.concat(via, ',') or nil })
        end
    end
end
