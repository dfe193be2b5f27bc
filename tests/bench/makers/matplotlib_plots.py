# SPDX-License-Identifier: Apache-2.0
"""Figures of Matplotlib whose lines and fills are hard to bring over, and what is drawn of any figure of it."""
import contextlib

import figure

try:
    import numpy as np
    from matplotlib import patches
    from matplotlib import pyplot as plt
    from matplotlib.backends import backend_agg
except ImportError:
    plt = None


def hatched(_):
    at = np.arange(4)
    plt.bar(at - 0.2, [12, 18, 9, 15], 0.4, label="Boys", color="white", edgecolor="black", hatch="//")
    plt.bar(at + 0.2, [14, 11, 16, 10], 0.4, label="Girls", color="black", edgecolor="black")
    plt.xticks(at, ["Swim", "Run", "Jump", "Row"])
    plt.ylabel("Pupils")
    plt.ylim(0, 24)
    plt.legend()
    plt.title("Sports of a school")


def crossing(_):
    x = np.linspace(0, 10, 120)
    plt.plot(x, 1 + 0.8 * x, label="Oil")
    plt.plot(x, 9 - 0.7 * x, label="Coal")
    plt.plot(x, 5 + 2.5 * np.sin(x * 0.8), label="Sun")
    plt.legend()
    plt.title("Three sources of power")
    plt.xlabel("Year")
    plt.ylabel("Share")


def styles(_):
    x = np.linspace(0, 6, 100)
    for k, style in enumerate(("-", "--", ":", "-.")):
        plt.plot(x, (k + 1) * 2 + np.sin(x + k), "k" + style, label=f"Row {'ABCD'[k]}")
    plt.ylim(0, 13)
    plt.legend(ncol=4)
    plt.title("Four strings")
    plt.xlabel("Metres")


def silhouettes(_):
    axes = plt.gca()
    axes.set_axis_off()
    axes.set_xlim(0, 10)
    axes.set_ylim(0, 7)
    axes.add_patch(patches.Polygon([(1, 1), (1.7, 1), (1.7, 2.2), (3, 2.2), (1.9, 3.4), (2.6, 3.4), (1.35, 5.6), (0.1, 3.4), (0.8, 3.4),
                                    (-0.3, 2.2), (1, 2.2)], color="black"))
    axes.add_patch(patches.Ellipse((5, 3), 2.4, 3.6, color="black"))
    axes.add_patch(patches.Polygon([(7, 1), (9.6, 1), (9.6, 3.4), (8.3, 5), (7, 3.4)], color="black"))
    for x, name in ((1.35, "Fir"), (5, "Egg"), (8.3, "House")):
        axes.text(x, 0.2, name, ha="center")


def heads(_):
    axes = plt.gca()
    axes.set_axis_off()
    axes.set_xlim(0, 10)
    axes.set_ylim(0, 7)
    for style, scale, a, b in (("-|>", 20, (1, 1), (4, 3)), ("->", 20, (9, 1), (6, 3)), ("-|>", 30, (5, 3.4), (5, 6)), ("->", 14, (1, 6), (4, 4.4)),
                               ("-|>", 14, (9, 6), (6, 4.4))):
        axes.annotate("", b, a, arrowprops={"arrowstyle": style, "mutation_scale": scale, "color": "black", "shrinkA": 0, "shrinkB": 0})
    axes.add_patch(patches.Circle((5, 3), 0.35, fill=False))
    plt.title("Forces on a ball")


def outliers(random):
    data = [np.append(random.normal(m, s, 50), extra) for m, s, extra in ((20, 2, [32, 9]), (25, 3, [39]), (31, 2, [20]))]
    plt.boxplot(data, labels=["Red", "Green", "Blue"], flierprops={"marker": "o", "markerfacecolor": "black"},
                whiskerprops={"linestyle": "--"})
    plt.title("Length of leaves")
    plt.ylabel("Millimetres")


def stacked(_):
    at = np.arange(3)
    below = np.zeros(3)
    for name, values, grey in (("Bus", [5, 7, 4], "0.3"), ("Train", [6, 3, 5], "0.6"), ("Bike", [3, 4, 6], "0.9")):
        plt.bar(at, values, 0.6, below, label=name, color=grey, edgecolor="black")
        below += values
    plt.xticks(at, ["May", "June", "July"])
    plt.ylim(0, 21)
    plt.legend(ncol=3)
    plt.title("Ways to work")


def stems(_):
    x = np.arange(1, 8)
    y = np.array([3, 5, 2, 6, 4, 7, 3])
    plt.errorbar(x, y, yerr=0.8, fmt="ko", capsize=5)
    plt.ylim(0, 9)
    plt.title("Seven samples")
    plt.xlabel("Sample")
    plt.ylabel("Grams")


def parabola(_):
    axes = plt.gca()
    axes.set_axis_off()
    axes.set_xlim(-4, 4)
    axes.set_ylim(-3, 7)
    for a, b in (((-3.6, 0), (3.8, 0)), ((0, -2.5), (0, 6.8))):
        axes.annotate("", b, a, arrowprops={"arrowstyle": "-|>", "mutation_scale": 18, "color": "black", "shrinkA": 0, "shrinkB": 0})
    x = np.linspace(-2.9, 2.9, 100)
    plt.plot(x, x * x - 2, "k", linewidth=2)
    plt.plot([-3.5, 3.5], [-1.6, 5.4], "k--")
    for text, at in (("x", (3.6, -0.7)), ("y", (0.5, 6.5)), ("f", (-3, 6))):
        axes.text(*at, text, ha="center", va="center", fontsize=14)


def cells(random, columns, rows):
    """Of a map: polygons that share their crooked borders."""
    corners = {(i, j): (i + random.uniform(-0.22, 0.22), j + random.uniform(-0.22, 0.22)) for i in range(columns + 1) for j in range(rows + 1)}
    ways = {}

    def way(a, b):
        if (b, a) in ways:
            return ways[b, a][::-1]
        if (a, b) not in ways:
            (x0, y0), (x1, y1) = corners[a], corners[b]
            ways[a, b] = [(x0 + t * (x1 - x0) + bend * (y0 - y1), y0 + t * (y1 - y0) + bend * (x1 - x0))
                          for t, bend in zip(np.linspace(0, 1, 9), np.append(np.append(0, random.uniform(-0.09, 0.09, 7)), 0))]
        return ways[a, b]

    for j in range(rows):
        for i in range(columns):
            ring = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
            yield [point for a, b in zip(ring, ring[1:] + ring[:1]) for point in way(a, b)[:-1]]


def a_map(random, columns, rows, colours, edge, names):
    axes = plt.gca()
    axes.set_axis_off()
    axes.set_xlim(-0.5, columns + 0.5)
    axes.set_ylim(-0.5, rows + 0.5)
    for number, cell in enumerate(cells(random, columns, rows)):
        colour = colours[(number % columns + 3 * (number // columns)) % len(colours)]
        axes.add_patch(patches.Polygon(cell, facecolor=colour, edgecolor=edge, linewidth=1))
        if names:
            axes.text(number % columns + 0.5, number // columns + 0.5, names[number], ha="center", va="center", fontsize=9)


def provinces(random):
    a_map(random, 4, 3, ["#e0a0a0", "#90c090", "#f0e080", "#90b0e0", "#e8b878", "#c8a0d8"], "black",
          "Arden Brook Calder Dunmore Eskdale Farrow Glenn Harrow Islay Kelso Lorne Moray".split())
    plt.title("Provinces")


def counties(random):
    plt.gcf().set_facecolor("#b8d8f0")
    a_map(random, 6, 5, ["#c03030", "#30a050", "#e0c020", "#2060c0", "#e07020"], "white", None)


def harvest(random):
    a_map(random, 5, 4, ["#fee0a0", "#f09040", "#a03010"], "black", None)
    plt.legend(handles=[patches.Patch(facecolor=colour, edgecolor="black", label=name)
                        for colour, name in (("#fee0a0", "Little"), ("#f09040", "Some"), ("#a03010", "Much"))], loc="lower center", ncol=3)
    plt.gca().set_ylim(-1, 4.5)
    plt.title("Harvest of rye")


PLOTS = [hatched, crossing, styles, silhouettes, heads, outliers, stacked, stems, parabola, provinces, counties, harvest]


@contextlib.contextmanager
def listening():
    """Each text that is drawn as pixels in it, once: (text, left, top, right, bottom), in percent of the figure."""
    heard = []
    draw_text = backend_agg.RendererAgg.draw_text

    def listen(self, gc, x, y, s, prop, angle, ismath=False, mtext=None):
        box = mtext.get_window_extent(self)
        label = (s, 100 * box.x0 / self.width, 100 - 100 * box.y1 / self.height, 100 * box.x1 / self.width, 100 - 100 * box.y0 / self.height)
        if label not in heard:
            heard.append(label)
        draw_text(self, gc, x, y, s, prop, angle, ismath, mtext)

    backend_agg.RendererAgg.draw_text = listen
    try:
        yield heard
    finally:
        backend_agg.RendererAgg.draw_text = draw_text


def middles_of(heard):
    return [(text, (left + right) / 2, (top + bottom) / 2) for text, left, top, right, bottom in heard]


def look_of(artist):
    fill = getattr(artist, "get_hatch", lambda: None)()
    if fill is not None or hasattr(artist, "get_facecolor"):
        return f"fill {[round(c, 2) for c in artist.get_facecolor()]} {fill}"
    return f"line {artist.get_color()} {artist.get_linestyle()}"


def truth_of(plot, wide, high):
    """Members of Figure, of a figure that has been drawn, so many pixels large."""
    truth = {"arrows": [], "curves": [], "bars": [], "points": [], "samples": [], "title": plot.axes[0].get_title()}
    place = lambda points: [(100 * x / wide, 100 - 100 * y / high) for x, y in points]
    for axes in plot.axes:
        for line in axes.lines:
            at = place(line.get_transform().transform(line.get_xydata()))
            if line.get_linestyle() != "None" and len(at) > 1:
                truth["curves"].append((look_of(line), at))
            elif line.get_marker() in ("o", "."):
                truth["points"] += at
        for group in axes.collections:
            if hasattr(group, "get_segments"):
                truth["curves"] += [("line", place(axes.transData.transform(one))) for one in group.get_segments()]
            else:
                truth["points"] += place(group.get_offset_transform().transform(group.get_offsets()))
        for patch in axes.patches:
            ring = place(patch.get_transform().transform_path(patch.get_path()).to_polygons()[0])
            if isinstance(patch, patches.Rectangle):
                xs, ys = [x for x, _ in ring], [y for _, y in ring]
                truth["bars"].append((look_of(patch), min(xs), min(ys), max(xs), max(ys)))
            else:
                truth["curves"].append((look_of(patch) if axes.get_legend() else "line", ring))
        for words in axes.texts:
            arrow = getattr(words, "arrow_patch", None)
            if arrow is None:
                continue
            paths, _ = arrow._get_path_in_displaycoord()  # pylint: disable=protected-access
            shaft = place(paths[0].vertices)
            tip = place(paths[1].vertices)[1] if len(paths) > 1 else shaft[-1]
            truth["arrows"].append((*tip, *shaft[0]))
            truth["curves"].append(("line", [shaft[0], tip]))
        legend = axes.get_legend()
        for handle, words in zip(legend.legendHandles, legend.get_texts()) if legend else []:
            if hasattr(handle, "get_xydata"):
                (x0, y0), (x1, y1) = place(handle.get_transform().transform(handle.get_xydata())[[0, -1]])
            else:
                box = handle.get_window_extent()
                (x0, y1), (x1, y0) = place([(box.x0, box.y0), (box.x1, box.y1)])
            truth["samples"].append((look_of(handle), words.get_text(), x0, y0, x1, y1))
    return truth
