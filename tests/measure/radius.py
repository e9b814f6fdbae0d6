"""Mean and median errors of radii by a forest, by the law of equation 1 refitted, by the law as it is, and by a
constant: radius.py WHEN, with the rows of radius.sql as input."""
import csv
import math
import statistics
import sys

law_of_paper = (346, 10, 65)  # sqrt(346 V / |10 w + 65 - V|), w the half width
scale = 0.5  # metres from which a residual counts less than its square


def radius(law, width, speed):
    a, b, c = law
    return math.sqrt(abs(a * speed / (b * width + c - speed or 1e-9)))


def corner_radius(law, row):
    return min(radius(law, *row["axes"][0]), radius(law, *row["axes"][1]))


def loss(law, rows):
    """Cauchy's loss: a few wild radii lead nobody."""
    return sum(math.log1p(((corner_radius(law, row) - row["observed"]) / scale) ** 2) for row in rows)


def least(of, start):
    """The place of the least value by the simplex of Nelder and Mead."""
    places = [list(start)] + [[x * 1.3 if i == k else x for k, x in enumerate(start)] for i in range(len(start))]
    simplex = sorted((of(p), p) for p in places)
    for _ in range(300):
        middle = [statistics.fmean(p[k] for _, p in simplex[:-1]) for k in range(len(start))]

        def along(share):
            place = [m + share * (w - m) for m, w in zip(middle, simplex[-1][1])]
            return of(place), place
        best = along(-1)
        if best[0] < simplex[0][0]:
            best = min(best, along(-2))
        elif best[0] >= simplex[-2][0]:
            best = min(best, along(0.5))
        if best[0] < simplex[-1][0]:
            simplex[-1] = best
        else:
            first = simplex[0][1]
            simplex = [simplex[0]] + [(of(p), p) for p in ([(x + f) / 2 for x, f in zip(p, first)] for _, p in simplex[1:])]
        simplex.sort()
    return simplex[0]


def refitted(rows):
    """The coefficients that suit these corners best, from the paper's, and from those that are as one radius."""
    middle = statistics.median(row["observed"] for row in rows)
    starts = [law_of_paper, (346 * (middle / 12) ** 2, 10, 65)]
    return min(least(lambda law: loss(law, rows), start) for start in starts)[1]


rows = []
for deal, fold, *numbers in csv.reader(sys.stdin):
    observed, forest, constant, *axes = map(float, numbers)
    rows.append({"deal": deal, "fold": fold, "observed": observed, "forest": forest, "constant": constant,
                 "axes": (axes[:2], axes[2:])})
for deal in sorted({row["deal"] for row in rows}):
    for fold in sorted({row["fold"] for row in rows}):
        of_deal = [row for row in rows if row["deal"] == deal]
        law = refitted([row for row in of_deal if row["fold"] != fold])
        for row in of_deal:
            if row["fold"] == fold:
                row["refitted"] = corner_radius(law, row)
deals = len({row["deal"] for row in rows})
for row in rows:
    row["paper"] = corner_radius(law_of_paper, row)


def errors(column, of):
    """The mean over all rounds of what each says."""
    return statistics.fmean(of([abs(row[column] - row["observed"]) for row in rows if row["deal"] == deal])
                            for deal in {row["deal"] for row in rows})


for name, of in (("mean", statistics.fmean), ("median", statistics.median)):
    print(" | ".join([sys.argv[1], str(len(rows) // deals), name]
                     + [f"{errors(column, of):.3f}" for column in ("forest", "refitted", "paper", "constant")]))
