# SPDX-License-Identifier: Apache-2.0
"""Figures of graphviz: SVG with text, SVG by cairo with glyphs, PNG and PDF."""
import html
import os
import re

import figure

GRAPHS = {
    "tree": ("dot", 'digraph { node [shape=box]; Animal -> Bird; Animal -> Fish; Bird -> Owl; Bird -> "Sea gull"; Fish -> Cod }',
             ["Animal", "Bird", "Fish", "Owl", "Sea gull", "Cod"], 5),
    "cycle": ("circo", 'digraph { Egg -> Larva; Larva -> Pupa; Pupa -> Butterfly; Butterfly -> Egg }', ["Egg", "Larva", "Pupa", "Butterfly"],
              4),
    "machine": ("dot", 'digraph { rankdir=LR; node [shape=circle]; q0 -> q1 [label="coin"]; q1 -> q0 [label="push"]; q1 -> q1 [label="again"] }',
                ["q0", "q1", "coin", "push", "again"], 3),
    "network": ("neato", 'graph { layout=neato; Router -- Laptop; Router -- Printer; Router -- Phone; Laptop -- Printer }',
                ["Router", "Laptop", "Printer", "Phone"], 0),
    "records": ("dot", 'digraph { node [shape=record]; a [label="{Student|name|age}"]; b [label="{Course|title|room}"]; a -> b [label="takes"] }',
                ["Student", "name", "age", "Course", "title", "room", "takes"], 1),
    "flow": ("dot", 'digraph { start [shape=ellipse,label="Start"]; read [shape=parallelogram,label="Read n"]; '
             'test [shape=diamond,label="n > 0 ?"]; stop [shape=ellipse,label="Stop"]; start -> read -> test; '
             'test -> stop [label="no"]; test -> read [label="yes"] }', ["Start", "Read n", "n > 0 ?", "Stop", "no", "yes"], 4),
    "clusters": ("dot", 'digraph { label="Trade"; subgraph cluster_a { label="North"; Wool; Iron }; subgraph cluster_b { label="South"; '
                 'style=filled; fillcolor=lightgrey; Wine; Salt }; Wool -> Wine; Iron -> Salt }',
                 ["Trade", "North", "South", "Wool", "Iron", "Wine", "Salt"], 2),
    "web": ("dot", 'digraph { node [shape=plaintext, fontsize=18]; edge [dir=both, arrowtail=odiamond, arrowhead=vee]; Grass -> Rabbit; '
            'Rabbit -> Fox; Grass -> Mouse; Mouse -> Owl; Mouse -> Fox }', ["Grass", "Rabbit", "Fox", "Mouse", "Owl"], 5),
}


def needs():
    return figure.missing("dot")


def places(svg):
    """Middles of its texts in percent, by their text."""
    with open(svg, encoding="utf-8") as file:
        text = file.read()
    width, height = (float(n) for n in re.search(r'viewBox="[\d.]+ [\d.]+ ([\d.]+) ([\d.]+)"', text).groups())
    left, top = (float(n) for n in re.search(r"translate\(([\d.-]+)[ ,]([\d.-]+)\)", text).groups())
    found = re.findall(r'<text [^>]*x="([\d.-]+)" y="([\d.-]+)"[^>]*>([^<]*)</text>', text)
    return {html.unescape(t).replace("\u00a0", " "): (100 * (float(x) + left) / width, 100 * (float(y) + top - 4) / height) for x, y, t in found}


def make(folder, dpi):
    for name, (program, graph, words, heads) in GRAPHS.items():
        stem = os.path.join(folder, "graphviz-" + name)
        files = {"SVG": stem + ".svg", "SVG glyphs": stem + "-cairo.svg", "PNG": stem + ".png", "PDF": stem + ".pdf"}
        for form, kind in (("SVG", "svg"), ("SVG glyphs", "svg:cairo"), ("PNG", "png:cairo"), ("PDF", "pdf")):
            figure.run(program, "-T" + kind, f"-Gdpi={dpi}" if form == "PNG" else "-Gpad=0.1", "-o", files[form], text=graph)
        known = places(files["SVG"])
        yield figure.Figure("graphviz", name, files, [(text, *known.get(text, (None, None))) for text in words], [None] * heads)
