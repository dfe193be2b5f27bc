# SPDX-License-Identifier: Apache-2.0
"""Bar charts of Matplotlib, R and gnuplot as chance will have them: plain, side by side, stacked, histograms, with a line over them or
with whiskers; filled by colours, greys or the hatches of each maker, with and without outlines, upright and lying."""
import chance_charts
import matplotlib_plots
from chance_charts import BOTTOM, HIGH, LEFT, RIGHT, TELL_PLACE, TOP, WIDE, boxes_of, gnuplot_frame, r_numbers, r_texts, run_gnuplot, run_r, save_matplotlib

try:
    import numpy as np
    from matplotlib import pyplot as plt
except ImportError:
    plt = None

CATEGORIES = ["Oak Elm Ash Fir Yew".split(), "Mon Tue Wed Thu Fri".split(), "2019 2020 2021 2022 2023".split(),
              "Rome Oslo Cork Lima Bonn".split(), "Spring Summer Autumn Winter".split()]
SERIES = ["Boys Girls".split(), "Rain Snow Hail".split(), "Coal Gas Wind Sun".split(), "Before After".split(), "Low Middle High".split()]
TITLES = ["Visits of the garden", "Sales by kind", "Trees that were felled", "Hours of work", ""]
AXES = ["Number", "Share in %", "Height in m", "Euros"]
COLOURS = ["#1f77b4", "#ff7f0e", "#2ca02c", "#d62728"], ["#66c2a5", "#fc8d62", "#8da0cb", "#e78ac3"], ["0.2", "0.5", "0.75", "0.95"]
HATCHES = {"Matplotlib": ("//", "\\\\", "xx", "..", "--", "||", "o", "++"), "R": ((10, 45), (20, 45), (10, 135), (20, 0), (12, 90)),
           "gnuplot": (1, 2, 4, 5, 6)}
KINDS = ("plain", "beside", "beside", "stacked", "stacked", "histogram", "line over", "whiskers")


class Chart:
    """What a chart shows; how, each maker says."""

    def __init__(self, chance, maker):
        self.kind = chance.choice(KINDS)
        self.series = chance.choice(SERIES) if self.kind in ("beside", "stacked") else ["one"]
        self.categories = chance.choice(CATEGORIES)
        if self.kind == "histogram":
            self.categories = [str(10 * (i + 1)) for i in range(chance.randint(7, 12))]
        most = chance.choice((20, 50, 90))
        self.values = [[round(chance.uniform(0.25, 1) * most) for _ in self.categories] for _ in self.series]
        if self.kind == "histogram":
            middle, width = chance.uniform(0.3, 0.7) * len(self.categories), chance.uniform(1.5, 3)
            self.values = [[1 + round(most * np.exp(-((i - middle) / width) ** 2)) for i in range(len(self.categories))]]
        self.line = [round(chance.uniform(0.2, 0.9) * most) for _ in self.categories] if self.kind == "line over" else None
        self.hatched = chance.random() < 0.5
        self.fills = chance.sample(HATCHES[maker], len(self.series)) if self.hatched else chance.choice(COLOURS)[:len(self.series)]
        self.outlined = self.hatched or self.fills[0].startswith("0") or self.kind == "histogram" or chance.random() < 0.5
        self.title, self.axis = chance.choice(TITLES), chance.choice(AXES)
        self.lying = self.kind in ("plain", "beside", "stacked") and chance.random() < 0.25
        self.wide = 1.0 if self.kind == "histogram" else chance.choice((0.5, 0.7, 0.8))
        self.grid = chance.random() < 0.25
        self.dpi = chance.choice((100, 150, 200))
        sums = [sum(column) for column in zip(*self.values)]
        self.most = max(sums) if self.kind == "stacked" else max(max(row) for row in self.values + ([self.line] if self.line else []))

    def bars(self):
        """(series, category, across from, across to, from, to) in the chart's own measure; categories are one apart, from 0."""
        count, below = len(self.series), [0] * len(self.categories)
        for one, row in enumerate(self.values):
            for at, value in enumerate(row):
                if self.kind == "beside":
                    left = at - self.wide / 2 + self.wide * one / count
                    yield one, at, left, left + self.wide / count, 0, value
                else:
                    yield one, at, at - self.wide / 2, at + self.wide / 2, below[at], below[at] + value
                    below[at] += value if self.kind == "stacked" else 0

    def top(self):
        """Of the axis: with room for a legend above the bars."""
        return self.most * (1.15 if len(self.series) == 1 or self.lying else 1.4)

    def ticks(self):
        step = next(step for step in (5, 10, 20, 50, 100) if self.top() / step <= 6)
        return list(range(0, int(self.top()) + 1, step))

    def error(self, value):
        return 0.12 * value + 0.02 * self.most


def by_matplotlib(stem, chart):
    shown, axes = plt.subplots(figsize=(WIDE, HIGH))
    for one, (name, fill) in enumerate(zip(chart.series, chart.fills)):
        mine = [bar for bar in chart.bars() if bar[0] == one]
        if chart.hatched:
            painted = {"color": "white", "edgecolor": "black", "hatch": fill}
        else:
            painted = {"color": fill} | ({"edgecolor": "black"} if chart.outlined else {})
        place, size, start = [(b[2] + b[3]) / 2 for b in mine], [b[5] - b[4] for b in mine], [b[4] for b in mine]
        if chart.lying:
            axes.barh(place, size, mine[0][3] - mine[0][2], start, label=name, **painted)
        else:
            errors = {"yerr": [chart.error(v) for v in size], "capsize": 4} if chart.kind == "whiskers" else {}
            axes.bar(place, size, mine[0][3] - mine[0][2], start, label=name, **errors, **painted)
    if chart.line:
        axes.plot(range(len(chart.line)), chart.line, "-", color="black" if chart.hatched else "#8c564b", linewidth=2)
    across, up = (axes.set_yticks, axes.set_xticks) if chart.lying else (axes.set_xticks, axes.set_yticks)
    across(range(len(chart.categories)), chart.categories)
    up(chart.ticks())
    (axes.set_xlim if chart.lying else axes.set_ylim)(0, chart.top())
    (axes.set_xlabel if chart.lying else axes.set_ylabel)(chart.axis)
    axes.set_title(chart.title)
    if chart.grid:
        axes.grid(axis="x" if chart.lying else "y", alpha=0.5)
        axes.set_axisbelow(True)
    if len(chart.series) > 1:
        axes.legend(ncol=1 if chart.lying else len(chart.series), loc="best" if chart.lying else "upper center")

    drawn = save_matplotlib(shown, stem, chart.dpi)
    truth = matplotlib_plots.truth_of(shown, WIDE * chart.dpi, HIGH * chart.dpi)
    plt.close(shown)
    return {"words": drawn, **truth}


def grey(fill):
    return fill if fill.startswith("#") else "#" + f"{round(255 * float(fill)):02x}" * 3


def by_r(stem, chart):
    low, high, count = -0.7, len(chart.categories) - 0.3, len(chart.series)
    limits = (f"c(0, {chart.top()})", f"c({low}, {high})") if chart.lying else (f"c({low}, {high})", f"c(0, {chart.top()})")
    script = [f'plot(NULL, xlim = {limits[0]}, ylim = {limits[1]}, axes = FALSE, xlab = "", ylab = "", xaxs = "i", yaxs = "i")']
    if chart.grid:
        script.append(f"abline({'v' if chart.lying else 'h'} = {r_numbers(chart.ticks())}, col = \"grey80\")")
    if chart.hatched:
        looks = [f'density = {density}, angle = {angle}, col = "black"' for density, angle in chart.fills]
    else:
        looks = [f'col = "{grey(fill)}", border = {chr(34) + "black" + chr(34) if chart.outlined else "NA"}' for fill in chart.fills]
    for one, _, left, right, start, end in chart.bars():
        box = (start, left, end, right) if chart.lying else (left, start, right, end)
        script.append(f"rect({', '.join(f'{v:.4f}' for v in box)}, {looks[one]})")
        if chart.kind == "whiskers":
            middle, off = (left + right) / 2, chart.error(end)
            script.append(f"arrows({middle}, {end - off}, {middle}, {end + off}, angle = 90, code = 3, length = 0.06)")
    if chart.line:
        script.append(f'lines({r_numbers(range(len(chart.line)))}, {r_numbers(chart.line)}, lwd = 2, col = "{"black" if chart.hatched else "#8c564b"}")')
    across, up = (2, 1) if chart.lying else (1, 2)
    script += [f"axis({across}, at = {r_numbers(range(len(chart.categories)))}, labels = {r_texts(chart.categories)}, gap.axis = -1, tick = FALSE)",
               f"axis({up}, at = {r_numbers(chart.ticks())}, gap.axis = -1)",
               f'title(main = "{chart.title}", {"xlab" if chart.lying else "ylab"} = "{chart.axis}")']
    if count > 1:
        if chart.hatched:
            fills = f'density = {r_numbers(f[0] for f in chart.fills)}, angle = {r_numbers(f[1] for f in chart.fills)}, fill = "black"'
        else:
            fills = f"fill = {r_texts(grey(f) for f in chart.fills)}"
        script += [f'made <- legend("{"right" if chart.lying else "top"}", legend = {r_texts(chart.series)}, {fills}, horiz = {"FALSE" if chart.lying else "TRUE"}, bg = "white")',
                   "w <- xinch(par('cin')[1]); h <- yinch(par('cin')[2])",
                   TELL_PLACE,
                   f"for (i in 1:{count}) {{ ndc(made$text$x[i] - 1.8 * w, made$text$y[i] + h / 4); ndc(made$text$x[i] - w, made$text$y[i] - h / 4) }}"]
    swatches, (left, right, bottom, top) = run_r(script, stem, chart.dpi)
    x_of = lambda x: 100 * (left + (right - left) * (x - low) / (high - low))
    y_of = lambda y: 100 - 100 * (bottom + (top - bottom) * y / chart.top())
    if chart.lying:
        x_of, y_of = (lambda x: 100 * (left + (right - left) * x / chart.top())), (lambda y: 100 - 100 * (bottom + (top - bottom) * (y - low) / (high - low)))
    samples = [(f"fill {one}", chart.series[one], *box) for one, box in enumerate(boxes_of(swatches))]
    return {"words": [(str(text), None, None) for text in words_of(chart)], "samples": samples, "title": chart.title, **marks_of(chart, x_of, y_of)}


def by_gnuplot(stem, chart):
    chart.lying = False  # it has no such bars
    low, high = -0.7, len(chart.categories) - 0.3
    script = gnuplot_frame(chart.title, chart.axis) + [
        "set key top center horizontal", "set xtics (" + ", ".join(f'"{name}" {at}' for at, name in enumerate(chart.categories)) + ") scale 0",
        "set ytics (" + ", ".join(str(tick) for tick in chart.ticks()) + ")", f"set style fill {'pattern' if chart.hatched else 'solid 1'} border"]
    script += ["set grid ytics"] if chart.grid else []
    plots = []
    for one, (name, fill) in enumerate(zip(chart.series, chart.fills)):
        script += [f"$d{one} << END"] + [f"{(b[2] + b[3]) / 2} {b[4]} {b[2]} {b[3]} {b[4]} {b[5]}" for b in chart.bars() if b[0] == one] + ["END"]
        colour = "fc rgb 'black'" if chart.hatched else f"fc rgb '{grey(fill)}'"
        style = f"fs pattern {fill} border -1" if chart.hatched else f"fs solid 1 {'border -1' if chart.outlined else 'noborder'}"
        title = f'title "{name}"' if len(chart.series) > 1 else "notitle"
        plots.append(f"$d{one} using 1:2:3:4:5:6 with boxxyerror {title} {colour} {style}")
    if chart.kind == "whiskers":
        script += ["$e << END"] + [f"{(b[2] + b[3]) / 2} {b[5]} {chart.error(b[5])}" for b in chart.bars()] + ["END"]
        plots.append("$e with yerrorbars pt -1 lc rgb 'black' notitle")
    if chart.line:
        script += ["$l << END"] + [f"{at} {value}" for at, value in enumerate(chart.line)] + ["END"]
        plots.append(f"$l with lines lw 2 lc rgb '{'black' if chart.hatched else '#8c564b'}' notitle")
    script.append(f"plot [{low}:{high}] [0:{chart.top()}] " + ", ".join(plots))
    run_gnuplot(script, stem, chart.dpi)
    x_of = lambda x: 100 * (LEFT + (RIGHT - LEFT) * (x - low) / (high - low))
    y_of = lambda y: 100 - 100 * (BOTTOM + (TOP - BOTTOM) * y / chart.top())
    return {"words": [(str(text), None, None) for text in words_of(chart)], "title": chart.title, **marks_of(chart, x_of, y_of)}


def words_of(chart):
    return chart.categories + chart.ticks() + [chart.axis] + ([chart.title] if chart.title else []) + (chart.series if len(chart.series) > 1 else [])


def marks_of(chart, x_of, y_of):
    """Bars, and the line over them or their whiskers, in percent."""
    bars, curves = [], []
    for one, _, left, right, start, end in chart.bars():
        (a, b), (c, d) = ((start, left), (end, right)) if chart.lying else ((left, start), (right, end))
        bars.append((f"fill {one}", x_of(a), y_of(d), x_of(c), y_of(b)))
        if chart.kind == "whiskers":
            off = chart.error(end)
            curves.append(("line", [(x_of((left + right) / 2), y_of(end - off)), (x_of((left + right) / 2), y_of(end + off))]))
    if chart.line:
        curves.append(("line over", [(x_of(at), y_of(value)) for at, value in enumerate(chart.line)]))
    return {"bars": bars, "curves": curves}


def charts(count, seed, folder):
    return chance_charts.figures("bars", Chart, {"Matplotlib": by_matplotlib, "R": by_r, "gnuplot": by_gnuplot}, count, seed, folder)
