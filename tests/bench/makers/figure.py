# SPDX-License-Identifier: Apache-2.0
"""What a maker of figures gives: its files, and the truth that its own script knows."""
import dataclasses
import json
import os
import re
import shutil
import subprocess
import sys

# Degrees turned, pixels of blur, deviation of the noise in grey levels, and whether it is coarser than pixels, under uneven light.
SCANS = {"scan": (0.4, 0.8, 7, False), "fine scan": (0.2, 0.6, 4, False), "soft scan": (-0.5, 1.0, 10, False),
         "coarse scan": (0.9, 0.8, 6, True)}
RENDERED = ("PNG", "JPEG", *SCANS, "PDF")  # of hand-written SVG by a program that shows less than the file says


@dataclasses.dataclass
class Figure:
    maker: str
    name: str
    files: dict  # form ("SVG", "SVG glyphs", "PNG", "PDF") to path
    words: list = dataclasses.field(default_factory=list)  # (text, x, y): middle in percent from left and top; None: not known
    arrows: list = dataclasses.field(default_factory=list)  # (x, y, x, y): the tip, and a place behind it on the line; in percent, too
    curves: list = dataclasses.field(default_factory=list)  # (look, [(x, y), ...]); of one look is what a reader takes for one
    bars: list = dataclasses.field(default_factory=list)  # (look, left, top, right, bottom)
    points: list = dataclasses.field(default_factory=list)  # (x, y) of filled marks
    samples: list = dataclasses.field(default_factory=list)  # of a legend: (look, words, left, top, right, bottom)
    title: str = ""  # what is its title at the top; most drawings and graphs have none
    pixel_words: list = None  # words, where a rendering of it shows others


    def words_as(self, form):
        return self.pixel_words if form in RENDERED and self.pixel_words is not None else self.words

    def keep_truth(self, folder):
        """All that is known of it, beside its files."""
        with open(os.path.join(folder, f"{self.maker}-{self.name}.truth.json"), "w", encoding="utf-8") as file:
            json.dump(dataclasses.asdict(self), file, indent=1)


def in_percent(points, wide, high):
    return [(100 * x / wide, 100 * y / high) for x, y in points]


def missing(*programs):
    """Of these programs the first that is not installed, or nothing."""
    return next((program for program in programs if shutil.which(program) is None), None)


def run(*command, text=None):
    done = subprocess.run(command, input=text, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise RuntimeError(f"{command[0]}: {done.stderr.strip()[-400:]}")
    return done.stdout


def renderings(svg, dpi, forms=("PNG", "PDF")):
    """PNG and PDF of an SVG by librsvg, where it is installed."""
    if missing("rsvg-convert"):
        return {}
    stem = os.path.splitext(svg)[0]
    files = {}
    for form in forms:
        files[form] = f"{stem}.{form.lower()}"
        run("rsvg-convert", "--format", form.lower(), "--zoom", str(dpi / 96), "--background-color", "white", "--output", files[form],
            svg)
    return files


def outlined(source, target):
    """An SVG with its texts as paths, as Inkscape makes them, without the labels by which it says what they were."""
    if not shutil.which("inkscape"):
        sys.exit("figures: Inkscape is missing, which makes outlines; install inkscape")
    subprocess.run(["inkscape", source, "--export-text-to-path", "--export-plain-svg", "-o", target], check=True, capture_output=True)
    with open(target, encoding="utf-8") as file:
        text = file.read()
    with open(target, "w", encoding="utf-8") as file:
        file.write(re.sub(r'\saria-label="[^"]*"', "", text))


def copies(png, form):
    """Of a PNG what people send instead: a JPEG, and a scan of its print, grey, soft, noisy and not quite level; others if asked for."""
    import numpy
    from PIL import Image, ImageFilter

    stem = os.path.splitext(png)[0]
    files = {}
    with Image.open(png) as opened:
        picture = opened.convert("RGB")
    if form in (None, "JPEG"):
        files["JPEG"] = stem + ".jpg"
        picture.save(files["JPEG"], quality=75)
    if (form or "scan") in SCANS:
        name = form or "scan"
        degrees, blur, deviation, coarse = SCANS[name]
        files[name] = f"{stem}.{name.replace(' ', '-')}.png"
        turned = picture.convert("L").rotate(degrees, Image.Resampling.BICUBIC, fillcolor=255).filter(ImageFilter.GaussianBlur(blur))
        noise = numpy.random.default_rng(7).normal(0, deviation, (picture.height, picture.width))
        if coarse:
            noise = sum(numpy.roll(noise, (down, across), (0, 1)) for down in (0, 1) for across in (0, 1)) / 2
            noise -= 20 * numpy.linspace(0, 1, picture.width)[None, :]
        grey = 25 + numpy.asarray(turned, dtype=float) * (242 - 25) / 255 + noise
        Image.fromarray(grey.round().clip(0, 255).astype("uint8")).save(files[name])
    return files
