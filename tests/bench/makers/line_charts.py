# SPDX-License-Identifier: Apache-2.0
"""Line charts of Matplotlib, R and gnuplot as chance will have them: one to four curves, smooth, of a few measurements with or without
marks, noisy, or in steps; told apart by colours, dashes or both; named by a legend, by words at their ends, or not at all."""
import chance_charts
import matplotlib_plots
from chance_charts import BOTTOM, HIGH, LEFT, RIGHT, TELL_PLACE, TOP, WIDE, boxes_of, gnuplot_frame, r_numbers, r_texts, run_gnuplot, run_r, save_matplotlib

try:
    import numpy as np
    from matplotlib import pyplot as plt
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
    shown, axes = plt.subplots(figsize=(WIDE, HIGH))
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

    drawn = save_matplotlib(shown, stem, chart.dpi)
    truth = matplotlib_plots.truth_of(shown, WIDE * chart.dpi, HIGH * chart.dpi)
    pixel = lambda x, y: axes.transData.transform([(x, y)])[0]
    place = lambda x, y: (100 * pixel(x, y)[0] / (WIDE * chart.dpi), 100 - 100 * pixel(x, y)[1] / (HIGH * chart.dpi))
    plt.close(shown)
    return {"words": drawn, "title": chart.title, **curves_of(chart, place, [sample[2:] for sample in truth["samples"]])}


def by_r(stem, chart):
    count = len(chart.names)
    script = [f'plot(NULL, xlim = c(0, {chart.right}), ylim = c({chart.low}, {chart.high}), axes = FALSE, xlab = "", ylab = "", xaxs = "i", yaxs = "i")']
    across, up = chart.ticks(0, chart.right), chart.ticks(chart.low, chart.high)
    if chart.grid:
        script.append(f'abline(h = {r_numbers(up)}, v = {r_numbers(across)}, col = "lightgray", lty = 3)')
    for i, (x, y) in enumerate(chart.courses):
        script.append(f'lines({r_numbers(x)}, {r_numbers(y)}, col = "{chart.colours[i]}", lty = {chart.dashes[i]}, lwd = {chart.thick})')
        if chart.marks:
            script.append(f'points({r_numbers(x)}, {r_numbers(y)}, col = "{chart.colours[i]}", pch = {chart.marks[i]})')
        if chart.named == "ends":
            script.append(f'text({1.02 * x[-1]}, {y[-1]}, "{chart.names[i]}", adj = c(0, 0.5))')
    script += [f"axis(1, at = {r_numbers(across)}, gap.axis = -1)", f"axis(2, at = {r_numbers(up)}, gap.axis = -1)",
               "" if chart.open else "box()", f'title(main = "{chart.title}", xlab = "{chart.across}", ylab = "{chart.up}")']
    if chart.named == "legend":
        pch = f", pch = {r_numbers(chart.marks[:count])}" if chart.marks else ""
        script += [f'made <- legend("top", legend = {r_texts(chart.names)}, col = {r_texts(chart.colours[:count])}, lty = {r_numbers(chart.dashes[:count])}, '
                   f'lwd = {chart.thick}, ncol = 2{pch})',
                   "w <- xinch(par('cin')[1]); h <- yinch(par('cin')[2])",
                   TELL_PLACE,
                   f"for (i in 1:{count}) {{ ndc(made$text$x[i] - 3 * w, made$text$y[i]); ndc(made$text$x[i] - w, made$text$y[i]) }}"]
    ends, (left, right, bottom, top) = run_r(script, stem, chart.dpi)
    place = lambda x, y: (100 * (left + (right - left) * x / chart.right), 100 - 100 * (bottom + (top - bottom) * (y - chart.low) / (chart.high - chart.low)))
    return {"words": words_of(chart), "title": chart.title, **curves_of(chart, place, boxes_of(ends))}


def by_gnuplot(stem, chart):
    numbers = lambda values: "(" + ", ".join(str(v) for v in values) + ")"
    script = gnuplot_frame(chart.title, chart.up) + [
        f'set xlabel "{chart.across}"', "set key top center maxrows 2", f"set xtics {numbers(chart.ticks(0, chart.right))}", f"set ytics {numbers(chart.ticks(chart.low, chart.high))}"]
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
    run_gnuplot(script, stem, chart.dpi, f" linewidth {chart.dpi / 96}")
    place = lambda x, y: (100 * (LEFT + (RIGHT - LEFT) * x / chart.right), 100 - 100 * (BOTTOM + (TOP - BOTTOM) * (y - chart.low) / (chart.high - chart.low)))
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
    return chance_charts.figures("lines", Curves, {"Matplotlib": by_matplotlib, "R": by_r, "gnuplot": by_gnuplot}, count, seed, folder)
