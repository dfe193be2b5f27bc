# SPDX-License-Identifier: Apache-2.0
"""Figures of R: SVG by its cairo device, which draws letters as glyphs, PNG and PDF."""
import glob
import os

import figure


def needs():
    return figure.missing("Rscript")


def make(folder, dpi):
    figure.run("Rscript", os.path.join(os.path.dirname(__file__), "r_figures.R"), folder, str(dpi))
    for path in sorted(glob.glob(os.path.join(folder, "R-*.truth"))):
        stem = path.removesuffix(".truth")
        made = figure.Figure("R", os.path.basename(stem).removeprefix("R-"),
                             {"SVG glyphs": stem + ".svg", "PNG": stem + ".png", "PDF": stem + ".pdf"})
        with open(path, encoding="utf-8") as file:
            for line in file.read().splitlines():
                kind, x, y, text = line.split("\t")
                x, y = float(x), float(y)
                places = [tuple(map(float, place.split(","))) for place in text.split() if "," in place] if kind not in ("word", "title") else []
                if kind == "word":
                    made.words.append((text, x, y))
                elif kind == "title":
                    made.title = text
                elif kind == "arrow":
                    made.arrows.append((x, y, *places[0]))
                elif kind == "bar":
                    made.bars.append((text.split()[0], x, y, *places[0]))
                elif kind == "point":
                    made.points.append((x, y))
                else:
                    made.curves.append((text.split()[0], places))
        yield made
