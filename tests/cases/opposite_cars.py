#!/usr/bin/env python3
"""Opposite cars that overlap: opposite_cars.py FCD [WIDTH LENGTH] reads positions of cars as SUMO writes them (--fcd-output), tells of each second in which
two that drive in opposite directions lie upon each other, and ends with 1 where there is one. The last line says how many cars drove."""
import math
import sys
import xml.etree.ElementTree as xml

width, length = (float(word) for word in (sys.argv[2:] or ("1.8", "5")))


def overlap(a, b):
    """Rectangles about two cars, whose fronts are given, seen along the first."""
    turned = abs((a[2] - b[2] + 180) % 360 - 180)
    if turned < 150:
        return False
    angle = math.radians(a[2])
    east, north = b[0] - a[0], b[1] - a[1]
    ahead, aside = east * math.sin(angle) + north * math.cos(angle), east * math.cos(angle) - north * math.sin(angle)
    return abs(aside) < width and -2 * length < ahead < 0


cars, faults = set(), 0
for _, step in xml.iterparse(sys.argv[1]):
    if step.tag != "timestep":
        continue
    places = [(float(v.get("x")), float(v.get("y")), float(v.get("angle")), v.get("id"), v.get("lane")) for v in step.iter("vehicle")]
    cars.update(place[3] for place in places)
    for i, a in enumerate(places):
        for b in places[i + 1:]:
            if overlap(a, b):
                faults += 1
                print(f"{step.get('time')}: {a[3]} on {a[4]} and {b[3]} on {b[4]}")
    step.clear()
print(f"{len(cars)} cars, {faults} overlaps")
sys.exit(faults > 0)
