"""Drives that CARLA's reader ended on roads that lead on: carla.py FILE DEAD reads what the reader says of FILE, and prints how many drives ended early, how
many of these elsewhere than at dead ends, the ids of the roads where they ended, and how many corners the outlines of crosswalks have. DEAD lists the edges of
the model with a lane from which nothing leads on."""
import sys
import xml.etree.ElementTree as ElementTree

STEP = 1.0  # metres from one look of the reader to the next


class Network:
    def __init__(self, tree, dead):
        self.dead, self.roads, self.ways = dead, {road.get('id'): road for road in tree.iter('road')}, {}
        for road in self.roads.values():
            if road.get('junction') != '-1':
                self.ways.setdefault(road.find('link/predecessor').get('elementId'), []).append(road)

    def is_dead(self, road):
        edge = road.find("userData[@code='edge']")
        return edge is not None and edge.get('value') in self.dead

    def ahead(self, road):
        """The roads to which a road leads."""
        if road.get('junction') != '-1':
            return [self.roads[road.find('link/successor').get('elementId')]]
        joined = [self.roads[e.get('elementId')] for e in road.findall('link/*') if e.get('elementType') == 'road']
        return self.ways.get(road.get('id'), []) + joined

    def ends(self, road, metres=STEP):
        """Whether a dead end lies less than so many metres behind the end of a road."""
        return self.is_dead(road) or any(
            self.ends(other, metres - float(other.get('length'))) for other in self.ahead(road) if float(other.get('length')) < metres)


def main():
    tree = ElementTree.parse(sys.argv[1])
    network = Network(tree, set(open(sys.argv[2]).read().split()))
    early, elsewhere = 0, {}
    for line in sys.stdin:
        if line.startswith('ended_on_road '):
            _, name, count = line.split()
            early += int(count)
            if not network.ends(network.roads[name]):
                elsewhere[name] = int(count)
    corners = tree.findall(".//object[@type='crosswalk']/outlines/outline/cornerLocal")
    print(early, sum(elsewhere.values()), ','.join(elsewhere) or '-', len(corners))


main()
