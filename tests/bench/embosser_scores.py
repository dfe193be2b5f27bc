# SPDX-License-Identifier: Apache-2.0
"""Where the dots of pages are, and how well they agree with what people drew; tests/bench/embossers says what is counted."""
import json
import subprocess
import sys

import numpy as np

CONVERT = "/usr/bin/convert"
PITCH = 2.5
SHIFTS = (-2, -1, 0, 1, 2)


def fail(text):
    sys.exit("embossers: " + text)


def our_dots(grid, page, program):
    """The dots; left, top, width and height of the drawing; where dots can be, across and down; all in mm."""
    with open(page + ".json", encoding="utf-8") as file:
        told = json.load(file)["outputs"][0]
    sheet, drawn = [[told[what + side] for side in ("_width_mm", "_height_mm")] for what in ("page", "drawing")]
    seen = subprocess.run([program, "preview", page, "--embosser", grid.machine, "--json", "--paper", "%gx%gmm" % tuple(sheet)],
                          capture_output=True, text=True, check=False)
    if seen.returncode != 0:
        fail(seen.stderr.strip())
    begin, extent, places = [], [], []
    for whole, step, inner in zip(sheet, grid.step, grid.inner):
        # Dots of 1.6 mm stay off the medium's margin of 6 mm, and no nearer to the other edges than the machine's first dot.
        cells = [grid.first + i * step for i in range(200)]
        cells = [c for c in cells if c > 6.8 - 1e-6 and c + inner < min(whole - 6.8, whole - grid.first) + 1e-6]
        places.append(np.array([c + i * PITCH for c in cells for i in range(round(inner / PITCH) + 1)]))
        begin.append(places[-1][0] - 0.8)
        extent.append(places[-1][-1] - places[-1][0] + 1.6)
    # The drawing is as large as fits, in the middle of the width and at the top.
    if min(abs(a - b) for a, b in zip(drawn, extent)) > 0.01:
        fail("the drawing of %g x %g mm does not fill %g x %g mm; has the layout changed?" % (*drawn, *extent))
    return json.loads(seen.stdout.splitlines()[0])["dots"], (begin[0] + (extent[0] - drawn[0]) / 2, begin[1], *drawn), places


def their_dots(grid, page, subject):
    """The same, and quarter turns to the left by which the picture stands on the page."""
    with open(page, encoding="utf-8") as file:
        lines = file.read().replace("\r", "").replace("\f", "").split("\n")
    dots = []
    for row, line in enumerate(lines):
        for column, letter in enumerate(line):
            bits = grid.bits(letter)
            if not 0 <= bits < 256:
                fail("%s wrote %r, which is no braille" % (grid.rival, letter))
            raised = [(bit // 3, bit % 3) if bit < 6 else (bit - 6, 3) for bit in range(8) if bits >> bit & 1]
            dots += [grid.place(2 * column + right, grid.dots_down * row + down) for right, down in raised]
    size = [subject["width"], subject["height"]]
    wide = size[0] > size[1]
    paper, columns, rows = grid.area(wide)
    turned = wide and paper == "A4"
    if turned:
        size.reverse()
    # As many dots as fit, rounded as ImageMagick's -resize does, from the top left.
    scale = min(columns / size[0], rows / size[1])
    box = (0, 0, *(int(s * scale + 0.5) * pitch for s, pitch in zip(size, grid.pitch)))
    places = [np.array([grid.place(i, 0)[0] for i in range(columns)]), np.array([grid.place(0, i)[1] for i in range(rows)])]
    return dots, box, places, 3 if turned else 0


def read_map(path):
    """A person's contours as an array; ImageMagick reads the PNG."""
    data = subprocess.run([CONVERT, path, "-depth", "8", "pgm:-"], capture_output=True, check=False).stdout
    head = data.split(maxsplit=4)
    if len(head) < 4 or head[0] != b"P5":
        fail("%s: cannot be read as a picture" % path)
    width, height = int(head[1]), int(head[2])
    return np.frombuffer(data[-width * height:], np.uint8).reshape(height, width) > 0


def score(dots, box, maps, shift=(0, 0)):
    """Dots that are right, dots, contour pixels that are found, contour pixels."""
    dots = np.array(dots, float).reshape(-1, 2)
    height, width = maps[0].shape
    side = (box[2] / width, box[3] / height)  # mm of a pixel
    x, y = ((dots[:, i] + shift[i] - box[i]) / side[i] for i in (0, 1))
    reach = [int(PITCH / s) + 2 for s in side]
    away_x, away_y = np.meshgrid(*(np.arange(-r, r + 1) for r in reach))
    column = np.floor(x).astype(int)[:, None] + away_x.ravel()
    row = np.floor(y).astype(int)[:, None] + away_y.ravel()
    near = np.hypot((column + 0.5 - x[:, None]) * side[0], (row + 0.5 - y[:, None]) * side[1]) <= PITCH
    near &= (column >= 0) & (column < width) & (row >= 0) & (row < height)
    row, column = np.clip(row, 0, height - 1), np.clip(column, 0, width - 1)
    right = (np.logical_or.reduce(maps)[row, column] & near).any(axis=1)
    covered = np.zeros((height, width), bool)
    covered[row[near], column[near]] = True
    return np.array([right.sum(), len(dots), sum((m & covered).sum() for m in maps), sum(m.sum() for m in maps)])


def as_dots(contours, box, places):
    """A person's contours on the places of the dots: each pixel raises the dot nearest to it."""
    inside = [p[(p >= start) & (p <= start + extent)] for p, start, extent in zip(places, box[:2], box[2:])]
    row, column = np.nonzero(contours)
    pixels = (box[0] + (column + 0.5) * box[2] / contours.shape[1], box[1] + (row + 0.5) * box[3] / contours.shape[0])
    nearest = [np.abs(p[None, :] - at[:, None]).argmin(axis=1) for p, at in zip(inside, pixels)]
    taken = np.unique(np.stack(nearest, axis=1), axis=0)
    return np.stack([inside[0][taken[:, 0]], inside[1][taken[:, 1]]], axis=1)


def partners(ours, theirs):
    """As many pairs within one pitch as there can be: for each of ours that has a partner, its number."""
    close, owner = {}, {}
    for number, (x, y) in enumerate(ours):
        close.setdefault((x // PITCH, y // PITCH), []).append(number)
    options = []
    for x, y in theirs:
        around = [n for i in (-1, 0, 1) for j in (-1, 0, 1) for n in close.get((x // PITCH + i, y // PITCH + j), ())]
        away = {n: (ours[n][0] - x) ** 2 + (ours[n][1] - y) ** 2 for n in around}
        options.append(sorted((n for n in around if away[n] <= PITCH * PITCH + 1e-6), key=away.get))

    def find(one, seen):
        for number in options[one]:
            if number not in seen:
                seen.add(number)
                if number not in owner or find(owner[number], seen):
                    owner[number] = one
                    return True
        return False

    left = []
    for one, near in enumerate(options):  # what is free first, so that few have to give way
        free = next((n for n in near if n not in owner), None)
        if free is None:
            left.append(one)
        else:
            owner[free] = one
    for one in left:
        find(one, set())
    return owner


def score_pairs(dots, people):
    """The four counts where people's contours are dots, too, and each has one partner at most."""
    owners = [partners(dots, theirs.tolist()) for theirs in people]
    return np.array([len(set().union(*owners)), len(dots), sum(map(len, owners)), sum(map(len, people))])


def score_all(every, yardsticks, subjects, program, shift):
    """Fills in the counts of the methods and of the yardsticks of each grid: all dots raised, and people."""
    for number, subject in enumerate(subjects):
        maps = [read_map(path) for path in subject["maps"]]
        for method in every:
            page, grid, turns = method.pages[number], method.grid, 0
            if method.ours:
                dots, box, places = our_dots(grid, page, program)
            else:
                dots, box, places, turns = their_dots(grid, page, subject)
            seen = [np.rot90(m, turns) for m in maps]
            people = [as_dots(m, box, places) for m in seen]
            method.counts += score(dots, box, seen)
            method.pairs += score_pairs(dots, people)
            for by in ((i, j) for i in SHIFTS for j in SHIFTS if shift):
                method.shifted[by] = method.shifted.get(by, 0) + score(dots, box, seen, (by[0] * PITCH, by[1] * PITCH))
            if method is next(m for m in every if m.grid is grid):  # once a grid
                full, crowd = yardsticks[grid]
                raised = as_dots(np.ones_like(maps[0]), box, places).tolist()
                full.counts += score(raised, box, maps)
                full.pairs += score_pairs(raised, people)
                for i in range(len(maps) if len(maps) > 1 else 0):
                    crowd.counts += score(people[i], box, maps[:i] + maps[i + 1:])
                    crowd.pairs += score_pairs(people[i].tolist(), people[:i] + people[i + 1:])
