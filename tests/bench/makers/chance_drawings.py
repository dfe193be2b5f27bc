# SPDX-License-Identifier: Apache-2.0
"""Drawings of schoolbooks as chance will have them, through cairo: geometry, circuits, forces, parts with their names, maps, axes, trees."""
import math
import os
import random
import sys

import cairo_drawings
import figure

WIDE, HIGH = cairo_drawings.WIDE, cairo_drawings.HIGH
FONTS = ["DejaVu Sans", "DejaVu Serif", "Nimbus Sans", "Nimbus Roman", "Liberation Sans", "Liberation Serif"]
PARTS = ["Nucleus", "Cell wall", "Vacuole", "Root", "Stem", "Leaf", "Petal", "Seed coat", "Lens", "Retina", "Iris", "Optic nerve", "Valve",
         "Piston", "Crank", "Spark plug", "Crust", "Mantle", "Core", "Magma", "Skin", "Muscle", "Bone", "Nerve", "Left lung", "Liver"]
TOWNS = ["Arden", "Belmont", "Corby", "Dunmore", "Elgin", "Fairview", "Glen", "Harwich", "Ilford", "Kells", "Lund", "Moss", "Newport", "Otley"]
COLOURS = [(0, 0, 0), (0, 0, 0), (0, 0, .7), (.8, 0, 0), (0, .4, 0)]
PALE = [(.9, .9, .9), (.85, .93, 1), (1, .95, .8), (.85, 1, .85)]


def along(a, b, share, aside=0):
    """A place between two, and so far to the left of the way."""
    dx, dy = b[0] - a[0], b[1] - a[1]
    length = math.hypot(dx, dy)
    return a[0] + share * dx + aside * dy / length, a[1] + share * dy - aside * dx / length


def polygon(b, chance):
    """Named corners, sides and an angle; a dashed diagonal."""
    count = chance.choice([3, 3, 4, 4, 5])
    turn = chance.uniform(0, 2 * math.pi)
    corners = []
    for i in range(count):
        angle = turn + 2 * math.pi * (i + chance.uniform(-.22, .22)) / count
        corners.append((240 + chance.uniform(120, 160) * math.cos(angle), 180 + chance.uniform(95, 125) * math.sin(angle)))
    b.line(*corners, close=True, fill=chance.choice([None, None, chance.choice(PALE)]))
    middle = [sum(c[i] for c in corners) / count for i in (0, 1)]
    first = chance.choice("AAPK")
    for i, corner in enumerate(corners):
        b.say(chr(ord(first) + i), *along(middle, corner, 1 + 20 / math.dist(middle, corner)))
    sides = chance.choice([lambda i: "abcdefg"[i], lambda i: f"{chance.randint(2, 19)} cm", lambda i: f"{chance.randint(11, 98) / 10} m", None])
    for i in range(count if sides else 0):
        a, c = corners[i], corners[(i + 1) % count]
        text = sides(i)
        half = b.half_of(text)
        out = along(a, c, .5, 1)
        way = (out[0] - (a[0] + c[0]) / 2, out[1] - (a[1] + c[1]) / 2)
        b.say(text, *along(a, c, .5, 6 + half[0] * abs(way[0]) + half[1] * abs(way[1])))
    if chance.random() < .6:
        i = chance.randrange(count)
        at, before, after = corners[i], corners[i - 1], corners[(i + 1) % count]
        start, end = (math.atan2(p[1] - at[1], p[0] - at[0]) for p in (after, before))
        sweep = (end - start) % (2 * math.pi)
        b.line(*[(at[0] + 34 * math.cos(start + sweep * k / 12), at[1] + 34 * math.sin(start + sweep * k / 12)) for k in range(13)])
        if sweep > .9:
            b.say(chance.choice(["α", "β", f"{round(math.degrees(sweep))}°"]), at[0] + 54 * math.cos(start + sweep / 2),
                  at[1] + 54 * math.sin(start + sweep / 2))
    if count > 3:
        b.dashed(corners[0], corners[2])


PARTS_OF_CIRCUIT = {"resistor": ["R", "R1", "R2", "100 Ω", "R = 47 Ω", "2.2 kΩ"], "lamp": ["L1", "Lamp", "H"], "meter": ["A", "V"],
                    "capacitor": ["C", "C1", "10 µF"], "switch": ["S", "S1", "Switch"], "battery": ["9 V", "U", "U = 6 V"]}


def circuit(b, chance):
    """A ring with a part on each side, and perhaps a branch."""
    left, top, right, bottom = 90, 80, 390, 290
    rows = [((left, top), (right, top)), ((right, top), (right, bottom)), ((right, bottom), (left, bottom)), ((left, bottom), (left, top))]
    if chance.random() < .5:
        x = chance.randint(200, 280)
        rows.append(((x, top), (x, bottom)))
        for y in (top, bottom):
            b.disc(x, y, 3.5)
    kinds = ["battery"] + chance.sample(sorted(set(PARTS_OF_CIRCUIT) - {"battery"}), len(rows) - 1)
    names = set()
    for (a, c), kind in zip(rows, kinds):
        ux, uy = (c[0] - a[0]) / math.dist(a, c), (c[1] - a[1]) / math.dist(a, c)
        mx, my = along(a, c, .5)

        def at(on, beside):
            return mx + on * ux + beside * uy, my + on * uy - beside * ux

        half = {"resistor": 30, "lamp": 18, "meter": 18, "capacitor": 5, "switch": 20, "battery": 5}[kind]
        b.line(a, at(-half, 0))
        b.line(at(half, 0), c)
        name = chance.choice([n for n in PARTS_OF_CIRCUIT[kind] if n not in names])
        names.add(name)
        aside = 26
        if kind == "resistor":
            b.line(at(-30, 10), at(30, 10), at(30, -10), at(-30, -10), close=True)
        elif kind in ("lamp", "meter"):
            b.circle(mx, my, 18)
            for turn in (1, -1) if kind == "lamp" else ():
                b.line((mx - 12.7, my - 12.7 * turn), (mx + 12.7, my + 12.7 * turn))
        elif kind == "switch":
            b.line(at(-20, 0), at(16, 16))
        else:
            b.line(at(-5, -16), at(-5, 16))
            b.line(at(5, -16 if kind == "capacitor" else -9), at(5, 16 if kind == "capacitor" else 9))
            aside = 22
        if kind == "meter":
            b.say(name, mx, my)
        else:
            wide, high = b.half_of(name)
            b.say(name, *at(0, aside + wide * abs(uy) + high * abs(ux)))


def forces(b, chance):
    """A block on a slope or on the ground, and the forces on it."""
    ground = 300
    tilt = chance.choice([0, math.radians(chance.randint(15, 30))])
    start, end = (60, ground), (430, ground - 370 * math.tan(tilt))
    if tilt:
        b.line(start, (430, ground), end, close=True)
        b.say(chance.choice(["α", f"{round(math.degrees(tilt))}°"]), 150, ground - 14 - 20 * (tilt < .35))
    else:
        b.line(start, end)
    foot = along(start, end, .5)
    box = [(-35, 0), (35, 0), (35, 50), (-35, 50)]
    c, s = math.cos(tilt), math.sin(tilt)

    def on(x, y):
        return foot[0] + x * c - y * s, foot[1] - x * s - y * c

    b.line(*[on(x, y) for x, y in box], close=True, fill=chance.choice([None, *PALE]))
    names = chance.sample(["F", "N", "F = 20 N", "Fg", "Pull", "v"], 3)
    for name, (x0, y0, x1, y1) in zip(names, [(35, 25, 100, 25), (0, 50, 0, 105), (-35, 25, -95, 25)]):
        b.arrow(*on(x0, y0), *on(x1, y1))
        tip, wide = on(x1, y1), b.half_of(name)[0]
        b.say(name, tip[0] + (x1 - x0) / abs(x1 - x0 or 1) * (8 + wide), tip[1] - 14)


def parts(b, chance):
    """A blob with smaller ones in it, and names outside at the ends of lines."""
    names = chance.sample(PARTS, chance.randint(3, 6))
    b.oval(240, 180, chance.randint(85, 115), chance.randint(80, 110), chance.choice([None, *PALE]))
    for i, name in enumerate(names):
        right = i % 2
        y = 55 + 250 * (i // 2) / max(1, (len(names) - 1) // 2)
        x = 425 if right else 55
        wide = b.half_of(name)[0]
        inner = (240 + (1 if right else -1) * chance.randint(20, 55), 180 + (y - 180) * .42)
        b.oval(*inner, chance.randint(9, 16), chance.randint(9, 16), chance.choice([None, (.6, .6, .6)]))
        b.say(name, x, y)
        b.line((x - wide - 5 if right else x + wide + 5, y), inner)


def island(b, chance):
    """An island with towns, and perhaps a dashed border, a scale and an arrow to the north."""
    turns = [2 * math.pi * i / 14 for i in range(14)]
    coast = [(240 + chance.uniform(140, 185) * math.cos(t), 185 + chance.uniform(95, 130) * math.sin(t)) for t in turns]
    b.line(*coast, close=True, fill=chance.choice([None, *PALE]))
    if chance.random() < .6:
        x = chance.randint(200, 280)
        b.dashed(*[(x + chance.uniform(-14, 14), y) for y in range(95, 281, 31)])
    for name, (x, y) in zip(chance.sample(TOWNS, 4), chance.sample([(140, 150), (320, 130), (170, 225), (330, 215), (240, 180), (245, 105)], 4)):
        b.disc(x, y, 3.5)
        b.say(name, x + 9 + b.half_of(name)[0], y)
    if chance.random() < .7:
        b.line((30, 335), (130, 335))
        for i, text in enumerate(("0", "50", "100 km")):
            b.line((30 + 50 * i, 330), (30 + 50 * i, 340))
            b.say(text, 30 + 50 * i + (12 if i == 2 else 0), 320)
    if chance.random() < .5:
        b.arrow(445, 90, 445, 45)
        b.say("N", 445, 104)


def curve(b, chance):
    """A function in axes with numbers, and named points on it."""
    left, bottom, right, top = 70, 300, 440, 40
    b.arrow(left - 15, bottom, right, bottom)
    b.arrow(left, bottom + 15, left, top)
    across, up = chance.choice([("x", "y"), ("t", "v"), ("time in s", "height in m"), ("p", "q"), ("t in h", "T in °C")])
    b.say(across, right - b.half_of(across)[0], bottom + 32)
    b.say(up, left + 12 + b.half_of(up)[0], top)
    step = chance.choice([50, 60, 70])
    unit = chance.choice([1, 2, 5, 10, .5])
    for i in range(1, 5):
        b.line((left + step * i, bottom - 4), (left + step * i, bottom + 4))
        b.say(f"{unit * i:g}", left + step * i, bottom + 15)
    for i in range(1, 4):
        b.line((left - 4, bottom - 60 * i), (left + 4, bottom - 60 * i))
        b.say(f"{2 * unit * i:g}", left - 12 - b.half_of(f"{2 * unit * i:g}")[0], bottom - 60 * i)
    bend = chance.choice([lambda s: s * s, lambda s: 1 - (1 - s) ** 2, lambda s: .5 - .45 * math.cos(5 * s), lambda s: 1 - s])
    b.line(*[(left + 330 * k / 60, bottom - 20 - 190 * bend(k / 60)) for k in range(61)])
    for name, share in zip(chance.sample("PQRST", 2), (.3, .7)):
        x, y = left + 330 * share, bottom - 20 - 190 * bend(share)
        b.disc(x, y, 3.5)
        b.say(name, x + 4, y - 16)


def sets(b, chance):
    """Two or three rings with names and what is in them."""
    count = chance.choice([2, 3])
    places = [(190, 165), (290, 165), (240, 235)][:count]
    for (x, y), name in zip(places, chance.sample(["Birds", "Swimmers", "Pets", "A", "B", "Prime", "Even", "Odd"], count)):
        b.circle(x, y, 85)
        b.say(name, x + (x - 240) * 1.2, y - 100 if y < 200 else y + 100)
    for x, y in [(150, 155), (330, 155), (240, 135), (240, 285)][: count + 2 if count == 3 else 3]:
        b.say(str(chance.randint(1, 99)), x, y)


def tree(b, chance):
    """A family, or what follows from what; plain lines or arrows."""
    top = chance.choice(TOWNS)
    names = chance.sample([t for t in TOWNS if t != top], 5)
    boxed = chance.random() < .6
    draw = b.arrow if chance.random() < .5 else (lambda *way: b.line(way[:2], way[2:]))

    def node(name, x, y):
        if boxed:
            wide = b.half_of(name)[0] + 10
            b.box(x - wide, y - 16, 2 * wide, 32, fill=chance.choice([None, None, *PALE]))
        b.say(name, x, y)

    node(top, 240, 50)
    for i, x in enumerate((130, 350)):
        node(names[i], x, 165)
        draw(240 + (x - 240) * .2, 70, x, 145)
    for i, (x, parent) in enumerate(((70, 130), (200, 130), (350, 350))):
        node(names[2 + i], x, 290)
        draw(parent + (x - parent) * .2, 185, x, 270)


KINDS = [polygon, circuit, forces, parts, island, curve, sets, tree]


class Board(cairo_drawings.Board):
    def half_of(self, text):
        """Half of its width and height."""
        e = self.to.text_extents(text)
        return e.width / 2, e.height / 2

    def disc(self, x, y, r):
        self.to.arc(x, y, r, 0, 2 * math.pi)
        self.to.fill()

    def oval(self, x, y, rx, ry, fill):
        self.line(*[(x + rx * math.cos(math.pi * k / 30), y + ry * math.sin(math.pi * k / 30)) for k in range(60)], close=True, fill=fill)

    def dashed(self, *points):
        self.to.set_dash([6, 4])
        self.line(*points)
        self.to.set_dash([])


def drawings(count, seed, folder):
    missing = cairo_drawings.needs()
    if missing:
        sys.exit(f"figures: cairo draws these; install {missing}")
    for number in range(count):
        kind = KINDS[number % len(KINDS)]
        settings = random.Random(f"drawings {seed} {number}")
        family, size, thick, colour = settings.choice(FONTS), settings.choice([13, 15, 18]), settings.choice([1, 1.5, 2.5]), settings.choice(COLOURS)
        dpi = settings.choice([100, 150, 200])

        def draw(board):
            board.font(family, size)
            board.to.set_line_width(thick)
            board.ink = colour
            board.to.set_source_rgb(*colour)
            kind(board, random.Random(f"{kind.__name__} {seed} {number}"))

        name = f"{kind.__name__}-{number}"
        files, board = cairo_drawings.draw_as_files(os.path.join(folder, "drawn-" + name), dpi, draw, Board)
        yield figure.Figure("drawn", name, {form.upper(): file for form, file in files.items()}, board.words, board.arrows, board.curves)
