# SPDX-License-Identifier: Apache-2.0
"""Graphs of graphviz as chance will have them: layouts, shapes, fonts, words on links, clusters; SVG, SVG by cairo, PNG and PDF."""
import os
import random

import figure
import graphs

NAMES = ["Rain", "River", "Ocean", "Cloud", "Glacier", "Spring", "Lake", "Ground water", "Start", "Read n", "n > 0", "Print", "Stop", "Error 404",
         "Client", "Server", "Data base", "Cache", "Queue", "Mail", "Login", "Iron ore", "Coke", "Steel", "Slag", "Gas", "Furnace", "Mother",
         "Father", "Aunt Ida", "Hugo", "Clara", "Emil", "Egg", "Larva", "Pupa", "Imago", "x + 1", "2 x", "q0", "q1", "q2", "Berlin", "Paris", "Oslo",
         "Rome", "Vienna", "CPU", "RAM", "USB", "Disk 1", "Disk 2", "Fox", "Rabbit", "Grass", "Owl", "Mouse", "Hawk", "Snake", "Verb", "Noun", "S", "NP", "VP"]
LINKS = ["yes", "no", "eats", "flows", "melts", "reads", "12 km", "45", "7", "0.5", "a", "b", "1", "is a", "has", "sends", "ok", "fails", "30 %", "next"]
SHAPES = ["box", "ellipse", "circle", "diamond", "plaintext", "hexagon", "doublecircle", "parallelogram", "house", "cylinder", "note"]
FONTS = [None, "Helvetica", "DejaVu Sans", "DejaVu Serif", "Courier"]
PALE = ["lightgrey", "lightblue", "lightyellow", "palegreen", "mistyrose"]


def node_of(chance, name, shapes):
    shape = chance.choice(shapes)
    more = []
    if chance.random() < 0.2:
        more.append(f'style="filled", fillcolor="{chance.choice(PALE)}"')
    elif shape == "box" and chance.random() < 0.4:
        more.append('style="rounded"')
    label = name.replace(" ", "\\n") if " " in name and name[0].isupper() and chance.random() < 0.4 else name
    settings = ", ".join([f'label="{label}"', f"shape={shape}", *more])
    return label, f'"{name}" [{settings}];'


def graph(chance):
    """Its program, its text, and its words: what stands on one line each."""
    program = chance.choice(["dot", "dot", "dot", "neato", "circo", "twopi", "fdp"])
    directed = chance.random() < 0.75
    names = chance.sample(NAMES, chance.randint(4, 9))
    shapes = chance.sample(SHAPES, chance.choice([1, 1, 1, 2, 3]))
    words, lines = [], []
    font = chance.choice(FONTS)
    size = chance.choice([12, 14, 14, 18])
    for thing in ("graph", "node", "edge"):
        lines.append(f"{thing} [fontsize={size}" + (f', fontname="{font}"' if font else "") + "];")
    if program == "dot" and chance.random() < 0.35:
        lines.append("rankdir=LR;")
    if program in ("neato", "twopi", "fdp"):
        lines.append("overlap=false; splines=true;")  # nodes on nodes nobody can read
    elif chance.random() < 0.15:
        lines.append(f"splines={chance.choice(['line', 'polyline'])};")
    nodes = []
    for name in names:
        label, line = node_of(chance, name, shapes)
        words += label.split("\\n")
        nodes.append(line)
    if program == "dot" and chance.random() < 0.3:
        title = chance.choice(["North", "Inside", "Phase one", "Kitchen"])
        words.append(title)
        cut = len(nodes) // 2
        nodes = ["subgraph cluster_a { " + f'label="{title}"; ' + " ".join(nodes[:cut]) + " }"] + nodes[cut:]
    links = [(names[chance.randrange(i)], names[i]) for i in range(1, len(names))]
    links += [tuple(chance.sample(names, 2)) for _ in range(chance.randint(0, 3))]
    labels = chance.sample(LINKS, len(LINKS))
    head = chance.choice(["normal", "normal", "vee"])
    dashed = chance.random() < 0.25
    colour = chance.choice(["black", "black", "black", "blue", "red3"])
    edges = []
    for a, b in dict.fromkeys(links):
        more = [f"arrowhead={head}", f"color={colour}"]
        if chance.random() < 0.3 and labels:
            words.append(labels.pop())
            more.append(f'label="{words[-1]}"')
        if dashed and chance.random() < 0.4:
            more.append(f"style={chance.choice(['dashed', 'dotted'])}")
        edges.append(f'"{a}" {"->" if directed else "--"} "{b}" [{", ".join(more)}];')
    return program, ("digraph" if directed else "graph") + " {\n" + "\n".join(lines + nodes + edges) + "\n}", words


def drawings(count, seed, folder):
    chance = random.Random(f"graphs {seed}")
    for number in range(count):
        program, text, words = graph(chance)
        yield graphs.laid_out(f"chance-{number}", program, text, words, folder, chance.choice([100, 150, 200]))
