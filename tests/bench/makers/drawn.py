# SPDX-License-Identifier: Apache-2.0
"""SVG written by hand after the habits of drawing programs and web libraries; PNG and PDF of it by librsvg."""
import math
import os

import figure

HEAD = '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" '
ARROW = '<marker id="{0}" viewBox="0 0 10 10" refX="9" refY="5" markerWidth="8" markerHeight="8" orient="auto"><path d="{1}"/></marker>'


def rectangle(x, y, wide, high):
    return [(x, y), (x + wide, y), (x + wide, y + high), (x, y + high), (x, y)]


def ellipse(x, y, rx, ry):
    return [(x + rx * math.cos(math.tau * i / 64), y + ry * math.sin(math.tau * i / 64)) for i in range(65)]


def bezier(*p):
    weights = [((1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t ** 3) for t in (i / 40 for i in range(41))]
    return [tuple(sum(w * q[axis] for w, q in zip(ws, p)) for axis in (0, 1)) for ws in weights]


def d3_bars():
    """D3: groups with transforms, ticks with dy in em, a style sheet with two-part selectors."""
    out = HEAD + 'width="480" height="360"><style>.axis text{font:12px sans-serif} .axis path,.axis line{fill:none;stroke:#000}' \
                 ' .bar{fill:steelblue}</style><g transform="translate(60,40)">'
    words = [("Frequency", 16.5, 13)]
    out += '<text transform="rotate(-90)" y="6" dy=".71em" style="text-anchor:end;font-size:12px">Frequency</text>'
    out += '<g class="axis" transform="translate(0,260)"><path d="M0,6V0H390V6"/>'
    for i, (name, value) in enumerate((("Mon", 8), ("Tue", 12), ("Wed", 5), ("Thu", 16))):
        out += f'<g class="tick" transform="translate({50 + 95 * i},0)"><line y2="6"/><text y="9" dy=".71em" style="text-anchor:middle">{name}</text></g>'
        words.append((name, 100 * (110 + 95 * i) / 480, 100 * 313 / 360))
    out += "</g><g class='axis'><path d='M-6,0H0V260H-6'/>"
    for value in (0, 5, 10, 15):
        y = 260 - 15 * value
        out += f'<g class="tick" transform="translate(0,{y})"><line x2="-6"/><text x="-9" dy=".32em" style="text-anchor:end">{value}</text></g>'
        words.append((str(value), 10, 100 * (y + 40) / 360))
    out += "</g>"
    for i, value in enumerate((8, 12, 5, 16)):
        out += f'<rect class="bar" x="{20 + 95 * i}" width="60" y="{260 - 15 * value}" height="{15 * value}"/>'
    return out + "</g></svg>", words, {"bars": [("bar", 80 + 95 * i, 300 - 15 * v, 140 + 95 * i, 300) for i, v in enumerate((8, 12, 5, 16))], "size": (480, 360)}


def drawio():
    """draw.io: each label in a switch, as HTML and as a text that may be cut off."""
    out = HEAD + 'width="421px" height="241px" viewBox="-0.5 -0.5 421 241"><defs/><g>'
    words = []
    boxes = [(20, 20, "Customer"), (280, 20, "Order of goods"), (150, 160, "Warehouse")]
    for x, y, name in boxes:
        short = name if len(name) < 12 else name[:9] + "..."
        out += f'<rect x="{x}" y="{y}" width="120" height="60" fill="#fff" stroke="#000" pointer-events="all"/>' \
               f'<g transform="translate(-0.5 -0.5)"><switch><foreignObject pointer-events="none" width="100%" height="100%" ' \
               f'requiredFeatures="http://www.w3.org/TR/SVG11/feature#Extensibility" style="overflow:visible;text-align:left">' \
               f'<div xmlns="http://www.w3.org/1999/xhtml" style="display:flex;align-items:unsafe center;justify-content:unsafe center;' \
               f'width:118px;height:1px;padding-top:{y + 30}px;margin-left:{x + 1}px"><div style="font-size:0px;text-align:center">' \
               f'<div style="display:inline-block;font-size:12px">{name}</div></div></div></foreignObject>' \
               f'<text x="{x + 60}" y="{y + 34}" font-family="Helvetica" font-size="12px" text-anchor="middle">{short}</text></switch></g>'
        words.append((name, 100 * (x + 60) / 421, 100 * (y + 30) / 241))
    for path, tip in (("M 140 50 L 273 50", "M 278 50 L 271 53.5 L 273 50 L 271 46.5 Z"),
                      ("M 340 80 L 256 155", "M 252 158 L 255 151 L 256 155 L 260 156 Z")):
        out += f'<path d="{path}" fill="none" stroke="#000" stroke-miterlimit="10"/><path d="{tip}" fill="#000" stroke="#000"/>'
    return out + "</g></svg>", words, {"arrows": [(278, 50, 140, 50), (252, 158, 340, 80)], "curves": [[(140, 50), (273, 50)], [(340, 80), (256, 155)]] + \
        [[(x, y), (x + 120, y), (x + 120, y + 60), (x, y + 60), (x, y)] for x, y, _ in boxes], "size": (421, 241)}


def commons():
    """Wikimedia Commons: style sheet, languages in a switch, tspans that move, an open arrow head."""
    out = HEAD + 'width="500" height="400" viewBox="0 0 500 400"><style type="text/css"><![CDATA[text{font-family:"DejaVu Sans",sans-serif;' \
                 'font-size:16px;text-anchor:middle} .leader{stroke:#333;stroke-width:1.5;fill:none;marker-end:url(#open)}]]></style><defs>' \
          + ARROW.format("open", "M0,0 L10,5 L0,10").replace("<path", '<path fill="none" stroke="black"') + '</defs>'
    out += '<ellipse cx="250" cy="210" rx="150" ry="110" fill="#fce94f" stroke="#000" stroke-width="3"/>' \
           '<circle cx="250" cy="200" r="45" fill="#edd400" stroke="#000"/>'
    out += '<switch><text systemLanguage="de" x="90" y="40">Zellkern</text><text x="90" y="40">Nucleus</text></switch>'
    out += '<path class="leader" d="M110,50 L215,170"/>'
    out += '<text x="400" y="40"><tspan x="400" y="40">Cell</tspan><tspan x="400" dy="1.2em">membrane</tspan></text>'
    out += '<path class="leader" d="M390,70 L350,125"/><text><tspan x="250" y="380" font-size="120%">An animal cell</tspan></text></svg>'
    return out, [("Nucleus", 18, 9), ("Cell", 80, 9), ("membrane", 80, 13.5), ("An animal cell", 50, 93)], \
        {"arrows": [(215, 170, 110, 50), (350, 125, 390, 70)], "curves": [[(110, 50), (215, 170)], [(390, 70), (350, 125)], ellipse(250, 210, 150, 110),
                                                                     ellipse(250, 200, 45, 45)], "size": (500, 400)}


def on_a_path():
    """A river's name along it."""
    out = HEAD + 'width="120mm" height="80mm" viewBox="0 0 480 320"><defs><path id="river" d="M40,220 C140,120 260,300 440,140"/></defs>' \
          '<use xlink:href="#river" fill="none" stroke="#36c" stroke-width="4"/>' \
          '<text font-size="18" dy="-6"><textPath xlink:href="#river" startOffset="30%">River Severn</textPath></text>' \
          '<circle cx="400" cy="80" r="6"/><text x="400" y="60" font-size="18" text-anchor="middle">Bristol</text></svg>'
    return out, [("River Severn", 45, 62), ("Bristol", 83, 17)], \
        {"curves": [bezier((40, 220), (140, 120), (260, 300), (440, 140))], "points": [(400, 80)], "size": (480, 320)}


def em_fonts():
    """Sizes in em, % and pt, set by groups; a row of names as tspans of one text."""
    out = HEAD + 'width="12cm" height="9cm" viewBox="0 0 400 300" font-size="10"><g font-size="1.6em"><text x="200" y="30" text-anchor="middle">' \
          'Planets</text><g font-size="90%"><text y="150"><tspan x="40">Venus</tspan><tspan x="150">Earth</tspan><tspan x="270">Mars</tspan></text></g>' \
          '<text style="font-size:12pt" x="200" y="280" text-anchor="middle">not to scale</text></g>'
    for x, r in ((60, 18), (170, 20), (290, 12)):
        out += f'<circle cx="{x}" cy="100" r="{r}" fill="none" stroke="#000"/>'
    return out + "</svg>", [("Planets", 50, 8), ("Venus", 16, 48), ("Earth", 44, 48), ("Mars", 72, 48), ("not to scale", 50, 92)], \
        {"curves": [ellipse(x, 100, r, r) for x, r in ((60, 18), (170, 20), (290, 12))], "size": (400, 300)}


def inkscape():
    """Inkscape: millimetres, text with tspans of role line, letters as paths that say their words, a shadow."""
    out = HEAD + 'xmlns:sodipodi="http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd" width="210mm" height="148mm" viewBox="0 0 210 148"><defs>' \
          '<filter id="blur"><feGaussianBlur stdDeviation="2"/></filter><linearGradient id="shine"><stop offset="0" style="stop-color:#ffffff"/>' \
          '<stop offset="1" style="stop-color:#999999"/></linearGradient></defs>' \
          '<rect x="43" y="43" width="60" height="40" style="fill:#000000;fill-opacity:0.3;filter:url(#blur)"/>' \
          '<rect x="40" y="40" width="60" height="40" style="fill:url(#shine);stroke:#000000;stroke-width:0.8"/>' \
          '<text xml:space="preserve" style="font-size:7px" x="48" y="60"><tspan sodipodi:role="line" x="48" y="60">Steam</tspan>' \
          '<tspan sodipodi:role="line" x="48" y="69">engine</tspan></text>' \
          '<g aria-label="Boiler" style="stroke-width:0.26"><path d="M 130,50 v -8 h 3 q 2,2 0,4 q 3,2 0,4 z m 8,-5 q 3,0 3,3 q 0,3 -3,3 q -3,0 -3,-3 q 0,-3 3,-3 z"/>' \
          '<path d="m 145,45 v 6 m 4,-9 v 9 m 4,-4 h 4 m 3,-2 v 6" style="fill:none;stroke:#000"/></g>' \
          '<rect x="120" y="60" width="50" height="30" style="fill:none;stroke:#000"/></svg>'
    return out, [("Steam", 27, 39), ("engine", 27, 45), ("Boiler", 69, 31)], \
        {"curves": [rectangle(40, 40, 60, 40), rectangle(120, 60, 50, 30)], "size": (210, 148)}


def office():
    """LibreOffice: classes, one tspan in another, positions in hundredths of a millimetre."""
    out = HEAD + 'version="1.2" width="160mm" height="90mm" viewBox="0 0 16000 9000" stroke-width="28.2" preserveAspectRatio="xMidYMid"><g class="Page">'
    words = []
    for x, y, name in ((1000, 1000, "Idea"), (6200, 1000, "Plan"), (11400, 1000, "Result")):
        out += f'<g class="com.sun.star.drawing.CustomShape"><g><rect class="BoundingBox" stroke="none" fill="none" x="{x}" y="{y}" width="3600" height="2200"/>' \
               f'<path fill="rgb(114,159,207)" stroke="none" d="M {x},{y} h 3600 v 2200 h -3600 Z"/><path fill="none" stroke="rgb(52,101,164)" d="M {x},{y} h 3600 v 2200 h -3600 Z"/>' \
               f'<text class="SVGTextShape"><tspan class="TextParagraph" font-family="Liberation Sans, sans-serif" font-size="635px" font-weight="400">' \
               f'<tspan class="TextPosition" x="{x + 1100}" y="{y + 1320}"><tspan fill="rgb(0,0,0)" stroke="none">{name}</tspan></tspan></tspan></text></g></g>'
        words.append((name, 100 * (x + 1800) / 16000, 100 * (y + 1100) / 9000))
    for x in (4600, 9800):
        out += f'<path fill="none" stroke="#000" d="M {x},2100 L {x + 1300},2100"/><path fill="#000" stroke="none" d="M {x + 1600},2100 l -450,-150 v 300 z"/>'
    return out + "</g></svg>", words, {"arrows": [(x + 1600, 2100, x, 2100) for x in (4600, 9800)], "size": (16000, 9000),
                                    "curves": [rectangle(x, 1000, 3600, 2200) for x in (1000, 6200, 11400)] + [[(x, 2100), (x + 1300, 2100)] for x in (4600, 9800)]}


def excel():
    """A chart of a spreadsheet: clip paths, one text a label with a transform, a dark outline twice."""
    out = HEAD + 'width="600" height="360" overflow="hidden"><defs><clipPath id="clip0"><rect x="0" y="0" width="600" height="360"/></clipPath></defs>' \
          '<g clip-path="url(#clip0)"><rect x="0" y="0" width="600" height="360" fill="#FFFFFF"/>'
    words = []
    for i, (name, value) in enumerate((("North", 150), ("South", 220), ("East", 90))):
        x = 100 + 160 * i
        for _ in range(2):
            out += f'<rect x="{x}" y="{290 - value}" width="80" height="{value}" stroke="#262626" stroke-width="1.33" fill="#4472C4"/>'
        out += f'<text font-family="Calibri,Calibri_MSFontService,sans-serif" font-weight="400" font-size="16" transform="matrix(1 0 0 1 {x + 20} 315)">{name}</text>'
        words.append((name, 100 * (x + 40) / 600, 86))
    out += '<text font-size="20" transform="translate(210 30)">Sales by region</text><path d="M80 290H560" stroke="#262626" fill="none"/></g></svg>'
    return out, words + [("Sales by region", 47, 7)], \
        {"bars": [("bar", 100 + 160 * i, 290 - v, 180 + 160 * i, 290) for i, v in enumerate((150, 220, 90))], "size": (600, 360)}


def mathjax():
    """MathJax: glyphs that say their code."""
    glyphs = {"1D466": "M21 287Q21 301 36 335T84 406T158 442Q199 442 224 419T250 355Q248 336 247 334Q247 331 231 288T198 191T182 105Q182 62 196 45T238 27Q261 27 281 38T312 61T339 94Z",
              "3D": "M56 347Q56 360 70 367H707Q722 359 722 347Q722 336 708 328L390 327H72Q56 332 56 347ZM56 153Q56 168 72 173H708Q722 163 722 153Q722 140 707 133H70Q56 140 56 153Z",
              "1D465": "M52 289Q59 331 106 386T222 442Q257 442 286 424T329 379Q371 442 430 442Q467 442 494 420T522 361Q522 332 508 314T481 292T458 288Q439 288 427 299T415 328Z"}
    out = HEAD + 'width="300" height="200" viewBox="0 -750 3000 2000"><defs>' + "".join(
        f'<path id="MJX-1-TEX-{c}" d="{d}"/>' for c, d in glyphs.items()) + '</defs><g stroke="currentColor" fill="currentColor" stroke-width="0" transform="scale(1,-1)">' \
        '<g data-mml-node="math">'
    for code, x in (("1D466", 900), ("3D", 1668), ("1D465", 2724)):
        out += f'<g data-mml-node="mi" transform="translate({x - 600},0)"><use data-c="{code}" xlink:href="#MJX-1-TEX-{code}"/></g>'
    return out + '</g></g><path d="M300 1000 L2600 400" stroke="#000" stroke-width="20"/></svg>', [("y = x", 45, 28)], {"curves": [[(300, 1750), (2600, 1150)]], "size": (3000, 2000)}


def mermaid():
    """Mermaid: labels in HTML only."""
    out = HEAD + 'width="400" height="300" viewBox="0 0 400 300"><style>#m .node rect{fill:#ECECFF;stroke:#9370DB} .flow{stroke:#333;stroke-width:2px;fill:none}</style><defs>' \
          + ARROW.format("point", "M 0 0 L 10 5 L 0 10 z") + '</defs><path class="flow" marker-end="url(#point)" d="M200,90 L200,205"/>'
    words = []
    for y, name in ((65, "Ask a question"), (235, "Make a guess")):
        out += f'<g class="node" transform="translate(200,{y})"><rect x="-70" y="-25" width="140" height="50" style="fill:#eef;stroke:#333"/>' \
               f'<g class="label" transform="translate(-55,-10)"><foreignObject width="110" height="20"><div xmlns="http://www.w3.org/1999/xhtml">' \
               f'<span class="nodeLabel">{name}</span></div></foreignObject></g></g>'
        words.append((name, 50, 100 * y / 300))
    return out + "</svg>", words, {"arrows": [(200, 206, 200, 90)], "curves": [[(200, 90), (200, 205)], rectangle(130, 40, 140, 50), rectangle(130, 210, 140, 50)], "size": (400, 300)}


def markers():
    """Heads of arrows as markers: closed, open, at both ends."""
    out = HEAD + 'width="400" height="300"><defs>' + ARROW.format("full", "M0,0 L10,5 L0,10 z") \
          + ARROW.format("vee", "M0,0 L9,5 L0,10").replace("<path", '<path style="fill:none;stroke:black;stroke-width:1.5"') \
          + ARROW.format("back", "M10,0 L0,5 L10,10 z").replace('refX="9"', 'refX="1"') + '</defs><g stroke="black" stroke-width="2" fill="none">' \
          '<line x1="60" y1="60" x2="340" y2="60" marker-end="url(#full)"/><path d="M60,150 L340,150" marker-end="url(#vee)"/>' \
          '<polyline points="60,240 200,220 340,240" marker-start="url(#back)" marker-end="url(#full)"/></g>' \
          '<g font-size="18" text-anchor="middle"><text x="200" y="45">force</text><text x="200" y="135">speed</text><text x="200" y="205">both</text></g></svg>'
    return out, [("force", 50, 13), ("speed", 50, 43), ("both", 50, 66)], \
        {"arrows": [(342, 60, 60, 60), (342, 150, 60, 150), (58, 240.3, 200, 220), (342, 240.3, 200, 220)], "size": (400, 300),
         "curves": [[(60, 60), (340, 60)], [(60, 150), (340, 150)], [(60, 240), (200, 220), (340, 240)]]}


def symbols():
    """Text in symbols and in a nested view, used twice; a label with a white halo drawn beneath it."""
    out = HEAD + 'width="600" height="300" viewBox="0 0 600 300"><defs><symbol id="house" viewBox="0 0 100 100"><path d="M10,50 L50,10 L90,50 V95 H10 Z" fill="none" stroke="#000" ' \
          'stroke-width="3"/><text x="50" y="75" font-size="18" text-anchor="middle">School</text></symbol></defs>' \
          '<use xlink:href="#house" x="20" y="60" width="200" height="200"/><svg x="300" y="60" width="200" height="200" viewBox="0 0 100 100">' \
          '<rect x="5" y="5" width="90" height="90" fill="none" stroke="#000"/><text x="50" y="55" font-size="16" text-anchor="middle">Market</text></svg>' \
          '<g text-anchor="middle" font-size="20"><text x="300" y="35" stroke="#fff" stroke-width="4">Old town</text><text x="300" y="35">Old town</text></g></svg>'
    return out, [("School", 20, 68), ("Market", 67, 53), ("Old town", 50, 10)], \
        {"curves": [rectangle(310, 70, 180, 180), [(40, 160), (120, 80), (200, 160), (200, 250), (40, 250), (40, 160)]], "size": (600, 300)}


def entities():
    """Signs beyond ASCII, sub- and superscripts by tspans, single letters, degrees."""
    out = HEAD + 'width="500" height="300"><g font-family="serif" font-size="20"><text x="60" y="60">H<tspan dy="5" font-size="13">2</tspan><tspan dy="-5">O</tspan></text>' \
          '<text x="200" y="60">m/s<tspan baseline-shift="super" font-size="13">2</tspan></text><text x="330" y="60">α = 30°</text>' \
          '<text x="60" y="200">−5 °C</text><text x="200" y="200">A′</text><text x="330" y="200">½ λ</text></g><path d="M40,120 H460" stroke="#000"/></svg>'
    return out, [("H2O", 16, 18), ("m/s²", 45, 18), ("α = 30°", 73, 18), ("−5 °C", 17, 64), ("A′", 42, 64), ("½ λ", 70, 64)], {"curves": [[(40, 120), (460, 120)]], "size": (500, 300)}


def turned():
    """Map names at an angle, and one letter a position."""
    xs = " ".join(str(300 + 11 * i) for i in range(6))
    out = HEAD + f'width="500" height="400"><path d="M50,350 L450,50 M50,50 L450,350" stroke="#000" stroke-width="3"/><text transform="translate(130,270) rotate(-36)" ' \
          f'font-size="18">Mill Road</text><text transform="translate(110,80) rotate(36)" font-size="18">High Street</text><text x="{xs}" y="60" font-size="16">Church</text>' \
          f'<text x="30" y="210" font-size="16" rotate="0">Park</text></svg>'
    return out, [("Mill Road", 33, 60), ("High Street", 30, 27), ("Church", 65, 14), ("Park", 9, 51)], \
        {"curves": [[(50, 350), (450, 50)], [(50, 50), (450, 350)]], "size": (500, 400)}


def venn():
    """Clear colours above each other are no shadows."""
    out = HEAD + 'width="480" height="320"><g opacity="0.5"><circle cx="190" cy="170" r="120" fill="#e41a1c"/></g><circle cx="300" cy="170" r="120" fill="#377eb8" ' \
          'fill-opacity="0.4"/><g font-size="18" text-anchor="middle"><text x="130" y="175">Odd</text><text x="360" y="175">Prime</text><text x="245" y="165">3</text>' \
          '<text x="245" y="190">5</text><text x="245" y="30">Numbers below ten</text></g></svg>'
    return out, [("Odd", 27, 53), ("Prime", 75, 53), ("3", 51, 50), ("5", 51, 58), ("Numbers below ten", 51, 7.5)], \
        {"curves": [ellipse(190, 170, 120, 120), ellipse(300, 170, 120, 120)], "size": (480, 320)}


def plotly():
    """Plotly: layers of groups, styles with CSS text in rgb(), labels with data of their own."""
    out = HEAD + 'class="main-svg" width="600" height="400" style="background: white;"><defs><clipPath id="xy"><rect width="480" height="280"/></clipPath></defs>' \
          '<g class="bglayer"><rect x="80" y="60" width="480" height="280" style="fill: rgb(255, 255, 255); fill-opacity: 1; stroke-width: 0;"/></g>' \
          '<g class="plot" transform="translate(80,60)" clip-path="url(#xy)"><path d="M0,250L120,180L240,200L360,90L480,40" ' \
          'style="fill: none; stroke: rgb(99, 110, 250); stroke-opacity: 1; stroke-width: 2px; opacity: 1;"/></g><g class="xaxislayer-above">'
    words = [("Height of a plant", 50, 7.5)]
    for i, week in enumerate(("0", "1", "2", "3", "4")):
        out += f'<g class="xtick"><text text-anchor="middle" x="0" y="353" data-unformatted="{week}" transform="translate({80 + 120 * i},0)" ' \
               f'style="font-family: Arial; font-size: 12px; fill: rgb(42, 63, 95); white-space: pre;">{week}</text></g>'
        words.append((week, 100 * (80 + 120 * i) / 600, 87))
    out += '</g><g class="infolayer"><text class="gtitle" x="300" y="32" text-anchor="middle" dy="0em" style="font-size: 17px; fill: rgb(42, 63, 95);">' \
           'Height of a plant</text><text class="xtitle" x="320" y="385" text-anchor="middle" style="font-size: 14px;"><tspan>Week</tspan></text></g>' \
           '<path d="M80,340H560M80,60V340" style="fill:none;stroke:#000"/></svg>'
    return out, words + [("Week", 53, 95)], \
        {"curves": [[(80 + x, 60 + y) for x, y in ((0, 250), (120, 180), (240, 200), (360, 90), (480, 40))]], "size": (600, 400)}


def plantuml():
    """PlantUML: text with its length, heads as polygons, dashed life lines."""
    out = HEAD + 'width="320px" height="260px" viewBox="0 0 320 260" style="width:320px;height:260px;background:#FFFFFF;"><defs/><g>' \
          '<line style="stroke:#181818;stroke-width:0.5;stroke-dasharray:5.0,5.0;" x1="60" x2="60" y1="46" y2="220"/>' \
          '<line style="stroke:#181818;stroke-width:0.5;stroke-dasharray:5.0,5.0;" x1="250" x2="250" y1="46" y2="220"/>'
    words = []
    for x, name in ((60, "Alice"), (250, "Bob")):
        for y in (15, 215):
            out += f'<rect fill="#E2E2F0" height="30" rx="2.5" ry="2.5" style="stroke:#181818;stroke-width:0.5;" width="60" x="{x - 30}" y="{y}"/>' \
                   f'<text fill="#000000" font-family="sans-serif" font-size="14" lengthAdjust="spacing" textLength="33" x="{x - 16}" y="{y + 20}">{name}</text>'
            words.append((name, 100 * x / 320, 100 * (y + 15) / 260))
    for y, text, tip in ((100, "asks for help", 250), (160, "gives advice", 60)):
        back = -10 if tip == 250 else 10
        out += f'<polygon fill="#181818" points="{tip + back},{y - 4},{tip},{y},{tip + back},{y + 4},{tip + 0.6 * back},{y}" style="stroke:#181818;stroke-width:1.0;"/>' \
               f'<line style="stroke:#181818;stroke-width:1.0;" x1="60" x2="250" y1="{y}" y2="{y}"/>' \
               f'<text fill="#000000" font-family="sans-serif" font-size="13" textLength="80" x="115" y="{y - 6}">{text}</text>'
        words.append((text, 48, 100 * (y - 10) / 260))
    return out + "</g></svg>", words, \
        {"arrows": [(250, 100, 60, 100), (60, 160, 250, 160)], "size": (320, 260),
         "curves": [[(60, 46), (60, 215)], [(250, 46), (250, 215)], [(60, 100), (250, 100)], [(60, 160), (250, 160)]] +
                   [rectangle(x - 30, y, 60, 30) for x in (60, 250) for y in (15, 215)]}


DRAWINGS = [plotly, plantuml, d3_bars, drawio, commons, on_a_path, em_fonts, inkscape, office, excel, mathjax, mermaid, markers, symbols, entities, turned, venn]
NO_RENDERING = {mermaid}  # librsvg shows no HTML
GLYPHS = {mathjax}


def needs():
    return None


# What pixels show of words: the text that draw.io cuts off, and nothing of the letters that are only hinted at by shapes here,
# nor of text on a path, which librsvg does not draw.
PIXELS = {"Order of goods": "Order of ...", "Boiler": "", "y = x": "", "River Severn": ""}


TITLES = ("Planets", "Sales by region", "Height of a plant", "Old town", "Numbers below ten")


def truth(size, arrows=(), curves=(), bars=(), points=()):
    """In percent, of places in the units of a drawing of that size."""
    wide, high = size
    place = lambda *numbers: [100 * n / (high if i % 2 else wide) for i, n in enumerate(numbers)]
    return {"arrows": [place(*one) for one in arrows], "curves": [("line", figure.in_percent(one, wide, high)) for one in curves],
            "bars": [(look, *place(*one)) for look, *one in bars], "points": [place(*one) for one in points]}


def make(folder, dpi):
    for draw in DRAWINGS:
        text, words, drawn = draw()
        path = os.path.join(folder, f"drawn-{draw.__name__}.svg")
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        files = {"SVG glyphs" if draw in GLYPHS else "SVG": path}
        if draw not in NO_RENDERING:
            files |= figure.renderings(path, dpi)
        shown = [(PIXELS.get(text, text), x, y) for text, x, y in words]
        yield figure.Figure("drawn", draw.__name__, files, words, pixel_words=[label for label in shown if label[0]],
                            title=next((text for text, _, _ in words if text in TITLES), ""), **truth(**drawn))
