# SPDX-License-Identifier: Apache-2.0
"""Figures of graphviz: SVG with text, SVG by cairo with glyphs, PNG and PDF."""
import html
import math
import os
import re

import figure

GRAPHS = {
    "tree": ("dot", 'digraph { node [shape=box]; Animal -> Bird; Animal -> Fish; Bird -> Owl; Bird -> "Sea gull"; Fish -> Cod }',
             ["Animal", "Bird", "Fish", "Owl", "Sea gull", "Cod"]),
    "cycle": ("circo", 'digraph { Egg -> Larva; Larva -> Pupa; Pupa -> Butterfly; Butterfly -> Egg }', ["Egg", "Larva", "Pupa", "Butterfly"]),
    "machine": ("dot", 'digraph { rankdir=LR; node [shape=circle]; q0 -> q1 [label="coin"]; q1 -> q0 [label="push"]; q1 -> q1 [label="again"] }',
                ["q0", "q1", "coin", "push", "again"]),
    "network": ("neato", 'graph { layout=neato; Router -- Laptop; Router -- Printer; Router -- Phone; Laptop -- Printer }',
                ["Router", "Laptop", "Printer", "Phone"]),
    "records": ("dot", 'digraph { node [shape=record]; a [label="{Student|name|age}"]; b [label="{Course|title|room}"]; a -> b [label="takes"] }',
                ["Student", "name", "age", "Course", "title", "room", "takes"]),
    "flow": ("dot", 'digraph { start [shape=ellipse,label="Start"]; read [shape=parallelogram,label="Read n"]; '
             'test [shape=diamond,label="n > 0 ?"]; stop [shape=ellipse,label="Stop"]; start -> read -> test; '
             'test -> stop [label="no"]; test -> read [label="yes"] }', ["Start", "Read n", "n > 0 ?", "Stop", "no", "yes"]),
    "clusters": ("dot", 'digraph { label="Trade"; subgraph cluster_a { label="North"; Wool; Iron }; subgraph cluster_b { label="South"; '
                 'style=filled; fillcolor=lightgrey; Wine; Salt }; Wool -> Wine; Iron -> Salt }',
                 ["Trade", "North", "South", "Wool", "Iron", "Wine", "Salt"]),
    "web": ("dot", 'digraph { node [shape=plaintext, fontsize=18]; edge [dir=both, arrowtail=odiamond, arrowhead=vee]; Grass -> Rabbit; '
            'Rabbit -> Fox; Grass -> Mouse; Mouse -> Owl; Mouse -> Fox }', ["Grass", "Rabbit", "Fox", "Mouse", "Owl"]),
}


def needs():
    return figure.missing("dot")


def places(svg):
    """Its texts with their middles in percent."""
    with open(svg, encoding="utf-8") as file:
        text = file.read()
    width, height = (float(n) for n in re.search(r'viewBox="[\d.]+ [\d.]+ ([\d.]+) ([\d.]+)"', text).groups())
    left, top = (float(n) for n in re.search(r"translate\(([\d.-]+)[ ,]([\d.-]+)\)", text).groups())
    found = re.findall(r'<text [^>]*x="([\d.-]+)" y="([\d.-]+)"[^>]*>([^<]*)</text>', text)
    return [(html.unescape(t).replace("\u00a0", " "), 100 * (float(x) + left) / width, 100 * (float(y) + top - 4) / height) for x, y, t in found]


def numbers(text):
    return [float(n) for n in re.findall(r"-?[\d.]+", text)]


def pairs(values):
    return list(zip(values[::2], values[1::2]))


def spline(points):
    """Beziers one after the other, as points on them."""
    out = [points[0]]
    for i in range(0, len(points) - 3, 3):
        for k in range(1, 13):
            t = k / 12
            weights = ((1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t ** 3)
            out.append(tuple(sum(w * points[i + j][axis] for j, w in enumerate(weights)) for axis in (0, 1)))
    return out


def drawn(svg):
    """Lines and tips of heads that are in it, in percent."""
    with open(svg, encoding="utf-8") as file:
        text = file.read()
    width, height = (float(n) for n in re.search(r'viewBox="[\d.]+ [\d.]+ ([\d.]+) ([\d.]+)"', text).groups())
    left, top = (float(n) for n in re.search(r"translate\(([\d.-]+)[ ,]([\d.-]+)\)", text).groups())
    place = lambda points: figure.in_percent([(x + left, y + top) for x, y in points], width, height)
    curves, arrows = [], []
    for kind, body in re.findall(r'<g id="\w+" class="(node|edge|cluster)">(.*?)</g>', text, re.S):
        line = None
        for path in re.findall(r'<path[^>]* d="M([^"]*)"', body):
            line = spline(pairs(numbers(path)))
            curves.append(("line", place(line)))
        for fill, points in re.findall(r'<polygon fill="(\w+)"[^>]* points="([^"]*)"', body):
            ring = pairs(numbers(points))
            if kind == "edge" and fill not in ("none", "white"):
                end, before = (line[0], line[3]) if math.dist(ring[0], line[0]) < math.dist(ring[0], line[-1]) else (line[-1], line[-4])
                tip = max(ring, key=lambda p: math.dist(p, end))
                arrows.append((*place([tip])[0], *place([before])[0]))
            elif kind != "edge":
                curves.append(("line", place(ring)))
        for points in re.findall(r'<polyline[^>]* points="([^"]*)"', body):
            curves.append(("line", place(pairs(numbers(points)))))
        for cx, cy, rx, ry in re.findall(r'<ellipse[^>]* cx="([-\d.]+)" cy="([-\d.]+)" rx="([-\d.]+)" ry="([-\d.]+)"', body):
            turn = [math.tau * i / 64 for i in range(65)]
            curves.append(("line", place([(float(cx) + float(rx) * math.cos(a), float(cy) + float(ry) * math.sin(a)) for a in turn])))
    return curves, arrows


def laid_out(name, program, graph, words, folder, dpi):
    """`words`: those that must be there, once each or more often; what else its SVG says is a word, too."""
    stem = os.path.join(folder, "graphviz-" + name)
    files = {"SVG": stem + ".svg", "SVG glyphs": stem + "-cairo.svg", "PNG": stem + ".png", "PDF": stem + ".pdf"}
    for form, kind in (("SVG", "svg"), ("SVG glyphs", "svg:cairo"), ("PNG", "png:cairo"), ("PDF", "pdf")):
        figure.run(program, "-T" + kind, "-Gpad=0.1", "-Gmargin=0", *([f"-Gdpi={dpi}"] if form == "PNG" else []), "-o", files[form], text=graph)
    known = places(files["SVG"])
    lacking = [(text, None, None) for text in words if text not in [one[0] for one in known]]
    curves, arrows = drawn(files["SVG"])
    return figure.Figure("graphviz", name, files, known + lacking, arrows, curves)


def make(folder, dpi):
    for name, (program, graph, words) in GRAPHS.items():
        yield laid_out(name, program, graph, words, folder, dpi)
