# SPDX-License-Identifier: Apache-2.0
"""What the charts that chance makes have in common: 6 x 4.5 inches, drawn by Matplotlib, R and gnuplot as PNG, SVG and PDF."""
import os
import random

import figure
import matplotlib_plots

WIDE, HIGH = 6, 4.5  # inches
LEFT, RIGHT, BOTTOM, TOP = 0.14, 0.95, 0.16, 0.88  # of gnuplot's plot, in shares of the figure
# For R: tells where a place of the plot is in the figure.
TELL_PLACE = "ndc <- function(x, y) cat(grconvertX(x, 'user', 'ndc'), grconvertY(y, 'user', 'ndc'), '')"


def save_matplotlib(shown, stem, dpi):
    """Gives the words that were drawn, each with its middle in percent."""
    with matplotlib_plots.listening() as heard:
        shown.savefig(stem + ".png", dpi=dpi)
    shown.savefig(stem + ".svg", metadata={"Date": None})
    shown.savefig(stem + ".pdf", metadata={"CreationDate": None})
    shown.set_dpi(dpi)
    return matplotlib_plots.middles_of(heard)


def r_numbers(values):
    return "c(" + ",".join(f"{v:.4f}" for v in values) + ")"


def r_texts(values):
    return "c(" + ",".join(f'"{v}"' for v in values) + ")"


def run_r(script, stem, dpi):
    """Gives the places that it told, and the sides of the plot: left, right, bottom, top, in shares of the figure from its lower left."""
    script = script + ['cat(grconvertX(par("usr")[1:2], "user", "ndc"), grconvertY(par("usr")[3:4], "user", "ndc"))', "invisible(dev.off())"]
    for device in (f'svg("{stem}.svg", {WIDE}, {HIGH})', f'pdf("{stem}.pdf", {WIDE}, {HIGH})',
                   f'png("{stem}.png", {WIDE} * {dpi}, {HIGH} * {dpi}, res = {dpi}, type = "cairo")'):
        *told, left, right, bottom, top = (float(n) for n in figure.run("Rscript", "-", text="\n".join([device] + script)).split())
    return told, (left, right, bottom, top)


def boxes_of(told):
    """Of places in twos the boxes in percent: left, top, right, bottom."""
    return [(100 * a, 100 - 100 * b, 100 * c, 100 - 100 * d) for a, b, c, d in zip(*[iter(told)] * 4)]


def gnuplot_frame(title, up):
    return ["set encoding utf8", f"set lmargin at screen {LEFT}", f"set rmargin at screen {RIGHT}", f"set bmargin at screen {BOTTOM}",
            f"set tmargin at screen {TOP}", f'set title "{title}"', f'set ylabel "{up}"']


def run_gnuplot(script, stem, dpi, more=""):
    """`more`: options of the terminal of pixels."""
    for terminal, ending in (("svg size 600,450", "svg"), (f"pngcairo size {WIDE * dpi},{int(HIGH * dpi)} fontscale {dpi / 96}{more}", "png"),
                             (f"pdfcairo size {WIDE}in,{HIGH}in", "pdf")):
        figure.run("gnuplot", text="\n".join([f"set terminal {terminal}", f"set output '{stem}.{ending}'"] + script))


def figures(kind, chart, drawers, count, seed, folder):
    """So many of each maker that is installed: what `chart` chooses by chance, drawn by drawers[maker]."""
    for maker, program in (("Matplotlib", None), ("R", "Rscript"), ("gnuplot", "gnuplot")):
        if program and figure.missing(program):
            continue
        chance = random.Random(f"{maker} {seed}")
        for number in range(count):
            name = f"{kind}-{number}"
            stem = os.path.join(folder, f"{maker}-{name}")
            made = drawers[maker](stem, chart(chance, maker))
            yield figure.Figure(maker, name, {form: f"{stem}.{form.lower()}" for form in ("PNG", "SVG", "PDF")}, **made)
