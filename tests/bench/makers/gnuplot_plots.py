# SPDX-License-Identifier: Apache-2.0
"""Figures of gnuplot: SVG with its letters as text, PNG and PDF by its cairo terminals."""
import math
import os
import re

import figure

LEFT, RIGHT, BOTTOM, TOP = 0.14, 0.95, 0.22, 0.88  # of the plot, in shares of the figure from the left and from below
COMMON = f"""set encoding utf8
set key off
set lmargin at screen {LEFT}
set rmargin at screen {RIGHT}
set bmargin at screen {BOTTOM}
set tmargin at screen {TOP}
"""
SCRIPTS = {
    "line": ("""set title "Tide at the pier"
set xlabel "Hour"
set ylabel "Water in m"
set xtics (0, 6, 12, 18, 24)
set ytics (0, 1, 2, 3)
plot [0:24] [0:3.5] 1.7+1.4*sin(x/24*4*pi) with lines lw 2
""", ["Tide at the pier", "Hour", "Water in m", "0", "6", "12", "18", "24", "0", "1", "2", "3"]),
    "key": ("""set title "Cooling of tea"
set key top right
set xlabel "Minutes"
set ylabel "Temperature in °C"
set xtics (0, 10, 20, 30)
set ytics (20, 40, 60, 80)
plot [0:30] [10:95] 20+70*exp(-x/12) title "open cup" with lines, 20+70*exp(-x/30) title "closed cup" with lines dt 2 lw 2
""", ["Cooling of tea", "open cup", "closed cup", "Minutes", "Temperature in °C", "0", "10", "20", "30", "20", "40", "60", "80"]),
    "bars": ("""set title "Books read"
set boxwidth 0.6
set style fill solid 0.5
set xtics ("Ann" 1, "Ben" 2, "Cleo" 3, "Dan" 4)
set ytics (0, 4, 8, 12)
set ylabel "Books"
$d << END
1 8
2 3
3 11
4 6
END
plot [0.4:4.6] [0:13] $d using 1:2 with boxes
""", ["Books read", "Ann", "Ben", "Cleo", "Dan", "0", "4", "8", "12", "Books"]),
    "points": ("""set title "Age and pulse"
set xlabel "Years"
set ylabel "Beats per minute"
set xtics (20, 40, 60)
set ytics (60, 80, 100)
$d << END
18 70
25 66
33 72
41 75
47 71
52 80
60 78
66 84
END
plot [10:70] [55:105] $d using 1:2 with points pt 7 ps 1.2
""", ["Age and pulse", "Years", "Beats per minute", "20", "40", "60", "60", "80", "100"]),
    "turned": ("""set title "Visitors by month"
set xtics rotate by 90 right ("January" 1, "February" 2, "March" 3, "April" 4)
set ytics (0, 100, 200)
set style data histeps
$d << END
1 60
2 110
3 170
4 140
END
plot [0.5:4.5] [0:220] $d using 1:2
""", ["Visitors by month", "January", "February", "March", "April", "0", "100", "200"]),
    "arrows": ("""set title "Forces on a sledge"
unset border
unset tics
set arrow from 2,4 to 8,4 head filled
set arrow from 2,4 to 2,1 head filled
set label "pull" at 5,4.6 center
set label "weight" at 2.3,2
set label "sledge" at 1.6,4.6 center
plot [0:10] [0:7] -1 notitle
""", ["Forces on a sledge", "pull", "weight", "sledge"]),
    "log": ("""set title "Growth of cells"
set logscale y
set xlabel "Days"
set ylabel "Cells"
set format y "10^{%L}"
set xtics (0, 2, 4, 6)
set ytics (10, 100, 1000, 10000)
plot [0:7] [5:20000] 10*exp(x) with lines lw 2
""", ["Growth of cells", "Days", "Cells", "0", "2", "4", "6", "10^1", "10^2", "10^3", "10^4"]),
    "errors": ("""set title "Three measurements"
set xtics ("first" 1, "second" 2, "third" 3)
set ytics (2, 4, 6, 8)
set ylabel "Length in mm"
$d << END
1 4 0.5
2 5.5 0.9
3 6.8 0.4
END
plot [0.5:3.5] [1:9] $d with yerrorbars pt 7 lw 2
""", ["Three measurements", "first", "second", "third", "2", "4", "6", "8", "Length in mm"]),
}


class Truth:
    """What is drawn of the script's own numbers, in percent of the figure."""

    def __init__(self, x, y, logarithmic=False):
        self.x, self.y, self.height = x, y, math.log if logarithmic else lambda value: value

    def at(self, x, y):
        up = (self.height(y) - self.height(self.y[0])) / (self.height(self.y[1]) - self.height(self.y[0]))
        return (100 * (LEFT + (RIGHT - LEFT) * (x - self.x[0]) / (self.x[1] - self.x[0])), 100 - 100 * (BOTTOM + (TOP - BOTTOM) * up))

    def line(self, *points, look="line"):
        return look, [self.at(x, y) for x, y in points]

    def function(self, of, look="line"):
        xs = [self.x[0] + (self.x[1] - self.x[0]) * i / 200 for i in range(201)]
        return self.line(*((x, of(x)) for x in xs if self.y[0] <= of(x) <= self.y[1]), look=look)

    def bar(self, middle, value, wide):
        left, top = self.at(middle - wide / 2, value)
        right, bottom = self.at(middle + wide / 2, self.y[0])
        return "bar", left, top, right, bottom


def truth_of(name):
    """Members of Figure that the scripts above know."""
    if name == "line":
        return {"curves": [Truth((0, 24), (0, 3.5)).function(lambda x: 1.7 + 1.4 * math.sin(x / 24 * 4 * math.pi))]}
    if name == "key":
        t = Truth((0, 30), (10, 95))
        return {"curves": [t.function(lambda x: 20 + 70 * math.exp(-x / 12), "solid"), t.function(lambda x: 20 + 70 * math.exp(-x / 30), "dashed")]}
    if name == "bars":
        t = Truth((0.4, 4.6), (0, 13))
        return {"bars": [t.bar(x, y, 0.6) for x, y in ((1, 8), (2, 3), (3, 11), (4, 6))]}
    if name == "points":
        t = Truth((10, 70), (55, 105))
        return {"points": [t.at(x, y) for x, y in ((18, 70), (25, 66), (33, 72), (41, 75), (47, 71), (52, 80), (60, 78), (66, 84))]}
    if name == "turned":
        t = Truth((0.5, 4.5), (0, 220))
        steps = [(x, y) for i, y in enumerate((60, 110, 170, 140)) for x in (i + 0.5, i + 1.5)]
        return {"curves": [t.line(*steps)]}
    if name == "arrows":
        t = Truth((0, 10), (0, 7))
        return {"arrows": [(*t.at(8, 4), *t.at(2, 4)), (*t.at(2, 1), *t.at(2, 4))], "curves": [t.line((2, 4), (8, 4)), t.line((2, 4), (2, 1))]}
    if name == "log":
        return {"curves": [Truth((0, 7), (5, 20000), True).function(lambda x: 10 * math.exp(x))]}
    t = Truth((0.5, 3.5), (1, 9))
    marks = ((1, 4, 0.5), (2, 5.5, 0.9), (3, 6.8, 0.4))
    return {"points": [t.at(x, y) for x, y, _ in marks], "curves": [t.line((x, y - e), (x, y + e)) for x, y, e in marks]}


def needs():
    return figure.missing("gnuplot")


def make(folder, dpi):
    for name, (script, words) in SCRIPTS.items():
        stem = os.path.join(folder, "gnuplot-" + name)
        for terminal, ending in (("svg size 600,480", "svg"), (f"pngcairo size {6 * dpi},{5 * dpi} fontscale {dpi / 96}", "png"),
                                 ("pdfcairo size 6in,5in", "pdf")):
            figure.run("gnuplot", text=f"set terminal {terminal}\nset output '{stem}.{ending}'\n{COMMON}{script}")
        yield figure.Figure("gnuplot", name, {"SVG": stem + ".svg", "PNG": stem + ".png", "PDF": stem + ".pdf"},
                            [(text, None, None) for text in words], title=re.search('set title "(.*?)"', script)[1], **truth_of(name))
