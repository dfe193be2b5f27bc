# SPDX-License-Identifier: Apache-2.0
"""What became of a figure's lines and fills on the page that the program made of it (SVG).

All in mm on the page: the truth is mapped by the place of the drawing. A curve's place is drawn if a line of about its direction
is within 2 mm; dashes and dots of one line count as whole.
"""
import math
import re
import xml.etree.ElementTree

COLUMNS = ("figures", "curves mm", "drawn", "arrows", "whole", "bars", "closed", "points", "there", "fills", "told apart", "samples",
           "matched", "misnamed", "white")
NEAR = 2.0
BESIDE = 9  # from the dots of words; the program needs no line to what is within 6.4 mm of their cells
DASH_GAP = 6.5  # between marks of one line
SVG = "{http://www.w3.org/2000/svg}"


class Page:
    def __init__(self, path):
        root = xml.etree.ElementTree.parse(path).getroot()
        self.width, self.height = (float(n) for n in root.get("viewBox").split()[2:])
        self.lines = []  # (role, width, points)
        self.rings = []  # of black areas
        self.textured = []  # (texture, rings)
        self.dots = [(float(c.get("cx")), float(c.get("cy"))) for c in root.iter(SVG + "circle")]
        for path_ in root.iter(SVG + "path"):
            if path_.get("data-tactics-n") is None:
                continue
            role = (path_.get("class") or "").removeprefix("tactics-") or "line"
            if role.startswith("texture-"):
                self.textured.append((int(role.removeprefix("texture-")), subpaths(path_.get("d"))))
            elif path_.get("stroke-width") is not None:
                course = path_.get("data-tactics-line")
                self.lines += [(role, float(path_.get("stroke-width")), ring) for ring in ([points(course)] if course else subpaths(path_.get("d")))]
            else:
                self.rings += subpaths(path_.get("d"))
        if not (self.lines or self.rings or self.textured):
            raise SystemExit(f"{path}: a page without lines or areas; has its format changed?")
        self.names = []  # (text, box of a line of its braille)
        for group in root.iter(SVG + "g"):
            if (group.get("class") or "").startswith("tactics-name"):
                for line in group.iter(SVG + "g"):
                    dots = [(float(c.get("cx")), float(c.get("cy"))) for c in line.findall(SVG + "circle")]
                    if dots:
                        xs, ys = zip(*dots)
                        self.names.append((group.get("aria-label"), (min(xs), min(ys), max(xs), max(ys))))
        self.steps = Steps(self)

    def fill_at(self, x, y):
        """black, a number of a texture, or nothing."""
        if inside(self.rings, x, y):
            return "black"
        return next((str(texture) for texture, rings in self.textured if inside(rings, x, y)), "")

    def fill_of(self, left, top, right, bottom):
        """The same of a bar, or that there are lines across or along it."""
        found = self.fill_at((left + right) / 2, (top + bottom) / 2)
        if found:
            return found
        dx, dy = 0.25 * (right - left), 0.25 * (bottom - top)
        inside_it = [angle for x, y, angle, _, _ in self.steps.near((left + right) / 2, (top + bottom) / 2, math.hypot(dx, dy))
                     if left + dx < x < right - dx and top + dy < y < bottom - dy]
        level = sum(abs(math.cos(angle)) > 0.7 for angle in inside_it)
        return "" if not inside_it else "level lines" if level > len(inside_it) / 2 else "upright lines"

    def places_named(self, text):
        """Where lines lead from words, or their letters in a key; else the box of where they stand: left, top, right, bottom."""
        for name, (left, top, right, bottom) in self.names:
            if name != text:
                continue
            near = lambda p, l=left, t=top, r=right, b=bottom: l - 6 < p[0] < r + 6 and t - 6 < p[1] < b + 6
            led = [far for role, _, line in self.lines if role == "lead" for end, far in ((line[0], line[-1]), (line[-1], line[0]))
                   if near(end)]
            yield from [far + far for far in led] or [(left, top, right, bottom)]

    def white(self):
        """Share of squares of 10 mm without anything."""
        taken = {(int(x // 10), int(y // 10)) for x, y in self.dots}
        taken |= {(int(x // 10), int(y // 10)) for x, y, _, _, _ in self.steps.all}
        taken |= {(i, j) for i in range(int(self.width // 10)) for j in range(int(self.height // 10)) if self.fill_at(10 * i + 5, 10 * j + 5)}
        return 1 - len(taken) / (self.width * self.height / 100)


def points(text):
    """The course of a line: hundredths of a mm, each place from the one before."""
    values, at, course = [int(n) / 100 for n in text.split()], (0.0, 0.0), []
    for x, y in zip(values[::2], values[1::2]):
        at = (at[0] + x, at[1] + y)
        course.append(at)
    return course


def subpaths(text):
    rings, at = [], (0.0, 0.0)
    for command, body in re.findall(r"([MlLz])([^MlLz]*)", text):
        if command == "z":
            rings[-1].append(rings[-1][0])
            continue
        values = [float(n) for n in re.findall(r"-?(?:\d+\.?\d*|\.\d+)", body)]
        for x, y in zip(values[::2], values[1::2]):
            at = (at[0] + x, at[1] + y) if command == "l" else (x, y)
            if command == "M":
                rings.append([])
            rings[-1].append(at)
    return rings


def inside(rings, x, y):
    odd = False
    for ring in rings:
        for (ax, ay), (bx, by) in zip(ring, ring[1:] + ring[:1]):
            if (ay > y) != (by > y) and x < ax + (bx - ax) * (y - ay) / (by - ay):
                odd = not odd
    return odd


def along(points, step):
    """Places on a line with the direction there."""
    for (ax, ay), (bx, by) in zip(points, points[1:]):
        length = math.hypot(bx - ax, by - ay)
        count = max(1, math.ceil(length / step))
        for k in range(count):
            yield ax + (bx - ax) * (k + 0.5) / count, ay + (by - ay) * (k + 0.5) / count, math.atan2(by - ay, bx - ax), length / count


class Steps:
    """Places on all that is drawn, found by where they are. Lead lines and patterns are not the figure's own."""

    def __init__(self, page):
        self.all = []
        self.cells = {}
        last = None
        for role, width, points in page.lines:
            if role in ("lead", "pattern"):
                continue
            self.add(points, role, width)
            if role == "dash" and last is not None and math.dist(last, points[0]) < DASH_GAP + width:
                self.add([last, points[0]], "gap", width)
            last = points[-1] if role == "dash" else None
        for ring in page.rings:
            self.add(ring + ring[:1], "area", 0)

    def add(self, points, role, width):
        for x, y, angle, _ in along(points, 0.5):
            self.cells.setdefault((int(x // 4), int(y // 4)), []).append(len(self.all))
            self.all.append((x, y, angle, role, width))

    def near(self, x, y, radius):
        for i in range(int((x - radius) // 4), int((x + radius) // 4) + 1):
            for j in range(int((y - radius) // 4), int((y + radius) // 4) + 1):
                for k in self.cells.get((i, j), ()):
                    if math.dist(self.all[k][:2], (x, y)) <= radius:
                        yield self.all[k]


def drawn_share(page, points):
    """Length, and how much of it is drawn."""
    total = done = 0
    for x, y, angle, length in along(points, 1):
        total += length
        if any(abs(math.cos(other - angle)) > 0.7 for _, _, other, _, _ in page.steps.near(x, y, NEAR)):
            done += length
    return total, done


def is_whole(page, arrow):
    """Whether from a place near the tip a straight barb of 4.5 mm leaves on each side, 15 to 60 degrees from the way back.

    A filled head has such sides, too; the side of a box that the arrow ends at has not, wherever its tip is thought to be.
    """
    tip, behind = arrow
    back = math.atan2(behind[1] - tip[1], behind[0] - tip[0])
    around = [(x, y) for x, y, _, role, _ in page.steps.near(*tip, 11)]

    def is_black(x, y):
        return any(math.dist((x, y), one) < 0.5 for one in around) or inside(page.rings, x, y)

    def barb(at, sign):
        turns = (back + sign * math.radians(degrees) for degrees in range(15, 61, 5))
        return any(all(is_black(at[0] + r * math.cos(a), at[1] + r * math.sin(a)) for r in (1.5, 2.5, 3.5, 4.5)) for a in turns)

    # An arrow may end up to 4.5 mm before what it points to, which it must not touch on a page.
    for i in range(-3, 10):
        for j in range(-3, 4):
            along, across = 0.5 * i, 0.5 * j
            at = (tip[0] + along * math.cos(back) - across * math.sin(back), tip[1] + along * math.sin(back) + across * math.cos(back))
            if all(barb(at, sign) for sign in (1, -1)):
                return True
    return False


def style_at(page, places):
    """What most of the line along these places is: whole, dashes or dots, and how wide."""
    found = {}
    for x, y in places:
        for _, _, _, role, width in page.steps.near(x, y, 1.5):
            if role not in ("gap", "arrow", "area"):
                found[(role, width)] = found.get((role, width), 0) + 1
    return max(found, key=found.get, default=None)


def is_within(p, ring):
    sides = zip(ring, ring[1:] + ring[:1])
    return sum((a[1] > p[1]) != (b[1] > p[1]) and p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]) for a, b in sides) % 2 == 1


def named_by(box, look, curves, bars, rings):
    """Of that kind of look what the words in that box name: they are in it, or near to it and nearer than to anything that looks otherwise."""
    x, y = (box[0] + box[2]) / 2, (box[1] + box[3]) / 2
    away = {}
    if look.startswith("fill"):
        for other, ring in rings:
            if is_within((x, y), ring):
                return other
        for other, left, top, right, bottom in bars:
            off = math.hypot(max(left - box[2], 0, box[0] - right), max(top - box[3], 0, box[1] - bottom))
            away[other] = min(off, away.get(other, off))
    else:
        off = lambda p: math.hypot(max(box[0] - p[0], 0, p[0] - box[2]), max(box[1] - p[1], 0, p[1] - box[3]))
        away = {other: min(map(off, points)) for other, points in curves.items()}
    nearest = min(away, key=lambda other: (away[other], other != look), default=None)
    return nearest if nearest is not None and away[nearest] <= BESIDE else None


def score(page_path, answer, figure):
    page = Page(page_path)
    output = answer["outputs"][0]
    left, top = output["drawing_left_mm"], output["drawing_top_mm"]
    wide, high = output["drawing_width_mm"], output["drawing_height_mm"]
    part = output.get("part_percent", (0, 0, 100, 100))  # of the picture, that is drawn
    place = lambda x, y: (left + wide * (x - part[0]) / (part[2] - part[0]), top + high * (y - part[1]) / (part[3] - part[1]))
    row = dict.fromkeys(COLUMNS, 0) | {"figures": 1, "faults": [], "white": page.white()}
    for number, (look, points) in enumerate(figure.curves):
        total, done = drawn_share(page, [place(*p) for p in points])
        row["curves mm"] += total
        row["drawn"] += done
        if done < 0.9 * total:
            row["faults"].append(f"curve {number} ({look}) {done / total:.2f}")
    for x, y, bx, by in figure.arrows:
        row["arrows"] += 1
        whole = is_whole(page, (place(x, y), place(bx, by)))
        row["whole"] += whole
        if not whole:
            row["faults"].append(f"arrow at {x:.0f} % {y:.0f} %")
    fills = {}
    for look, x0, y0, x1, y1 in figure.bars:
        row["bars"] += 1
        sides = [drawn_share(page, [place(*a), place(*b)]) for a, b in (((x0, y0), (x1, y0)), ((x0, y0), (x0, y1)), ((x1, y0), (x1, y1)),
                                                                     ((x0, y1), (x1, y1)))]
        closed = all(done >= 0.85 * total for total, done in sides)
        row["closed"] += closed
        if not closed:
            row["faults"].append(f"bar at {x0:.0f} % {y0:.0f} %")
        fills.setdefault(look, []).append(page.fill_of(*place(x0, y0), *place(x1, y1)))
    for x, y in figure.points:
        row["points"] += 1
        row["there"] += any(True for _ in page.steps.near(*place(x, y), 3.5))
    one_fill = {look: max(set(found), key=found.count) for look, found in fills.items()}
    if len(fills) > 1:
        row["fills"] = len(fills)
        row["told apart"] = sum(1 for look, found in fills.items() if found.count(one_fill[look]) > 0.8 * len(found)
                                and list(one_fill.values()).count(one_fill[look]) == 1)
    styles = {look: style_at(page, [place(*p) for p in points]) for look, points in figure.curves}
    curves = {}
    for look, points in figure.curves:
        curves.setdefault(look, []).extend(one[:2] for one in along([place(*p) for p in points], 1))
    for look, text, x0, y0, x1, y1 in figure.samples:
        row["samples"] += 1
        named = [named_by(at, look, curves, [(other, *place(a, b), *place(c, d)) for other, a, b, c, d in figure.bars],
                          [(other, [place(*p) for p in points]) for other, points in figure.curves if other.startswith("fill")])
                 for at in page.places_named(text)]
        if look in named:
            row["matched"] += 1
            continue
        if look.startswith("fill"):
            matched = page.fill_at(*place((x0 + x1) / 2, (y0 + y1) / 2)) == one_fill.get(look) and list(one_fill.values()).count(one_fill[look]) == 1
        else:
            style = style_at(page, [place(x0 + (x1 - x0) * k / 10, y0 + (y1 - y0) * k / 10) for k in range(11)])
            matched = style is not None and [styles[other] for other in styles].count(style) == 1 and styles.get(look) == style
        row["matched"] += matched
        misnamed = not matched and any(other is not None for other in named)
        row["misnamed"] += misnamed
        if not matched:
            row["faults"].append(f"{'misnamed' if misnamed else 'sample'} {look}")
    return row


def table(rows):
    """Rows of (maker, form, row) as a table of Markdown."""
    sums = {}
    for maker, form, row in rows:
        for key in ((maker, form), ("all", form)):
            total = sums.setdefault(key, dict.fromkeys(COLUMNS, 0))
            for name in total:
                total[name] += row[name]
    lines = ["| figures of | as | figures | curve length drawn | arrow ends whole | bars closed | points there | fills told apart | legend entries told "
             "| misnamed | white |", "|---|---|---|---|---|---|---|---|---|---|---|"]
    share = lambda total, part, whole: f"{total[part]} of {total[whole]}" if total[whole] else ""
    for (maker, form), t in sorted(sums.items(), key=lambda item: (item[0][1], item[0][0] == "all", item[0][0])):
        length = f"{t['drawn'] / t['curves mm']:.3f}" if t["curves mm"] else ""
        lines.append(f"| {maker} | {form} | {t['figures']} | {length} | " + " | ".join(
            share(t, part, whole) for part, whole in (("whole", "arrows"), ("closed", "bars"), ("there", "points"), ("told apart", "fills"),
                                                      ("matched", "samples"))) + f" | {t['misnamed'] if t['samples'] else ''} | {t['white'] / t['figures']:.2f} |")
    return "\n".join(lines) + "\n"
