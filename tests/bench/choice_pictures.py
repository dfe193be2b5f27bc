# SPDX-License-Identifier: Apache-2.0
"""The pictures of tests/bench/choice: found in packages of Debian, drawn with fixed seeds, photographed and scanned badly.

Each generator gives pairs of a source's name and a picture in RGB; what is made of one source carries its name.
"""
import glob
import io
import os
import random
import subprocess

import matplotlib

matplotlib.use("agg")
import matplotlib.pyplot as plt
import numpy as np
from PIL import Image, ImageDraw, ImageFilter, ImageFont, ImageOps

PACKAGES = ["adwaita-icon-theme", "famfamfam-flag-png", "fonts-noto-color-emoji", "gnome-icon-theme", "iso-flags-png-320x240",
            "kgeography-data", "lomiri-wallpapers-16.04", "lomiri-wallpapers-20.04", "mate-backgrounds", "opencv-doc",
            "openclipart-png", "oxygen-icon-theme", "papirus-icon-theme", "plasma-workspace-wallpapers", "python3-skimage",
            "tango-icon-theme", "tuxpaint-stamps-default", "xfig-libs"]


def fetch(folder):
    """Packages as apt has them, unpacked below `folder` and not installed."""
    debs, root = os.path.join(folder, "debs"), os.path.join(folder, "root")
    os.makedirs(debs, exist_ok=True)
    os.makedirs(root, exist_ok=True)
    missing = [p for p in PACKAGES if not glob.glob(os.path.join(debs, p + "_*.deb"))]
    if missing:
        subprocess.run(["apt-get", "download", "-qq"] + missing, cwd=debs, check=True)
    for package in PACKAGES:
        mark = os.path.join(root, "." + package)
        if not os.path.exists(mark):
            subprocess.run(["dpkg-deb", "-x", glob.glob(os.path.join(debs, package + "_*.deb"))[0], root], check=True)
            open(mark, "w", encoding="ascii").close()
    return root


def chosen(files, count, seed):
    """That many, always the same."""
    files = sorted(set(files))
    return sorted(random.Random(seed).sample(files, min(count, len(files))))


def on_white(picture):
    picture = picture.convert("RGBA")
    ground = Image.new("RGBA", picture.size, "white")
    ground.alpha_composite(picture)
    return ground.convert("RGB")


def opened(name, longest=900):  # nothing is looked at finer than 500
    picture = Image.open(name)
    if picture.mode in ("I", "I;16", "F"):
        picture = Image.fromarray((255.0 * np.asarray(picture, float) / max(1, np.asarray(picture).max())).astype(np.uint8))
    picture.draft("RGB", (longest, longest))
    picture = on_white(picture)
    picture.thumbnail((longest, longest), Image.LANCZOS)
    return picture


def of_svg(name, size):
    run = subprocess.run(["rsvg-convert", "-w", str(size), "-h", str(size), "-a", name], capture_output=True, check=False)
    return on_white(Image.open(io.BytesIO(run.stdout))) if run.returncode == 0 else None


# Photographs

def toned(picture, function):
    levels = [int(round(min(255.0, max(0.0, function(v))))) for v in range(256)]
    return picture.point(levels * 3)


def as_jpeg(picture, quality):
    buffer = io.BytesIO()
    picture.save(buffer, "JPEG", quality=quality)
    return Image.open(buffer).convert("RGB")


def noisy(picture, deviation, seed):
    noise = np.random.default_rng(seed).normal(0, deviation, (picture.height, picture.width, 3))
    return Image.fromarray(np.clip(np.asarray(picture) + noise + 0.5, 0, 255).astype(np.uint8))


def bordered(picture, colour, *, share=0.06, sides=(1, 1, 1, 1), jpeg=0):
    wide = max(3, round(share * max(picture.size)))
    left, top, right, bottom = (wide * s for s in sides)
    whole = Image.new("RGB", (picture.width + left + right, picture.height + top + bottom), colour)
    whole.paste(picture, (left, top))
    return as_jpeg(whole, jpeg) if jpeg else whole


CONDITIONS = {
    "as taken": lambda p, n: p,
    "dark": lambda p, n: toned(p, lambda v: 0.1 * v),
    "grey": lambda p, n: p.convert("L").convert("RGB"),
    "fog": lambda p, n: toned(p, lambda v: 150 + 0.25 * v),
    "night": lambda p, n: toned(p, lambda v: 1.6 * (v - 120)),
    "snow": lambda p, n: toned(p, lambda v: 1.5 * v + 40),
    "contre-jour": lambda p, n: toned(p, lambda v: 2.5 * (v - 128) + 128),
    "sepia": lambda p, n: ImageOps.colorize(p.convert("L"), "#140a00", "#fff0d0"),
    "noisy": lambda p, n: noisy(p, 12, n),
    "JPEG 30": lambda p, n: as_jpeg(p, 30),
    "64 pixels": lambda p, n: p.resize((max(1, p.width * 64 // max(p.size)), max(1, p.height * 64 // max(p.size))), Image.LANCZOS),
    "upscaled": lambda p, n: p.resize((p.width * 3, p.height * 3), Image.BICUBIC),
    "black border": lambda p, n: bordered(p, "black", jpeg=85),
    "film": lambda p, n: bordered(p, "black", share=0.12, sides=(0, 1, 0, 1)),
    "passe-partout": lambda p, n: bordered(p, "white", share=0.15),
}


def photographs_of(folder):
    for name in sorted(glob.glob(os.path.join(folder, "*.jpg")) + glob.glob(os.path.join(folder, "*.png"))):
        yield os.path.basename(name), opened(name)


WALLPAPERS = ("Bridge_by_* Dragonfly_by_* Kleiber_by_* Picture_0B_* Wine_by_* Picture_1A_* aitzgorri_* free_by_* friends_by_* "
              "greentock_* life_by_* picosdeeuropa_* seeding_* sunset_by_* nature/*.jpg Autumn/contents/images/1920x1080.jpg "
              "BytheWater/contents/images/1920x1080.jpg ColdRipple/contents/images/1920x1080.jpg "
              "ColorfulCups/contents/images/1920x1080.jpg EveningGlow/contents/images/1920x1080.jpg "
              "FallenLeaf/contents/images/1920x1080.jpg Kite/contents/images/1920x1080.jpg Path/contents/images/1920x1080.jpg "
              "DarkestHour/contents/images/1920x1080.jpg OneStandsOut/contents/images/1920x1080.jpg").split()
OPENCV = ("aero1 aero3 aloeL apple baboon blox board box box_in_scene building butterfly ela_original fruits graf1 home leuvenA "
          "licenseplate_motion messi5 orange rubberwhale1 squirrel_cls stuff right").split()
SKIMAGE = "astronaut brick camera cell chelsea coffee coins grass gravel ihc microaneurysms moon motorcycle_left retina rocket".split()


def photographs(root):
    files = []
    for pattern in WALLPAPERS:
        for place in ("backgrounds", "wallpapers"):
            files += glob.glob(os.path.join(root, "usr/share", place, "**", pattern), recursive=True)
    for folder, names in (("usr/share/doc/opencv-doc/examples/data", OPENCV), ("usr/lib/python3/dist-packages/skimage/data", SKIMAGE)):
        for name in names:
            files += glob.glob(os.path.join(root, folder, name + ".*"))
    for name in sorted(set(files)):
        yield os.path.relpath(name, root), opened(name)


NO_CUTOUT = ("hedgehog", "cartoon", "_mirror", "_flip", "outline", "bee.png")


def cutouts(root):
    """Photographs of animals, plants and food, cut out: with nothing around them."""
    files = [f for kind in ("animals/birds", "animals/mammals", "animals/fish", "plants/flowers", "food/fruit")
             for f in glob.glob(os.path.join(root, "usr/share/tuxpaint/stamps", kind, "**/*.png"), recursive=True)]
    for name in chosen([f for f in files if not any(word in f for word in NO_CUTOUT)], 80, 1):
        yield os.path.basename(name), opened(name)


# Flat art

def icons(root, flat):
    base = os.path.join(root, "usr/share/icons")
    if flat:
        drawn = [f for f in glob.glob(base + "/Papirus/64x64/apps/*.svg") if not os.path.islink(f)]
        for number, name in enumerate(chosen(drawn, 84, 2)):
            size = (16, 24, 32, 48, 64, 128, 512)[number % 7]
            picture = of_svg(name, size)
            if picture:
                yield f"{os.path.basename(name)} {size}", picture
        return
    files = [f for theme in ("Adwaita/96x96/legacy", "oxygen/base/64x64/*", "oxygen/base/128x128/*", "oxygen/base/256x256/*",
                             "gnome/256x256/*", "gnome/48x48/*", "Tango/32x32/*") for f in
             chosen(glob.glob(f"{base}/{theme}/*.png"), 14, 3)]
    for name in files:
        yield os.path.relpath(name, base), opened(name)


def clip_art(root):
    base = os.path.join(root, "usr/share/openclipart/png")
    files = [f for kind in ("animals", "buildings", "education", "electronics", "food", "geography", "office", "people", "plants",
                            "recreation", "science", "signs_and_symbols", "tools", "transportation")
             for f in chosen(glob.glob(f"{base}/{kind}/**/*.png", recursive=True), 12, 4)]
    for name in files:
        yield os.path.relpath(name, base), opened(name)


def emoji(root):
    font = ImageFont.truetype(glob.glob(os.path.join(root, "usr/share/fonts/**/NotoColorEmoji.ttf"), recursive=True)[0], 109)
    letters = list(range(0x1f300, 0x1f3fa)) + list(range(0x1f400, 0x1f4fd)) + list(range(0x1f600, 0x1f6c5))
    for code in chosen(letters, 60, 5):
        picture = Image.new("RGB", (136, 128), "white")
        ImageDraw.Draw(picture).text((0, 0), chr(code), font=font, embedded_color=True)
        yield f"{code:x}", picture


def flags(root):
    for folder, count in (("iso-flags-png-320x240", 40), ("flags", 10)):
        for name in chosen(glob.glob(os.path.join(root, "usr/share", folder, "**/*.png"), recursive=True), count, 6):
            yield os.path.basename(name), opened(name)


# Charts, by three tools and in their styles

def figures(random):
    x = np.linspace(0, 10, 80)

    def heat():
        plt.imshow(random.uniform(0, 1, (8, 10)), cmap=random.choice(["viridis", "Blues", "hot"]))
        plt.colorbar()

    def contour():
        u, v = np.meshgrid(x, x)
        plt.contourf(u, v, np.sin(u * random.uniform(0.3, 1)) + np.cos(v * random.uniform(0.3, 1)), 7)

    return {"lines": lambda: [plt.plot(x, np.sin(x + i) * (1 + i), label=f"series {i}") for i in range(4)] and plt.legend(),
            "bars": lambda: plt.bar(range(7), random.uniform(1, 9, 7)),
            "groups": lambda: [plt.bar(np.arange(6) + 0.28 * i, random.uniform(1, 9, 6), 0.28) for i in range(3)],
            "stacked": lambda: plt.stackplot(range(12), random.uniform(1, 5, (4, 12))),
            "pie": lambda: plt.pie(random.uniform(1, 9, 6), labels=list("ABCDEF"), autopct="%d%%"),
            "scatter": lambda: plt.scatter(random.normal(5, 2, 120), random.normal(5, 2, 120), c=random.uniform(0, 1, 120)),
            "histogram": lambda: plt.hist(random.normal(0, 1, 500), 15, edgecolor="black"),
            "boxes": lambda: plt.boxplot([random.normal(m, 2, 50) for m in range(5)]),
            "steps": lambda: (plt.step(x, np.round(np.sin(x) * 4)), plt.grid(True)),
            "filled": lambda: plt.fill_between(x, np.sin(x), np.cos(x), alpha=0.4),
            "heat": heat, "contour": contour}


STYLES = ("default", "dark_background", "ggplot", "grayscale", "Solarize_Light2", "bmh", "fivethirtyeight")


def charts(style_set):
    for number, style in enumerate(STYLES):
        if (style == "dark_background") != (style_set == "dark"):
            continue
        for repeat in range(3 if style_set == "dark" else 1):
            generator = np.random.default_rng(100 * repeat + number)
            for name, figure in figures(generator).items():
                with plt.style.context(style):
                    plt.figure(figsize=(6.4, 4.8), dpi=int(generator.choice([60, 100, 150])))
                    figure()
                    plt.title(f"{name} by month")
                    plt.xlabel("Time in s")
                    plt.ylabel("Value")
                    buffer = io.BytesIO()
                    plt.savefig(buffer)
                    plt.close()
                yield f"{style} {name} {repeat}", on_white(Image.open(buffer))


GNUPLOT = ["plot sin(x), cos(x) with linespoints", "set style fill solid; plot 'data' with boxes", "splot x**2-y**2",
           "set pm3d map; splot sin(x)*cos(y)", "plot for [i=1:4] i*x**2 with lines lw 3", "set polar; plot t",
           "set grid; plot besj0(x) with filledcurves y=0", "plot 'data' with impulses lw 8"]
GRAPHS = ["digraph{rankdir=LR; a->b->c->d; b->e->d; a->f}", "graph{node[shape=box]; a--b--c--a; c--d; d--e--f--d}",
          "digraph{bgcolor=lightyellow; node[style=filled,fillcolor=lightblue]; start->read->check->done; check->read}",
          "digraph{bgcolor=\"#204060\"; node[style=filled,fillcolor=orange]; edge[color=white]; a->{b c d}; c->{e f}}",
          "digraph{bgcolor=black; node[color=white,fontcolor=white]; edge[color=gray]; x->y->z->x; z->w}",
          "digraph{node[shape=record,style=filled,fillcolor=\"#ccffcc\"]; a[label=\"one|two|three\"]; b[label=\"{u|v}\"]; a->b}"]


def diagrams(folder):
    with open(os.path.join(folder, "data"), "w", encoding="ascii") as file:
        file.writelines(f"{i} {(7 * i) % 11 + 1}\n" for i in range(12))
    for number, plot in enumerate(GNUPLOT):
        run = subprocess.run(["gnuplot", "-e", f"set terminal png size 700,500; {plot}"], cwd=folder, capture_output=True, check=True)
        yield f"gnuplot {number}", on_white(Image.open(io.BytesIO(run.stdout)))
    for number, graph in enumerate(GRAPHS):
        run = subprocess.run(["dot", "-Tpng"], input=graph.encode(), capture_output=True, check=True)
        yield f"graphviz {number}", on_white(Image.open(io.BytesIO(run.stdout)))
    font = ImageFont.truetype("/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", 15)
    for number, (ground, ink) in enumerate((("white", "black"), ("#1e1e1e", "#d4d4d4"), ("#002b36", "#93a1a1"), ("#fdf6e3", "#586e75"))):
        picture = Image.new("RGB", (800, 560), ground)
        pen, words = ImageDraw.Draw(picture), random.Random(number)
        pen.rectangle((0, 0, 800, 26), fill="#3465a4" if number % 2 else "#cccccc")
        for line in range(24):
            text = " ".join("".join(words.choice("etaoinshrdlu") for _ in range(words.randint(2, 9))) for _ in range(words.randint(2, 11)))
            pen.text((20, 40 + 21 * line), text, fill=ink, font=font)
        yield f"screen {number}", picture


# Maps

def maps(root, count=40):
    base = os.path.join(root, "usr/share/kgeography")
    files = [f for f in glob.glob(base + "/**/*.png", recursive=True) if "flags" not in f and os.path.getsize(f) > 4000]
    for name in chosen(files, count, 8):
        yield os.path.relpath(name, base), opened(name)
    for number in range(20):  # own: land and sea of a smooth random height, provinces of the nearest towns
        generator = np.random.default_rng(number)
        height = sum(np.kron(generator.normal(0, 1, (4 * 2**k, 5 * 2**k)), np.ones((128 // 2**k, 128 // 2**k))) / 1.6**k
                     for k in range(4))
        land = np.asarray(Image.fromarray(np.clip(128 + 32 * height, 0, 255).astype(np.uint8)).filter(ImageFilter.BoxBlur(20))) > 125
        towns = generator.uniform(0, 1, (12, 2)) * land.shape
        rows, columns = np.indices(land.shape)
        nearest = np.argmin([(rows - r) ** 2 + (columns - c) ** 2 for r, c in towns], axis=0)
        picture = np.array([[200, 225, 250]] * 1 + [generator.integers(110, 250, 3) for _ in towns])[np.where(land, nearest + 1, 0)]
        if number % 2:
            edges = (np.roll(picture, 1, 0) != picture).any(2) | (np.roll(picture, 1, 1) != picture).any(2)
            picture[np.asarray(Image.fromarray(edges.astype(np.uint8)).filter(ImageFilter.MaxFilter(3))) > 0] = 60
        yield f"drawn {number}", Image.fromarray(picture.astype(np.uint8)).resize((600, 480), Image.LANCZOS)


# Line art

def line_art(root, folder):
    files = [f for f in glob.glob(os.path.join(root, "usr/share/xfig/Libraries/**/*.fig"), recursive=True)
             if not any(word in f for word in ("Flags", "Maps", "Symbols", "Icons"))]
    for name in chosen(files, 30, 9):
        run = subprocess.run(["fig2dev", "-L", "svg", name], capture_output=True, check=False)
        drawn = os.path.join(folder, "figure.svg")
        with open(drawn, "wb") as file:
            file.write(run.stdout)
        picture = of_svg(drawn, 500) if run.returncode == 0 else None
        if picture and np.asarray(picture.convert("L")).std() > 3:
            yield os.path.relpath(name, os.path.join(root, "usr/share/xfig/Libraries")), ImageOps.expand(picture, 20, "white")
    for number in range(24):  # own: handwriting in ink of four colours, and hatching that follows a shape
        generator = np.random.default_rng(number)
        picture = Image.new("RGB", (1200, 900), "white")
        pen, ink = ImageDraw.Draw(picture), ("#101010", "#1a2a80", "#a02020", "#206030")[number % 4]
        if number % 3 == 2:
            for row in range(80, 820, 14):
                shade = np.clip(5 + 4 * np.sin(np.arange(150) / 19 + row / 90), 1, 8)
                for i in range(149):
                    x = 40 + 7.5 * i
                    if (x - 600) ** 2 / 1.7 + (row - 450) ** 2 < 350**2:
                        pen.line((x, row + 6 * np.sin(i / 9), x + 7.5, row + 6 * np.sin((i + 1) / 9)), fill=ink, width=int(shade[i]))
        else:
            for line in range(5 if number % 3 else 3):
                t = np.arange(0, 420)
                size = 30 if number % 3 else 90
                x = 80 + 2.4 * t + size * 0.6 * np.sin(t / 6 + generator.uniform(0, 6))
                y = 150 + line * 150 + size * np.cos(t / 6) * np.interp(t, np.arange(0, 430, 10), generator.uniform(0.2, 1, 43))
                pen.line(list(zip(x, y)), fill=ink, width=int(generator.integers(3, 9)), joint="curve")
        yield f"drawn {number}", picture.resize((800, 600), Image.LANCZOS)


# Scans

def scanned(picture, seed):
    """Paper grain, uneven light, skew, what shines through from the back, and JPEG."""
    generator = np.random.default_rng(seed)
    large = picture.resize((900, max(1, 900 * picture.height // picture.width)), Image.LANCZOS)
    large = large.rotate(generator.uniform(-2, 2), Image.BICUBIC, fillcolor="white").filter(ImageFilter.GaussianBlur(0.8))
    level = np.asarray(large, float)
    level *= 1 - 0.08 * (1 - level[:, ::-1].mean(2, keepdims=True) / 255)  # the back
    v, u = np.meshgrid(*[np.linspace(-1, 1, n) for n in level.shape[:2]], indexing="ij")
    light = 1 - 0.08 * (u * u + v * v) - generator.uniform(0, 0.12) * (u + 1)
    paper = np.array([[1, 1, 1], [1, 0.95, 0.86], [0.85, 0.85, 0.85]][seed % 3])
    grain = generator.normal(0, generator.uniform(2, 8), level.shape[:2])[..., None]
    return as_jpeg(Image.fromarray(np.clip(level * light[..., None] * paper + grain, 0, 255).astype(np.uint8)), 70)
