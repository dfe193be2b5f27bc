# SPDX-License-Identifier: Apache-2.0
"""Figures of textbooks as chance will have them, set by LaTeX: circuitikz, tkz-euclide, pgfplots, automata, trees, commutative diagrams.

What is drawn and said comes from here; how it looks, from those packages. Places of words are those of pdftotext.
"""
import html
import math
import os
import random
import re
import sys

import figure

WIDE, HIGH = 12, 9  # cm
FONTS = [r"\usepackage{lmodern}", r"\usepackage{lmodern}", r"\usepackage{mathptmx}", r"\usepackage{helvet}\usepackage{sansmath}\sansmath\renewcommand{\familydefault}{\sfdefault}",
         r"\usepackage{lmodern}\renewcommand{\familydefault}{\sfdefault}", r"\usepackage{mathpazo}"]
LIBRARIES = r"\usetikzlibrary{automata,positioning,arrows.meta,patterns,shapes.geometric,trees,cd}"
COLOURS = ["black", "black", "blue", "red!80!black", "green!50!black"]


class Sheet:
    """Collects the lines of a picture, and what is said in it."""

    def __init__(self):
        self.lines, self.words, self.arrows, self.title = [], [], [], ""

    def put(self, line):
        self.lines.append(line)

    def say(self, text):
        self.words.append(text)
        return tex(text)

    def arrow(self, x0, y0, x1, y1, settings="->"):
        self.put(rf"\draw[{settings}] ({x0:.3f},{y0:.3f}) -- ({x1:.3f},{y1:.3f});")
        length = math.hypot(x1 - x0, y1 - y0)
        back = (x1 - (x1 - x0) / length * min(.5, length / 2), y1 - (y1 - y0) / length * min(.5, length / 2))
        self.arrows.append((*percent(x1, y1), *percent(*back)))


def percent(x, y):
    return 100 * x / WIDE, 100 - 100 * y / HIGH


SIGNS = {"α": r"\alpha", "ε": r"\varepsilon", "π": r"\pi", "φ": r"\varphi", "Ω": r"\Omega", "µ": r"\mu{}", "°": r"^\circ",
         "₀": "_0", "₁": "_1", "₂": "_2", "₃": "_3"}


def tex(text):
    """Letters alone and signs are mathematics; words and numbers are not."""
    if len(text) == 1 or any(sign in text for sign in SIGNS) or "=" in text:
        return "$" + re.sub(r"(?<=[0-9 ])([a-zA-Z]+)\b", r"\\mathrm{\1}", "".join(SIGNS.get(c, c) for c in text)).replace(" ", r"\ ") + "$"
    return text.replace("%", r"\%")


RESISTORS = ["R", "R₁", "R₂", "R₃", "100 Ω", "47 Ω", "R = 10 Ω"]
PARTS = {"R": RESISTORS, "L": ["L", "L₁", "5 mH"], "C": ["C", "C₁", "C₂", "10 µF"], "lamp": ["H", "lamp"], "D": ["D", "D₁"], "voltmeter": ["V"], "ammeter": ["A"],
         "switch": ["S", "S₁"], "short": [None]}


def circuit(s, chance):
    style = chance.choice(["european", "american"])
    s.put(rf"\ctikzset{{{style}}}")
    left, bottom, right, top = 2, 1.5, 10, 7
    said = set()

    def part(kinds):
        kind = chance.choice(kinds)
        free = [n for n in PARTS[kind] if n is None or n not in said]
        name = chance.choice(free) if free else None
        if name:
            said.add(name)
        if kind in ("voltmeter", "ammeter"):
            s.say("V" if kind == "voltmeter" else "A")  # stands in its ring
            return kind
        current = f", i=${s.say('I₁')[1:-1]}$" if kind == "R" and "I₁" not in said and chance.random() < .3 else ""
        said.update({"I₁"} if current else ())
        return kind + (f", l={{{s.say(name)}}}" if name else "") + current

    source = chance.choice(["battery1", "V", "I"] if style == "american" else ["battery1", "battery"])
    voltage = chance.choice(["U", "U₀", "9 V"])
    s.put(rf"\draw ({left},{bottom}) to[{source}, l={{{s.say(voltage)}}}] ({left},{top}) to[{part(['R', 'L', 'switch', 'D'])}] (6,{top})"
          rf" to[{part(['R', 'ammeter', 'lamp', 'short'])}] ({right},{top}) to[{part(['R', 'C', 'lamp', 'L'])}] ({right},{bottom}) to[{part(['short', 'switch', 'R'])}] (6,{bottom})"
          rf" to[short] ({left},{bottom});")
    if chance.random() < .7:
        s.put(rf"\draw (6,{top}) to[{part(['R', 'C', 'voltmeter'])}, *-*] (6,{bottom});")
    if chance.random() < .4:
        s.put(rf"\draw ({left},{bottom}) node[ground] {{}};")


def euclid(s, chance):
    """A triangle with what schools draw in it."""
    a, b, c = (1.5, 1.5), (chance.uniform(9, 10.5), chance.uniform(1.2, 2.4)), (chance.uniform(3, 8), chance.uniform(6.4, 7.6))
    for name, (x, y) in zip("ABC", (a, b, c)):
        s.put(rf"\tkzDefPoint({x:.2f},{y:.2f}){{{name}}}")
    s.put(r"\tkzDrawPolygon(A,B,C)")
    s.put(r"\tkzLabelPoint[below left](A){%s}\tkzLabelPoint[below right](B){%s}\tkzLabelPoint[above](C){%s}" % tuple(s.say(n) for n in "ABC"))
    if chance.random() < .5:
        s.put(r"\tkzDrawPoints(A,B,C)")
    more = chance.choice(["altitude", "median", "circle", None])
    if more not in ("altitude", "median") and chance.random() < .8:
        sides = chance.choice([("a", "b", "c"), ("5 cm", "7 cm", "8 cm"), ("3.6", "4.8", "6")])
        s.put(r"\tkzLabelSegment[right=2mm](B,C){%s}\tkzLabelSegment[left=2mm](A,C){%s}\tkzLabelSegment[below=1mm](A,B){%s}" % tuple(s.say(n) for n in sides))
    if chance.random() < .6:
        s.put(r"\tkzMarkAngle[size=1](B,A,C)\tkzLabelAngle[pos=1.5](B,A,C){%s}" % s.say(chance.choice(["α", f"{round(angle(a, b, c))}°"])))
    if more == "altitude":
        s.put(r"\tkzDefPointBy[projection=onto A--B](C)\tkzGetPoint{H}\tkzDrawSegment[dashed](C,H)\tkzMarkRightAngle(C,H,A)\tkzLabelPoint[below](H){%s}" % s.say("H"))
    elif more == "median":
        s.put(r"\tkzDefMidPoint(A,B)\tkzGetPoint{M}\tkzDrawSegment[dashed](C,M)\tkzMarkSegments[mark=||](A,M M,B)\tkzLabelPoint[below=2mm](M){%s}" % s.say("M"))
    elif more == "circle":
        s.put(r"\tkzDefCircle[in](A,B,C)\tkzGetPoints{I}{T}\tkzDrawCircle(I,T)\tkzDrawPoint(I)\tkzLabelPoint[above](I){%s}" % s.say("I"))


def angle(at, one, two):
    ways = [math.atan2(p[1] - at[1], p[0] - at[0]) for p in (one, two)]
    return math.degrees(abs(ways[0] - ways[1]))


def plot(s, chance):
    """Functions in axes of pgfplots, in one of its styles."""
    middle = chance.random() < .5
    texts = chance.choice([("x", "y"), ("t", "v"), ("Time in s", "Speed in m/s"), ("Year", "Income"), ("Depth in m", "Light in %")])
    count = chance.choice([1, 2, 2, 3])
    names = chance.sample(["Linear", "Square", "Model", "Data", "Sun", "Shade", "North", "South"], count)
    legend = count > 1
    settings = ["at={(1.8cm,1.5cm)}", "scale only axis", "width=9.4cm", "height=6.3cm", f"xlabel={{{s.say(texts[0])}}}", f"ylabel={{{s.say(texts[1])}}}", "xmin=0", "xmax=5", "ymin=0", "ymax=20",
                "xtick={0,1,...,5}" if not middle else "xtick={1,2,...,4}", "ytick={0,5,...,20}" if not middle else "ytick={5,10,15}"]
    if middle:
        settings.append("axis lines=middle")
    if chance.random() < .4:
        settings.append("grid=major")
    if chance.random() < .4 and not middle:
        s.title = chance.choice(["Growth of a plant", "Two runs", "Measured values"])
        settings.append(f"title={{{s.say(s.title)}}}")
    for text in ("1 2 3 4 5 10 15" if middle else "0 1 2 3 4 5 0 5 10 15 20").split():
        s.words.append(text)
    settings.append(f"legend pos={chance.choice(['north west', 'south east', 'north east'])}")
    s.put(rf"\begin{{axis}}[{', '.join(settings)}]")
    marks = chance.choice(["mark=none", "only marks", ""])
    shapes = chance.sample(["2*x+3", "0.7*x^2", "18-3*x", "10+6*sin(80*x)"], count)
    for name, shape in zip(names, shapes):
        s.put(rf"\addplot+[{marks + ',' if marks else ''} domain=0.3:4.5, samples={40 if marks == 'mark=none' else 9}{', thick' if chance.random() < .5 else ''}] {{{shape}}};")
        if legend:
            s.put(rf"\addlegendentry{{{s.say(name)}}}")
    s.put(r"\end{axis}")


def columns(s, chance):
    """Bars of pgfplots."""
    groups = chance.sample(["Oak", "Beech", "Pine", "Ash", "Elm", "Birch"], chance.randint(3, 5))
    series = chance.choice([1, 2])
    patterned = chance.random() < .3
    settings = ["at={(1.8cm,1.5cm)}", "scale only axis", "width=9.4cm", "height=6.3cm", "ybar", "ymin=0", "ymax=50", "ytick={0,10,...,50}", f"symbolic x coords={{{','.join(groups)}}}", "xtick=data",
                f"ylabel={{{s.say(chance.choice(['Trees', 'Height in m', 'Share in %']))}}}", "enlarge x limits=0.2", "legend pos=north east",
                f"bar width={chance.choice([10, 14])}pt"]
    for group in groups:
        s.words.append(group)
    for text in "0 10 20 30 40 50".split():
        s.words.append(text)
    near = series == 1 and chance.random() < .4
    if near:
        settings.append("nodes near coords")
    s.put(rf"\begin{{axis}}[{', '.join(settings)}]")
    for i in range(series):
        values = [chance.choice([v for v in range(8, 43) if v % 10]) for _ in groups]
        for value in values if near else ():
            s.words.append(str(value))
        s.put(rf"\addplot{'[pattern=' + ['north east lines', 'dots'][i] + ']' if patterned else ''} coordinates {{{' '.join(f'({g},{v})' for g, v in zip(groups, values))}}};")
        if series == 2:
            s.put(rf"\addlegendentry{{{s.say(['2010', '2020'][i])}}}")
    s.put(r"\end{axis}")


def automaton(s, chance):
    """States, links with letters, loops."""
    count = chance.choice([3, 4])
    places = [(2, 5.5), (6, 7), (10, 5.5), (6, 2.5)][:count]
    names = chance.choice([["q₀", "q₁", "q₂", "q₃"], ["A", "B", "C", "D"], ["0", "1", "2", "3"]])
    tip = chance.choice(["->", "-Latex", "-Stealth"])
    s.put(rf"\tikzset{{every edge/.append style={{{tip}, {chance.choice(['', 'thick'])}}}}}")
    for i, (x, y) in enumerate(places):
        s.put(rf"\node[state{', initial, initial text=' if i == 0 else ''}{', accepting' if i == count - 1 else ''}] (n{i}) at ({x},{y}) {{{s.say(names[i])}}};")
    letters = chance.choice([["0", "1"], ["a", "b", "c"], ["x", "y", "ε"]])
    for i in range(count):
        s.put(rf"\path (n{i}) edge[bend left] node[auto] {{{s.say(chance.choice(letters))}}} (n{(i + 1) % count});")
    if chance.random() < .7:
        i = chance.randrange(count)
        side = ["below", "above", "right", "below"][i]
        s.put(rf"\path (n{i}) edge[loop {side}] node {{{s.say(chance.choice(letters))}}} (n{i});")


def slope(s, chance):
    """Arrows with names from one place, in axes or on a block."""
    tip = chance.choice(["-{Latex[length=3mm]}", "->", "-Stealth", "-{Triangle}"])
    thick = chance.choice(["", "thick", "very thick"])
    s.put(rf"\draw[{chance.choice(COLOURS)}, fill={chance.choice(['none', 'gray!20', 'blue!10'])}] (5,3.5) rectangle (7,4.7);")
    s.put(rf"\draw[pattern={chance.choice(['north east lines', 'north west lines'])}] (1.5,3.1) rectangle (10.5,3.5);")
    names = chance.sample(["F", "v", "N", "a", "F₁", "F₂", "G", "20 N", "Friction"], 3)
    for name, (x0, y0, x1, y1), anchor in zip(names, [(7, 4.1, 9.8, 4.1), (6, 4.7, 6, 7.6), (5, 4.1, 2.4, 4.1)], ["above", "right", "above"]):
        s.arrow(x0, y0, x1, y1, ",".join(filter(None, [tip, thick])))
        s.put(rf"\node[{anchor}] at ({x1:.2f},{y1:.2f}) {{{s.say(name)}}};")
    if chance.random() < .5:
        s.put(rf"\draw[dashed] (6,4.1) -- (6,1); \node[below] at (6,1) {{{s.say('m')}}};")


def unit_circle(s, chance):
    turn = chance.choice([30, 40, 50, 60, 125, 140])
    x, y = 6 + 3.2 * math.cos(math.radians(turn)), 4.5 + 3.2 * math.sin(math.radians(turn))
    s.arrow(1.5, 4.5, 10.5, 4.5)
    s.arrow(6, .5, 6, 8.6)
    s.put(rf"\node[below] at (10.4,4.4) {{{s.say('x')}}}; \node[right] at (6.1,8.5) {{{s.say('y')}}};")
    s.put(rf"\draw[{chance.choice(['', 'thick'])}] (6,4.5) circle (3.2);")
    s.put(rf"\draw[{chance.choice(COLOURS)}, thick] (6,4.5) -- ({x:.3f},{y:.3f}); \fill ({x:.3f},{y:.3f}) circle (2pt);")
    s.put(rf"\draw[dashed] ({x:.3f},{y:.3f}) -- ({x:.3f},4.5);")
    s.put(rf"\node[{'above right' if turn < 90 else 'above left'}] at ({x:.2f},{y:.2f}) {{{s.say('P')}}};")
    s.put(rf"\draw (7,4.5) arc (0:{turn}:1); \node at ({6 + 1.5 * math.cos(math.radians(turn / 2)):.2f},{4.5 + 1.5 * math.sin(math.radians(turn / 2)):.2f}) "
          rf"{{{s.say(chance.choice(['α', 'φ', f'{turn}°']))}}};")
    s.put(rf"\node[below left] at (6,4.5) {{{s.say(chance.choice(['0', 'O']))}}}; \node[below right] at (9.15,4.45) {{{s.say('1')}}};")


def family(s, chance):
    """A tree of TikZ."""
    names = chance.sample(["Animals", "Birds", "Fish", "Owl", "Eagle", "Carp", "Plants", "Trees", "Herbs", "Moss", "Root", "Fern", "Living things", "Sea", "Land"], 7)
    node = chance.choice(["", "every node/.style={draw, rounded corners, inner sep=5pt}", "every node/.style={draw, ellipse}", "every node/.style={draw, fill=yellow!20}"])
    edge = chance.choice(["", "edge from parent/.style={draw, ->}", "edge from parent/.style={draw, -Latex}"])
    settings = ", ".join(filter(None, ["level distance=25mm", "level 1/.style={sibling distance=58mm}", "level 2/.style={sibling distance=29mm}", node, edge]))
    child = lambda name, below="": rf"child {{node {{{s.say(name)}}} {below}}}"
    lower = [child(n) for n in names[3:]]
    s.put(rf"\begin{{scope}}[{settings}]\node at (6,7.5) {{{s.say(names[0])}}} {child(names[1], lower[0] + lower[1])} {child(names[2], lower[2] + lower[3])};\end{{scope}}")


def commuting(s, chance):
    """A square of maps."""
    names = chance.choice([("A", "B", "C", "D"), ("X", "Y", "Z", "W"), ("G", "H", "K", "L")])
    maps = chance.sample(["f", "g", "h", "k", "φ", "π", "p", "q"], 4)
    n = [s.say(x)[1:-1] for x in names]
    m = [s.say(x)[1:-1] for x in maps]
    scale, apart = chance.choice([1.5, 2]), chance.choice(["huge", "large"])
    links = [rf'\arrow[{way}, "{name}"{side}]' for way, name, side in zip("rddr", m, ("", "'", "", "'"))]
    s.put(rf"\node[scale={scale}] at (6,4.5) {{\begin{{tikzcd}}[sep={apart}, ampersand replacement=\&] {n[0]} {links[0]} {links[1]} \& {n[1]} {links[2]} \\ "
          rf"{n[2]} {links[3]} \& {n[3]} \end{{tikzcd}}}};")


def venn(s, chance):
    colours = chance.sample(["red", "blue", "green", "yellow"], 2)
    opacity = chance.choice([None, .3, .2])
    for x, colour in zip((4.6, 7.4), colours):
        s.put(rf"\draw[{f'fill={colour}, fill opacity={opacity}' if opacity else ''}] ({x},4.5) circle (2.5);")
    names = chance.choice([("A", "B"), ("Birds", "Swimmers"), ("Even", "Prime")])
    for x, name in zip((3, 9), names):
        s.put(rf"\node at ({x},7.4) {{{s.say(name)}}};")
    for x, text in zip((3.4, 6, 8.6), chance.sample(["2", "3", "5", "12", "17", "Duck", "Owl", "Seal", "a", "b"], 3)):
        s.put(rf"\node at ({x},4.5) {{{s.say(text)}}};")


def flow(s, chance):
    """Steps in boxes, a question in a rhombus."""
    steps = chance.sample(["Start", "Read x", "Add 1", "Print", "Wash", "Rinse", "Dry", "Fold", "Measure", "Save"], 3)
    tip = chance.choice(["->", "-Latex", "-Stealth"])
    box = "draw, minimum width=26mm, minimum height=9mm" + chance.choice(["", ", fill=blue!10", ", rounded corners"])
    s.put(rf"\node[{box}] (a) at (4,8) {{{s.say(steps[0])}}}; \node[{box}] (b) at (4,6) {{{s.say(steps[1])}}};")
    question = chance.choice(["Full?", "Clean?", "Done?"])
    s.put(rf"\node[draw, diamond, aspect=1.8, inner sep=1pt] (c) at (4,3.5) {{{s.say(question)}}}; \node[{box}] (d) at (4,1) {{{s.say(steps[2])}}};")
    s.put(rf"\draw[{tip}] (a) -- (b); \draw[{tip}] (b) -- (c); \draw[{tip}] (c) -- node[right] {{{s.say('yes')}}} (d);")
    s.put(rf"\draw[{tip}] (c.east) -- node[above] {{{s.say('no')}}} (9,3.5) |- (b.east);")


KINDS = [circuit, euclid, plot, columns, automaton, slope, unit_circle, family, commuting, venn, flow]


def page_of(sheet, font, size):
    return "\n".join([rf"\documentclass[{size}pt,border=0pt]{{standalone}}", r"\usepackage[T1]{fontenc}", r"\usepackage[utf8]{inputenc}", r"\usepackage{amsmath}", font,
                      r"\usepackage{circuitikz}", r"\usepackage{pgfplots}", r"\pgfplotsset{compat=1.18}", r"\usepackage{tkz-euclide}", LIBRARIES,
                      r"\begin{document}\begin{tikzpicture}", rf"\path[use as bounding box] (0,0) rectangle ({WIDE},{HIGH});", r"\small" if size == 10 else ""]
                     + sheet.lines + [r"\end{tikzpicture}\end{document}"])


def places_of(pdf, words):
    """Of each word its middle in percent, as pdftotext finds it; what it parts or joins is looked for in runs."""
    text = figure.run("pdftotext", "-bbox", pdf, "-")
    wide, high = (float(n) for n in re.search(r'<page width="([\d.]+)" height="([\d.]+)"', text).groups())
    found = [(html.unescape(t), *(float(n) for n in box)) for *box, t in
             re.findall(r'<word xMin="([\d.-]+)" yMin="([\d.-]+)" xMax="([\d.-]+)" yMax="([\d.-]+)">([^<]*)</word>', text)]
    plain = lambda t: re.sub(r"\s", "", t.translate(str.maketrans("₀₁₂₃²◦µϕϵ−", "01232°μφε-")))
    places = {}
    for number in sorted(range(len(words)), key=lambda n: -len(words[n])):  # the R of "R₁" is none
        wanted = plain(words[number])
        runs = ((i, j) for i in range(len(found)) for j in range(i + 1, min(i + 4, len(found)) + 1))
        hit = next(((i, j) for i, j in runs if plain("".join(f[0] for f in found[i:j])) == wanted), None)
        places[number] = (words[number], None, None)
        if hit:
            run = found[hit[0]:hit[1]]
            places[number] = (words[number], 50 * (min(f[1] for f in run) + max(f[3] for f in run)) / wide,
                              50 * (min(f[2] for f in run) + max(f[4] for f in run)) / high)
            del found[hit[0]:hit[1]]
    return [places[n] for n in range(len(words))]


def files_of(stem, text, dpi, folder):
    """As people make them of TeX: with letters as text through DVI, as shapes and as outlines from the PDF, and as pixels."""
    with open(stem + ".tex", "w", encoding="utf-8") as file:
        file.write(text)
    with open(stem + "-dvi.tex", "w", encoding="utf-8") as file:
        file.write("\\def\\pgfsysdriver{pgfsys-dvisvgm.def}" + text.replace("documentclass[", "documentclass[dvisvgm,"))
    run = ("-interaction=nonstopmode", "-halt-on-error", "-output-directory", folder)
    figure.run("pdflatex", *run, stem + ".tex")
    figure.run("latex", *run, stem + "-dvi.tex")
    files = {"PDF": stem + ".pdf", "PNG": stem + ".png", "SVG": stem + ".svg", "SVG glyphs": stem + "-glyphs.svg", "SVG outlines": stem + "-outlines.svg"}
    figure.run("dvisvgm", "--bbox=papersize", "--font-format=woff2", "--output=" + files["SVG"], stem + "-dvi.dvi")
    figure.run("dvisvgm", "--pdf", "--output=" + files["SVG outlines"], files["PDF"])
    figure.run("pdftocairo", "-svg", files["PDF"], files["SVG glyphs"])
    figure.run("pdftoppm", "-r", str(dpi), "-png", "-singlefile", files["PDF"], stem)
    return files


def needs():
    return figure.missing("pdflatex", "latex", "pdftotext", "pdftoppm", "pdftocairo", "dvisvgm")


def drawings(count, seed, folder):
    lacks = needs()
    if lacks:
        sys.exit(f"figures: LaTeX sets these; {lacks} is not installed")
    for number in range(count):
        chance = random.Random(f"tex {seed} {number}")
        kind = KINDS[number % len(KINDS)]
        sheet = Sheet()
        font, size, dpi = chance.choice(FONTS), chance.choice([10, 11, 12]), chance.choice([100, 150, 200])
        kind(sheet, chance)
        stem = os.path.join(folder, f"tex-{kind.__name__}-{number}")
        yield figure.Figure("TeX", f"{kind.__name__}-{number}", files_of(stem, page_of(sheet, font, size), dpi, folder),
                            places_of(stem + ".pdf", sheet.words), sheet.arrows, title=sheet.title)
