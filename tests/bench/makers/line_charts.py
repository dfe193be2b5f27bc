# SPDX-License-Identifier: Apache-2.0
"""Line charts of Matplotlib, R and gnuplot as chance will have them: one to four curves, smooth, of a few measurements with or without
marks, noisy, or in steps; told apart by colours, dashes or both; named by a legend, by words at their ends, or not at all."""
import os
import random

import figure
import matplotlib_plots

try:
    import numpy as np
    from matplotlib import pyplot as plt
    from matplotlib.backends import backend_agg
except ImportError:
    plt = None

NAMES = ["North South East West".split(), "Oak Elm Ash Fir".split(), "Men Women All".split(), "Model Measured".split(),
         "Berlin Paris Rome Oslo".split()]
TITLES = ["Growth of the plants", "Price of bread", "Temperature in the lake", "Speed of the runner", ""]
ACROSS = ["Time in s", "Day", "Depth in m", "Dose in mg"]
UP = ["Height in cm", "Euros", "Degrees", "Signal in mV"]
KINDS = ("smooth", "smooth", "series", "series", "marked", "noisy", "steps")
COLOURS = ["#1f77b4", "#ff7f0e", "#2ca02c", "#d62728"], ["#e41a1c", "#377eb8", "#4daf4a", "#984ea3"], ["#000000", "#555555", "#888888", "#aaaaaa"]
DASHES = {"Matplotlib": ("-", "--", ":", "-."), "R": (1, 2, 3, 4), "gnuplot": (1, 2, 3, 4)}
MARKS = {"Matplotlib": ("o", "s", "^", "D"), "R": (16, 15, 17, 18), "gnuplot": (7, 5, 9, 13)}


class Curves:
    """What a chart shows; how, each maker says."""

    def __init__(self, chance, maker):
        self.kind = chance.choice(KINDS)
        self.names = chance.choice(NAMES)[:chance.randint(1, 4) if self.kind != "noisy" else chance.randint(1, 2)]
        self.wide = chance.choice((10, 24, 60))
        number = np.random.default_rng(chance.randint(0, 10**9))
        self.courses = [self.course(number, i) for i in range(len(self.names))]
        low, high = min(y.min() for _, y in self.courses), max(y.max() for _, y in self.courses)
        self.named = chance.choice(("legend", "legend", "ends")) if len(self.names) > 1 else "none"
        room = (high - low) * (0.35 if self.named == "legend" else 0.08)
        self.low, self.high = float(low - 0.08 * (high - low)), float(high + room)
        self.right = self.wide * (1.18 if self.named == "ends" else 1.0)
        paint = chance.choice(("colours", "dashes", "both"))
        colours = chance.choice(COLOURS)
        self.colours = colours if paint != "dashes" else ["#000000"] * 4
        self.dashes = DASHES[maker] if paint != "colours" else [DASHES[maker][0]] * 4
        self.marks = MARKS[maker] if self.kind == "marked" else None
        self.thick = chance.choice((1, 1.5, 2))
        self.grid = chance.random() < 0.3
        self.open = chance.random() < 0.3
        self.title, self.across, self.up = chance.choice(TITLES), chance.choice(ACROSS), chance.choice(UP)
        self.dpi = chance.choice((100, 150, 200))

    def course(self, number, i):
        if self.kind == "smooth":
            x = np.linspace(0, self.wide, 60)
            t = x / self.wide
            shapes = (lambda: 10 * np.sin(2 * np.pi * number.uniform(0.5, 1.6) * t + number.uniform(0, 6)),
                      lambda: 20 / (1 + np.exp(-number.uniform(6, 12) * (t - number.uniform(0.3, 0.7)))) - 8,
                      lambda: 12 * np.exp(-number.uniform(1, 4) * t) - 6 * number.uniform(0, 1))
            return x, shapes[number.integers(3)]() + 7 * i
        if self.kind == "noisy":
            x = np.linspace(0, self.wide, 160)
            return x, np.cumsum(number.normal(0, 1, 160)) + number.normal(0, 0.5, 160) + 18 * i
        count = int(number.integers(6, 13))
        x, y = np.linspace(0, self.wide, count), np.cumsum(number.normal(0, 4, count)) + 8 * i
        if self.kind == "steps":
            return np.repeat(x, 2)[1:], np.repeat(y, 2)[:-1]
        return x, y

    def ticks(self, low, high):
        step = next(step for step in (1, 2, 5, 10, 20, 50, 100) if (high - low) / step <= 6)
        return [step * i for i in range(int(np.ceil(low / step)), int(np.floor(high / step)) + 1)]

    def look(self, i):
        return f"line {self.colours[i]} {self.dashes[i]} {i if self.marks else ''}"


def by_matplotlib(stem, chart):
    drawn = []
    draw_text = backend_agg.RendererAgg.draw_text
    shown, axes = plt.subplots(figsize=(6, 4.5))
    for i, (name, (x, y)) in enumerate(zip(chart.names, chart.courses)):
        axes.plot(x, y, chart.dashes[i], color=chart.colours[i], linewidth=chart.thick, label=name, marker=chart.marks[i] if chart.marks else None)
        if chart.named == "ends":
            axes.text(1.02 * x[-1], y[-1], name, va="center")
    axes.set_xlim(0, chart.right)
    axes.set_ylim(chart.low, chart.high)
    axes.set_xticks(chart.ticks(0, chart.right))
    axes.set_yticks(chart.ticks(chart.low, chart.high))
    axes.set(xlabel=chart.across, ylabel=chart.up, title=chart.title)
    axes.grid(chart.grid)
    if chart.open:
        axes.spines[["top", "right"]].set_visible(False)
    if chart.named == "legend":
        axes.legend(ncol=2, loc="upper center")

    def listen(self, gc, x, y, s, prop, angle, ismath=False, mtext=None):
        box = mtext.get_window_extent(self)
        label = (s.replace("\N{MINUS SIGN}", "-"), 50 * (box.x0 + box.x1) / self.width, 100 - 50 * (box.y0 + box.y1) / self.height)
        if label not in drawn:
            drawn.append(label)
        draw_text(self, gc, x, y, s, prop, angle, ismath, mtext)

    backend_agg.RendererAgg.draw_text = listen
    shown.savefig(stem + ".png", dpi=chart.dpi)
    backend_agg.RendererAgg.draw_text = draw_text
    shown.savefig(stem + ".svg", metadata={"Date": None})
    shown.savefig(stem + ".pdf", metadata={"CreationDate": None})
    shown.set_dpi(chart.dpi)
    truth = matplotlib_plots.truth_of(shown, 6 * chart.dpi, 4.5 * chart.dpi)
    place = lambda points: [(100 * x / (6 * chart.dpi), 100 - 100 * y / (4.5 * chart.dpi)) for x, y in axes.transData.transform(points)]
    plt.close(shown)
    boxes = [sample[2:] for sample in truth["samples"]]
    return {"words": drawn, "title": chart.title, **curves_of(chart, lambda x, y: place([(x, y)])[0], boxes)}


def by_r(stem, chart):
    numbers = lambda values: "c(" + ",".join(f"{v:.4f}" for v in values) + ")"
    texts = lambda values: "c(" + ",".join(f'"{v}"' for v in values) + ")"
    count = len(chart.names)
    script = [f'plot(NULL, xlim = c(0, {chart.right}), ylim = c({chart.low}, {chart.high}), axes = FALSE, xlab = "", ylab = "", xaxs = "i", yaxs = "i")']
    across, up = chart.ticks(0, chart.right), chart.ticks(chart.low, chart.high)
    if chart.grid:
        script.append(f'abline(h = {numbers(up)}, v = {numbers(across)}, col = "lightgray", lty = 3)')
    for i, (x, y) in enumerate(chart.courses):
        script.append(f'lines({numbers(x)}, {numbers(y)}, col = "{chart.colours[i]}", lty = {chart.dashes[i]}, lwd = {chart.thick})')
        if chart.marks:
            script.append(f'points({numbers(x)}, {numbers(y)}, col = "{chart.colours[i]}", pch = {chart.marks[i]})')
        if chart.named == "ends":
            script.append(f'text({1.02 * x[-1]}, {y[-1]}, "{chart.names[i]}", adj = c(0, 0.5))')
    script += [f"axis(1, at = {numbers(across)}, gap.axis = -1)", f"axis(2, at = {numbers(up)}, gap.axis = -1)",
               "" if chart.open else "box()", f'title(main = "{chart.title}", xlab = "{chart.across}", ylab = "{chart.up}")']
    if chart.named == "legend":
        pch = f", pch = {numbers(chart.marks[:count])}" if chart.marks else ""
        script += [f'made <- legend("top", legend = {texts(chart.names)}, col = {texts(chart.colours[:count])}, lty = {numbers(chart.dashes[:count])}, '
                   f'lwd = {chart.thick}, ncol = 2{pch})',
                   "w <- xinch(par('cin')[1]); h <- yinch(par('cin')[2])",
                   "ndc <- function(x, y) cat(grconvertX(x, 'user', 'ndc'), grconvertY(y, 'user', 'ndc'), '')",
                   f"for (i in 1:{count}) {{ ndc(made$text$x[i] - 3 * w, made$text$y[i]); ndc(made$text$x[i] - w, made$text$y[i]) }}"]
    script += ['cat(grconvertX(par("usr")[1:2], "user", "ndc"), grconvertY(par("usr")[3:4], "user", "ndc"))', "invisible(dev.off())"]
    for open_it in (f'svg("{stem}.svg", 6, 4.5)', f'pdf("{stem}.pdf", 6, 4.5)',
                    f'png("{stem}.png", 6 * {chart.dpi}, 4.5 * {chart.dpi}, res = {chart.dpi}, type = "cairo")'):
        *ends, left, right, bottom, top = (float(n) for n in figure.run("Rscript", "-", text="\n".join([open_it] + script)).split())
    boxes = [(100 * a, 100 - 100 * b, 100 * c, 100 - 100 * d) for a, b, c, d in zip(*[iter(ends)] * 4)]
    place = lambda x, y: (100 * (left + (right - left) * x / chart.right), 100 - 100 * (bottom + (top - bottom) * (y - chart.low) / (chart.high - chart.low)))
    return {"words": words_of(chart), "title": chart.title, **curves_of(chart, place, boxes)}


def by_gnuplot(stem, chart):
    left, right, bottom, top = 0.14, 0.95, 0.16, 0.88
    numbers = lambda values: "(" + ", ".join(str(v) for v in values) + ")"
    script = ["set encoding utf8", f"set lmargin at screen {left}", f"set rmargin at screen {right}", f"set bmargin at screen {bottom}",
              f"set tmargin at screen {top}", f'set title "{chart.title}"', f'set ylabel "{chart.up}"', f'set xlabel "{chart.across}"',
              "set key top center maxrows 2", f"set xtics {numbers(chart.ticks(0, chart.right))}", f"set ytics {numbers(chart.ticks(chart.low, chart.high))}"]
    script += ["set grid"] if chart.grid else []
    script += ["set border 3", "set tics nomirror"] if chart.open else []
    plots = []
    for i, (name, (x, y)) in enumerate(zip(chart.names, chart.courses)):
        script += [f"$d{i} << END"] + [f"{a} {b}" for a, b in zip(x, y)] + ["END"]
        how = f"with linespoints pt {chart.marks[i]}" if chart.marks else "with lines"
        title = f'title "{name}"' if chart.named == "legend" else "notitle"
        plots.append(f"$d{i} {how} lc rgb '{chart.colours[i]}' dt {chart.dashes[i]} lw {chart.thick} {title}")
        if chart.named == "ends":
            script.append(f'set label "{name}" at {1.02 * x[-1]},{y[-1]} left')
    script.append(f"plot [0:{chart.right}] [{chart.low}:{chart.high}] " + ", ".join(plots))
    for terminal, ending in (("svg size 600,450", "svg"), (f"pngcairo size {6 * chart.dpi},{int(4.5 * chart.dpi)} fontscale {chart.dpi / 96} linewidth {chart.dpi / 96}", "png"),
                             ("pdfcairo size 6in,4.5in", "pdf")):
        figure.run("gnuplot", text="\n".join([f"set terminal {terminal}", f"set output '{stem}.{ending}'"] + script))
    place = lambda x, y: (100 * (left + (right - left) * x / chart.right), 100 - 100 * (bottom + (top - bottom) * (y - chart.low) / (chart.high - chart.low)))
    return {"words": words_of(chart), "title": chart.title, **curves_of(chart, place, [])}


def words_of(chart):
    ticks = chart.ticks(0, chart.right) + chart.ticks(chart.low, chart.high)
    texts = [str(tick) for tick in ticks] + [chart.across, chart.up] + ([chart.title] if chart.title else []) + (chart.names if chart.named != "none" else [])
    return [(text, None, None) for text in texts]


def curves_of(chart, place, boxes):
    """Curves and the words that name them; without a sample whose place is known they must stand at their curve."""
    curves = [(chart.look(i), [place(a, b) for a, b in zip(x, y)]) for i, (x, y) in enumerate(chart.courses)]
    nowhere = (-50, -50, -50, -50)
    samples = [(chart.look(i), name, *(boxes[i] if i < len(boxes) else nowhere)) for i, name in enumerate(chart.names)] if chart.named != "none" else []
    points = [p for _, course in curves for p in course] if chart.marks else []
    return {"curves": curves, "samples": samples, "points": points}


def charts(count, seed, folder):
    """So many of each maker that is installed."""
    for maker, draw, program in (("Matplotlib", by_matplotlib, None), ("R", by_r, "Rscript"), ("gnuplot", by_gnuplot, "gnuplot")):
        if program and figure.missing(program):
            continue
        chance = random.Random(f"{maker} {seed}")
        for number in range(count):
            stem = os.path.join(folder, f"{maker}-lines-{number}")
            made = draw(stem, Curves(chance, maker))
            yield figure.Figure(maker, f"lines-{number}", {"PNG": stem + ".png", "SVG": stem + ".svg", "PDF": stem + ".pdf"}, **made)
