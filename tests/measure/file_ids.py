"""Which elements of two files at one place have another id: file_ids.py FORMAT BEFORE AFTER prints for each kind how many elements stand at the
same place in both, and how many of them have another id. FORMAT: opendrive, lanelet2, edges or nodes of sumo, symuvia, opensidewalks."""
import collections
import json
import sys
import xml.etree.ElementTree as ElementTree


def text(element, *names):
    return tuple(element.get(name) for name in names)


def opendrive(path):
    tree, road_at = ElementTree.parse(path), {}
    for road in tree.iter('road'):
        place = road_at[road.get('id')] = ElementTree.tostring(road.find('planView'))
        yield 'road' if road.get('junction') == '-1' else 'connecting road', place, road.get('id')
        for kind in ('signal', 'object'):
            for element in road.iter(kind):
                yield kind, (place,) + text(element, 's', 't', 'type', 'orientation'), element.get('id')
    for junction in tree.iter('junction'):
        yield 'junction', frozenset(road_at[c.get('connectingRoad')] for c in junction.iter('connection')), junction.get('id')
    signal_at = {s.get('id'): (road_at[road.get('id')],) + text(s, 's', 't') for road in tree.iter('road') for s in road.iter('signal')}
    for controller in tree.findall('controller'):
        yield 'controller', frozenset(signal_at[c.get('signalId')] for c in controller.iter('control')), controller.get('id')


def lanelet2(path):
    tree, place_of = ElementTree.parse(path), {}
    for node in tree.iter('node'):
        place_of[node.get('id')] = text(node, 'lat', 'lon')
        yield 'node', place_of[node.get('id')], node.get('id')
    for way in tree.iter('way'):
        place_of[way.get('id')] = tuple(place_of[n.get('ref')] for n in way.iter('nd'))
        yield 'way', place_of[way.get('id')], way.get('id')
    relations = list(tree.iter('relation'))
    for relation in relations:
        bounds = [m for m in relation.iter('member') if m.get('role') in ('left', 'right')]
        if bounds:
            place_of[relation.get('id')] = tuple(place_of[m.get('ref')] for m in bounds)
            yield 'lanelet', place_of[relation.get('id')], relation.get('id')
    for relation in relations:
        if relation.get('id') not in place_of:
            yield 'regulatory element', frozenset((m.get('role'), place_of[m.get('ref')]) for m in relation.iter('member')), relation.get('id')


def edges(path):
    for edge in ElementTree.parse(path).iter('edge'):
        yield 'edge', ElementTree.tostring(edge, 'unicode').replace(edge.get('id'), '', 1), edge.get('id')


def nodes(path):
    for node in ElementTree.parse(path).iter('node'):
        yield 'node', text(node, 'x', 'y'), node.get('id')


def symuvia(path):
    for troncon in ElementTree.parse(path).iter('TRONCON'):
        yield 'troncon', text(troncon, 'extremite_amont', 'extremite_aval', 'largeur_voie'), troncon.get('id')


def opensidewalks(path):
    for feature in json.load(open(path))['features']:
        yield feature['geometry']['type'], json.dumps(feature['geometry']), feature['properties']['_id']


def places(form, path):
    """The id at each place; none where several elements of a kind lie at one."""
    found = collections.defaultdict(list)
    for kind, place, name in globals()[form](path):
        found[kind, place].append(name)
    return {key: names[0] for key, names in found.items() if len(names) == 1}


def main():
    form, before, after = sys.argv[1], places(*sys.argv[1:3]), places(sys.argv[1], sys.argv[3])
    same = collections.Counter(kind for kind, place in before if (kind, place) in after)
    changed = collections.Counter(kind for (kind, place), name in before.items() if after.get((kind, place), name) != name)
    for kind in sorted(same):
        print(form, kind, same[kind], changed[kind], sep=' | ')


main()
