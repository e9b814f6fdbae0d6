"""Who gives way to whom at the junctions of a network of SUMO, where what netconvert wrote lets two go at once, or none.

netconvert takes lanes that end where a street of the same width has fewer lanes for one, and lets all of them go on into one lane without looking. Two lanes on both
sides of one that goes elsewhere yield to each other. A signal of a program shows G to who goes without looking: who yields to somebody with green at the same time gets g.
"""
import collections
import re
import sys


def value(line, attribute):
    """The value of an attribute of an element that stands on one line, or None."""
    found = re.search(f' {attribute}="([^"]*)"', line)
    return found and found[1]


class Link:
    """A way across a junction: its lanes, its signal, and the numbers of the links of the junction to which it yields, and which it meets."""

    def __init__(self, line):
        self.edge, self.lane = value(line, "from"), value(line, "fromLane")
        self.target = value(line, "to"), value(line, "toLane")
        self.signal = value(line, "tl"), value(line, "linkIndex")
        self.yields, self.meets = set(), set()


def bits(text):
    """The numbers of the ones, counted from the last digit."""
    return {place for place, digit in enumerate(reversed(text)) if digit == "1"}


def is_link(line):
    """People on foot have links across crossings alone."""
    walks = value(line, "from").startswith(":") or value(line, "to").startswith(":")
    return not walks or re.search(r"_c\d+$", value(line, "to")) is not None


class RightOfWay:
    def __init__(self, lines):
        """Of the lines of a network as netconvert writes it."""
        comes, requests, leaving = {}, collections.defaultdict(list), collections.defaultdict(list)
        for line in lines:
            if re.match(r"\s*<junction ", line):
                junction = value(line, "id")
                if value(line, "type") != "internal":
                    comes[junction] = (value(line, "incLanes") or "").split()
            elif re.match(r"\s*<request ", line):
                requests[junction].append(line)
            elif re.match(r"\s*<connection ", line) and is_link(line):
                leaving[f"{value(line, 'from')}_{value(line, 'fromLane')}"].append(Link(line))
        # Requests count the links lane by lane.
        self.links = {junction: [link for lane in comes[junction] for link in leaving[lane]] for junction in requests}
        self.shown, self.minor = collections.defaultdict(list), set()
        for junction, links in self.links.items():
            if len(links) != len(requests[junction]):
                sys.exit(f"junction {junction} has {len(requests[junction])} requests for {len(links)} connections: this is no network of netconvert 1.15 and after")
            for link, request in zip(links, requests[junction]):
                link.yields, link.meets = bits(value(request, "response")), bits(value(request, "foes"))
            self.part(links)
            for link in links:
                if link.signal[0] is not None:
                    self.shown[link.signal[0]].append((int(link.signal[1]), [links[other].signal for other in link.yields]))

    def part(self, links):
        """Of two who come from one edge into one lane one yields: where none does, or both do, it is the one nearer to the kerb."""
        beside = collections.defaultdict(list)
        for number, link in enumerate(links):
            beside[link.edge, link.target].append(number)
        for merging in beside.values():
            for place, number in enumerate(merging):
                for other in merging[place + 1:]:
                    if (other in links[number].yields) == (number in links[other].yields):
                        links[number].meets.add(other)
                        links[other].meets.add(number)
                        links[number].yields.add(other)
                        links[other].yields.discard(number)
                        self.minor.add((links[number].edge, links[number].lane, *links[number].target))

    def request(self, junction, line):
        """The line of a request, with what was missing."""
        links = self.links[junction]
        link = links[int(value(line, "index"))]
        for attribute, numbers in ("response", link.yields), ("foes", link.meets):
            text = "".join("1" if number in numbers else "0" for number in reversed(range(len(links))))
            line = re.sub(f' {attribute}="[^"]*"', f' {attribute}="{text}"', line)
        return line

    def phase(self, program, state):
        """The signs of a phase of a program: who has green yields to somebody with green at that time, or goes without looking."""
        signs = list(state)
        for number, before in self.shown[program]:
            if state[number] in "Gg":
                signs[number] = "g" if any(other is None or other == program and state[int(place)] in "Gg" for other, place in before) else "G"
        return "".join(signs)

    def connection(self, line):
        """The line of a connection: M and O go first."""
        if (value(line, "from"), value(line, "fromLane"), value(line, "to"), value(line, "toLane")) in self.minor:
            line = re.sub(' state="([MO])"', lambda state: f' state="{state[1].lower()}"', line)
        return line
