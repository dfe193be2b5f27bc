# SPDX-License-Identifier: Apache-2.0
"""Pictures with print of 7 to 14 pixels, as web pages have them: charts of Matplotlib and R, and words by cairo with several ways of
smoothing letters. Their words were chosen for letters that look alike when small: rn and m, cl and d, l, I and 1, O and 0, S, 5 and 8."""
import os

import figure
import matplotlib_plots

try:
    import cairo
    import numpy as np
    from matplotlib import pyplot as plt
except ImportError:
    plt = None

WORDS = """clear class clean modern corn burn born turn stern barn hill bill Bill tilt still fill Will lily jail mail nail Fiji alibi ill Ali
Ill Illinois India Iran Iraq Italy ICE IQ II III IV Vol. No.1 10% 3.5 0.01 1,000 2,500 10.5 -40 -0.5 +3 12:30 3/4 1e5 5°C 20°C 90° x=2 y=-1
a/b kg/m m/s H2O CO2 O2 SO4 B12 S8 Z3 G6 Q4 l/min mL/L kcal cal dB Hz kHz MHz eV nm mm rpm Tom Jerry vacuum minimum aluminium summer winter
illumination titillate lithium calcium chlorine fluorine iodine oil olive soil coil clock dock cloud docile cell dell earn learn kernel ruin
rain run nun mum vow wow view new now own down town crown 8B S5 f(x) g(t) sin(x) [0,1] (a) (b) e.g. don't R&D #1 £3 €7 p<0.05 n=30 50-60
Jan-Mar α β μ Ω Δt""".split()
NAMES = [["Clay", "Corn", "Barn", "Fern"], ["Modern", "Eastern", "Western", "Urn"], ["Clear", "Class", "Cloud", "Close"],
         ["Will", "Bill", "Jill", "Phil"], ["Turn", "Burn", "Return", "Yarn"], ["clock", "clerk", "click", "cliff"],
         ["Model 1", "Model 2", "Model 3", "Model 4"], ["Jan", "Feb", "Mar", "Apr"], ["10–20", "20–30", "30–40", "40–50"],
         ["0.5", "0.25", "0.125", "1.5"], ["A1", "B2", "C3", "D4"], ["earn", "learn", "turned", "kernel"]]
TITLES = ["Turnover, 1,000 t", "Rain/mm", "Internal (cm)", "Annual cost", "Burn rate", "Government aid", "Alternative", "Return in 1990"]
PRINT = [(72, 10), (80, 10), (72, 9), (100, 8)]  # dpi, points
SMOOTHED = ["NONE", "GRAY", "SUBPIXEL"]


def needs():
    return None if plt else "Matplotlib or cairo for Python"


def saved(folder, name, dpi):
    """The figure that is drawn, and each text as the drawing of pixels saw it."""
    path = os.path.join(folder, f"small-{name}.png")
    plt.gcf().canvas.draw()
    with matplotlib_plots.listening() as heard:
        plt.savefig(path, dpi=dpi)
    plt.close()
    words = [(text.replace("\\$", "$"), x, y) for text, x, y in matplotlib_plots.middles_of(heard)]
    return figure.Figure("Matplotlib", name, {"PNG": path}, words)


def bars(folder, random):
    for dpi, points in PRINT:
        for number, names in enumerate(NAMES):
            with plt.rc_context({"font.size": points}):
                _, axes = plt.subplots(dpi=dpi)
                axes.bar(names, random.integers(1000, 9000, 4), color=f"C{number % 10}")
                axes.yaxis.set_major_formatter(lambda value, _: f"{int(value):,}")
                title = str(random.choice(TITLES))
                axes.set_title(title)
                one = saved(folder, f"bars-{dpi}-{points}-{number}", dpi)
                one.title = title
                yield one


def scattered(folder, random):
    for dpi, points in PRINT + [(90, 10), (72, 12)]:
        for face in ("DejaVu Sans", "DejaVu Serif"):
            with plt.rc_context({"font.size": points, "font.family": face}):
                _, axes = plt.subplots(dpi=dpi)
                axes.plot(np.linspace(0, 6, 200), 0.35 + 0.12 * np.sin(np.linspace(0, 6, 200)))
                axes.set(xlim=(0, 6), ylim=(0, 6.6), xticks=range(7), yticks=range(7))
                for place, word in enumerate(random.choice(WORDS, 18, replace=False)):
                    axes.text(0.3 + place % 3 * 2, 0.9 + place // 3 * 0.95, word.replace("$", "\\$"))
                yield saved(folder, f"words-{dpi}-{points}-{face.split()[1]}", dpi)


def by_cairo(folder, random):
    for face in ("DejaVu Sans", "Nimbus Sans"):
        for pixels in (9, 10, 11, 12):
            for smoothing in SMOOTHED:
                surface = cairo.ImageSurface(cairo.FORMAT_RGB24, 480, 360)
                drawing = cairo.Context(surface)
                drawing.set_source_rgb(1, 1, 1)
                drawing.paint()
                drawing.set_source_rgb(0, 0, 0)
                drawing.set_line_width(1)
                drawing.rectangle(40.5, 10.5, 420, 310)
                drawing.stroke()
                options = cairo.FontOptions()
                options.set_antialias(getattr(cairo, "ANTIALIAS_" + smoothing))
                options.set_hint_style(cairo.HINT_STYLE_NONE if pixels % 2 else cairo.HINT_STYLE_FULL)
                drawing.set_font_options(options)
                drawing.select_font_face(face)
                drawing.set_font_size(pixels)
                words = [(str(word), 60 + place % 3 * 135, 40 + place // 3 * 46)
                         for place, word in enumerate(random.choice(WORDS, 18, replace=False))]
                words += [(str(number), 40 + 60 * number, 336) for number in range(7)]
                truth = []
                for word, x, y in words:
                    drawing.move_to(x, y)
                    drawing.show_text(word)
                    truth.append((word, 100 * (x + drawing.text_extents(word).width / 2) / 480, 100 * (y - pixels / 3) / 360))
                name = f"words-{face.split()[0]}-{pixels}-{smoothing.lower()}"
                path = os.path.join(folder, f"small-{name}.png")
                surface.write_to_png(path)
                yield figure.Figure("cairo", name, {"PNG": path}, truth)


def make(folder, _):
    random = np.random.default_rng(20)
    yield from bars(folder, random)
    yield from scattered(folder, random)
    yield from by_cairo(folder, random)
