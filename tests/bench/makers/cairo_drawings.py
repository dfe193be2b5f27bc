# SPDX-License-Identifier: Apache-2.0
"""Diagrams drawn through cairo, as many programs draw them: SVG with letters as glyphs, PNG and PDF."""
import math
import os

import figure

try:
    import cairo
except ImportError:
    cairo = None

WIDE, HIGH = 480, 360  # points


class Board:
    """A surface that notes what is written on it."""

    def __init__(self, surface, scale):
        self.to = cairo.Context(surface)
        self.to.scale(scale, scale)
        self.to.set_source_rgb(1, 1, 1)
        self.to.paint()
        self.ink = (0, 0, 0)
        self.to.set_source_rgb(*self.ink)
        self.words, self.arrows, self.curves = [], [], []
        self.font("DejaVu Sans", 14)

    def font(self, family, size, slant=0):
        self.to.select_font_face(family, slant, cairo.FONT_WEIGHT_NORMAL)
        self.to.set_font_size(size)

    def say(self, text, x, y, upwards=False):
        """The middle of the words is there."""
        e = self.to.text_extents(text)
        self.to.save()
        self.to.move_to(x, y)
        if upwards:
            self.to.rotate(-math.pi / 2)
        self.to.rel_move_to(-e.x_bearing - e.width / 2, -e.y_bearing - e.height / 2)
        self.to.show_text(text)
        self.to.restore()
        self.to.new_path()
        self.words.append((text, 100 * x / WIDE, 100 * y / HIGH))

    def line(self, *points, close=False, fill=None):
        for x, y in points:
            self.to.line_to(x, y)
        if close:
            self.to.close_path()
        if fill is not None:
            self.to.set_source_rgb(*fill)
            self.to.fill_preserve()
            self.to.set_source_rgb(*self.ink)
        self.note_path()
        self.to.stroke()

    def note_path(self):
        for kind, at in self.to.copy_path_flat():
            if kind == cairo.PATH_MOVE_TO:
                self.curves.append(("line", []))
            points = self.curves[-1][1]
            points.append((100 * at[0] / WIDE, 100 * at[1] / HIGH) if at else points[0])
        self.curves = [curve for curve in self.curves if len(curve[1]) > 1]

    def box(self, x, y, w, h, fill=None):
        self.line((x, y), (x + w, y), (x + w, y + h), (x, y + h), close=True, fill=fill)

    def circle(self, x, y, r, fill=None):
        self.to.new_sub_path()
        self.to.arc(x, y, r, 0, 2 * math.pi)
        self.line(close=True, fill=fill)

    def arrow(self, x0, y0, x1, y1, size=10):
        angle = math.atan2(y1 - y0, x1 - x0)
        self.line((x0, y0), (x1 - size * math.cos(angle) / 2, y1 - size * math.sin(angle) / 2))
        self.to.move_to(x1, y1)
        for turn in (2.7, -2.7):
            self.to.line_to(x1 + size * math.cos(angle + turn), y1 + size * math.sin(angle + turn))
        self.to.close_path()
        self.to.fill()
        self.arrows.append((100 * x1 / WIDE, 100 * y1 / HIGH, 100 * x0 / WIDE, 100 * y0 / HIGH))


def circuit(b):
    b.line((80, 160), (80, 80), (180, 80))
    b.box(180, 68, 90, 24)
    b.line((270, 80), (400, 80), (400, 160))
    b.circle(400, 190, 30)
    b.line((379, 169), (421, 211))
    b.line((421, 169), (379, 211))
    b.line((400, 220), (400, 300), (80, 300), (80, 190))
    b.line((55, 160), (105, 160))
    b.line((65, 190), (95, 190))
    b.say("R = 10 Ω", 225, 50)
    b.say("U = 4.5 V", 150, 180)
    b.say("Lamp", 330, 190)


def triangle(b):
    b.line((80, 290), (400, 290), (160, 90), close=True)
    b.line((160, 90), (160, 290))
    b.font("Nimbus Sans", 16)
    for text, x, y in (("A", 60, 300), ("B", 420, 300), ("C", 160, 70), ("a", 300, 190), ("b", 100, 190), ("c = 8 cm", 240, 315), ("h", 175, 220)):
        b.say(text, x, y)
    b.say("45°", 118, 278)


def cell(b):
    b.circle(240, 190, 140)
    b.circle(210, 180, 45, fill=(.8, .8, .8))
    b.circle(300, 250, 18)
    b.font("Nimbus Roman", 16)
    for text, x, y, to in (("Nucleus", 60, 60, (195, 140)), ("Cell wall", 420, 60, (345, 98)), ("Vacuole", 420, 310, (316, 258))):
        b.say(text, x, y)
        b.line((x, y + (14 if y < 200 else -14)), to)


def island(b):
    b.line((90, 120), (180, 60), (330, 80), (410, 200), (300, 310), (140, 280), close=True, fill=(.9, .95, .85))
    b.font("DejaVu Serif", 15)
    b.say("Port Helen", 190, 120)
    b.circle(190, 140, 4, fill=(0, 0, 0))
    b.say("Mount Tor", 290, 200)
    b.font("DejaVu Serif", 15, 1)
    b.say("Western Sea", 60, 330)


def clock(b):
    b.circle(240, 180, 150)
    b.font("Liberation Sans", 18)
    for hour in range(1, 13):
        a = math.radians(30 * hour - 90)
        b.line((240 + 150 * math.cos(a), 180 + 150 * math.sin(a)), (240 + 138 * math.cos(a), 180 + 138 * math.sin(a)))
        b.say(str(hour), 240 + 118 * math.cos(a), 180 + 118 * math.sin(a))
    b.line((240, 180), (240, 90))
    b.line((240, 180), (300, 210))


def number_line(b):
    b.arrow(40, 180, 450, 180)
    for i, x in enumerate(range(60, 440, 60)):
        b.line((x, 172), (x, 188))
        b.say(str(i - 3).replace("-", "−"), x, 210)
    b.say("Numbers from −3 to 3", 240, 60)


def axes(b):
    b.arrow(60, 310, 440, 310)
    b.arrow(60, 310, 60, 40)
    points = [(60 + 3 * i, 300 - 230 * (1 - math.exp(-i / 40))) for i in range(110)]
    b.line(*points)
    b.say("time t in s", 250, 335)
    b.say("speed v in m/s", 25, 180, upwards=True)
    b.say("A falling ball", 240, 20)


def cycle(b):
    places = [("Sea", 240, 310), ("Vapour", 80, 180), ("Cloud", 240, 60), ("Rain", 400, 180)]
    for text, x, y in places:
        b.box(x - 45, y - 20, 90, 40)
        b.say(text, x, y)
    b.arrow(195, 300, 100, 205)
    b.arrow(100, 155, 190, 80)
    b.arrow(290, 80, 385, 155)
    b.arrow(385, 205, 290, 300)


DRAWINGS = [circuit, triangle, cell, island, clock, number_line, axes, cycle]


TITLES = {number_line: "Numbers from −3 to 3", axes: "A falling ball"}


def needs():
    return None if cairo else "python3-cairo"


def draw_as_files(stem, dpi, draw, board_of=Board):
    """SVG, PDF and PNG of what `draw` does to a board. Gives the files by their ending, and the last board."""
    for form in ("svg", "pdf", "png"):
        scale = dpi / 72 if form == "png" else 1
        size = (round(WIDE * scale), round(HIGH * scale))
        surface = {"svg": lambda: cairo.SVGSurface(stem + ".svg", *size), "pdf": lambda: cairo.PDFSurface(stem + ".pdf", *size),
                   "png": lambda: cairo.ImageSurface(cairo.FORMAT_RGB24, *size)}[form]()
        board = board_of(surface, scale)
        draw(board)
        if form == "png":
            surface.write_to_png(stem + ".png")
        surface.finish()
    return {form: f"{stem}.{form}" for form in ("svg", "pdf", "png")}, board


def make(folder, dpi):
    for draw in DRAWINGS:
        files, board = draw_as_files(os.path.join(folder, "cairo-" + draw.__name__), dpi, draw)
        yield figure.Figure("cairo", draw.__name__, {"SVG glyphs": files["svg"], "PNG": files["png"], "PDF": files["pdf"]}, board.words,
                            board.arrows, board.curves, title=TITLES.get(draw, ""))
