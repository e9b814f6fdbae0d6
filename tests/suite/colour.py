"""What colours a picture has: colour.py pixels RAW WIDTH HEIGHT PLACES, colour.py touching RAW WIDTH HEIGHT PIXELS COLOUR …,
colour.py written RAW WIDTH HEIGHT COLOUR <ROWS, colour.py names <ROWS.

RAW are the bands of a picture as gdal_translate -of ENVI writes them. Differences are those of CIEDE2000, as eyes of all cones see them and as those that lack
one do (Machado, Oliveira and Fernandes 2009, severity 1).
"""
import collections
import math
import sys

import numpy

# Linear red, green and blue as seen without one kind of cone.
EYES = {
    "all cones": ((1, 0, 0), (0, 1, 0), (0, 0, 1)),
    "protanopia": ((0.152286, 1.052583, -0.204868), (0.114503, 0.786281, 0.099216), (-0.003882, -0.048116, 1.051998)),
    "deuteranopia": ((0.367322, 0.860646, -0.227968), (0.280085, 0.672501, 0.047413), (-0.011820, 0.042940, 0.968881)),
    "tritanopia": ((1.255528, -0.076749, -0.178779), (-0.078411, 0.930809, 0.147602), (0.004733, 0.691367, 0.303900)),
}


def linear(colour):
    """Linear red, green and blue of a code, 0 to 1."""
    values = [int(colour[i:i + 2], 16) / 255 for i in (1, 3, 5)]
    return [v / 12.92 if v <= 0.04045 else ((v + 0.055) / 1.055) ** 2.4 for v in values]


def over(upper, lower):
    """The code of what one sees where a colour, which may be translucent, lies over another."""
    opacity = int(upper[7:9], 16) / 255 if len(upper) > 7 else 1
    return "#" + "".join(f"{round(opacity * int(upper[i:i + 2], 16) + (1 - opacity) * int(lower[i:i + 2], 16)):02x}" for i in (1, 3, 5))


def contrast(one, other):
    """The contrast of two colours, 1 to 21 (WCAG 2.2)."""
    light, dark = sorted((sum(w * v for w, v in zip((0.2126, 0.7152, 0.0722), linear(colour))) for colour in (one, other)), reverse=True)
    return (light + 0.05) / (dark + 0.05)


def lab(rgb):
    """CIE L*a*b* of linear red, green and blue, white of daylight D65."""
    rows = ((0.4124564, 0.3575761, 0.1804375, 0.95047), (0.2126729, 0.7151522, 0.0721750, 1.0), (0.0193339, 0.1191920, 0.9503041, 1.08883))
    x, y, z = (sum(w * v for w, v in zip(row, rgb)) / row[3] for row in rows)
    x, y, z = (v ** (1 / 3) if v > 216 / 24389 else (24389 / 27 * v + 16) / 116 for v in (x, y, z))
    return 116 * y - 16, 500 * (x - y), 200 * (y - z)


def ciede2000(one, other):
    """The difference of two colours of CIE L*a*b* (Sharma, Wu and Dalal 2005)."""
    (l1, a1, b1), (l2, a2, b2) = one, other
    mean = (math.hypot(a1, b1) + math.hypot(a2, b2)) / 2
    stretch = 1.5 - 0.5 * math.sqrt(mean ** 7 / (mean ** 7 + 25 ** 7))
    c1, c2 = math.hypot(a1 * stretch, b1), math.hypot(a2 * stretch, b2)
    h1, h2 = (math.degrees(math.atan2(b, a * stretch)) % 360 for a, b in ((a1, b1), (a2, b2)))
    turn = 0 if c1 * c2 == 0 else (h2 - h1 + 180) % 360 - 180
    hue = h1 + h2 if c1 * c2 == 0 else (h1 + h2) / 2 if abs(h1 - h2) <= 180 else (h1 + h2 + 360) / 2
    l, c = (l1 + l2) / 2, (c1 + c2) / 2
    t = sum(w * math.cos(math.radians(n * hue - d)) for w, n, d in ((-0.17, 1, 30), (0.24, 2, 0), (0.32, 3, -6), (-0.20, 4, 63))) + 1
    sl, sc, sh = 1 + 0.015 * (l - 50) ** 2 / math.sqrt(20 + (l - 50) ** 2), 1 + 0.045 * c, 1 + 0.015 * c * t
    rotation = -2 * math.sqrt(c ** 7 / (c ** 7 + 25 ** 7)) * math.sin(math.radians(60 * math.exp(-((hue - 275) / 25) ** 2)))
    dl, dc, dh = (l2 - l1) / sl, (c2 - c1) / sc, 2 * math.sqrt(c1 * c2) * math.sin(math.radians(turn / 2)) / sh
    return math.sqrt(dl ** 2 + dc ** 2 + dh ** 2 + rotation * dc * dh)


def difference(one, other):
    """The least difference that any kind of eyes sees, and which."""
    return min((ciede2000(*(lab([min(1, max(0, sum(w * v for w, v in zip(row, linear(colour))))) for row in matrix]) for colour in (one, other))), eyes)
               for eyes, matrix in EYES.items())


def pixels(path, width, height):
    """The colours of a picture as numbers, row by row."""
    red, green, blue = numpy.fromfile(path, numpy.uint8).astype(numpy.int32)[:3 * width * height].reshape(3, width * height)
    return red << 16 | green << 8 | blue


def wrong_pixels(path, width, height, places):
    """The places of a file of rows x,y,colour,class where the picture has another colour; and the number of all, by class."""
    picture = pixels(path, width, height)
    wrong, counts = [], collections.Counter()
    for x, y, colour, kind in (row.rstrip("\n").split(",") for row in open(places)):
        seen = f"#{picture[int(y) * width + int(x)]:06x}"
        counts[kind] += 1
        if seen != colour:
            wrong.append(f"{kind} at {x} {y} is {seen}, not {colour}")
    return wrong, counts


def touching(path, width, height, colours):
    """How many pixels of border there are between each two of some colours: two of the one, one that has of both, two of the other. Lines part what they lie
    between, such as kerb stones, as the pixel there has of neither."""
    picture = pixels(path, width, height)
    known = numpy.isin(picture, [int(colour[1:], 16) for colour in colours])
    found = collections.Counter()
    for step in (1, width):
        a, b, between, c, d = (picture[n * step:len(picture) - (4 - n) * step] for n in range(5))
        border = (a == b) & (b != c) & (c == d) & known[step:-3 * step] & known[3 * step:-step]
        rows, counts = numpy.unique(numpy.stack([b[border], between[border], c[border]]), axis=1, return_counts=True)
        for (one, middle, other), count in zip(rows.T, counts):
            if all(min(low, high) - 1 <= v <= max(low, high) + 1 for v, low, high in zip(*(bytes.fromhex(f"{colour:06x}") for colour in (middle, one, other)))):
                found[tuple(sorted((f"#{one:06x}", f"#{other:06x}")))] += int(count)
    return found


def unseen(path, width, height, colour, rows):
    """The rows x y x y letters, boxes of a picture, that hold less than half a pixel a letter of nearly a colour: edges of small letters are pale."""
    picture = pixels(path, width, height).reshape(height, width)
    near = sum(abs((picture >> shift & 255) - (int(colour[1:], 16) >> shift & 255)) for shift in (16, 8, 0)) < 60
    wrong = []
    for row in rows:
        left, top, right, bottom = (max(0, round(float(end))) for end in row[:4])
        if 2 * near[top:bottom, left:right].sum() < int(row[4]):
            wrong.append(f"{near[top:bottom, left:right].sum()} pixels at {' '.join(row)}")
    return wrong


def told(wrong, enough):
    """Whether there was enough to look at and nothing wrong was found."""
    print(*wrong[:5], sep="\n", file=sys.stderr, end="\n" if wrong else "")
    print("t" if enough and not wrong else "f")


def main(what, *arguments):
    if what == "pixels":
        path, width, height, places = arguments
        wrong, counts = wrong_pixels(path, int(width), int(height), places)
        told(wrong or ([] if counts.total() == 500 else [f"{counts.total()} pixels: {dict(counts)}"]), len(counts) >= 4)
    elif what == "touching":
        path, width, height, least, *colours = arguments
        pairs = {pair: difference(*pair) for pair, count in touching(path, int(width), int(height), colours).items() if count >= int(least)}
        told([f"{one} and {other} differ by {worst:.1f} for {eyes}" for (one, other), (worst, eyes) in pairs.items() if worst < 12], len(pairs) >= 2)
    elif what == "written":
        path, width, height, colour = arguments
        rows = [row.split() for row in sys.stdin]
        told(unseen(path, int(width), int(height), colour, rows), len(rows) > 5)
    elif what == "names":
        # Rows "letter halo ground": letters stand on their halo, which lies on the ground.
        rows = [row.split() for row in sys.stdin]
        told([f"{letter} on {halo} over {ground}" for letter, halo, ground in rows if contrast(letter, over(halo, ground)) < 4.5], len(rows) > 10)


if __name__ == "__main__":
    main(*sys.argv[1:])
