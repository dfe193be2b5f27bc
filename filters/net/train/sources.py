#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Fetches the photographs that scenes.py may use from packages of Debian 12, all of them under free terms.

    sources.py OUT

Writes OUT/PACKAGE/*.png, at most 1000 pixels long, and OUT/SOURCES.txt: package, version, what its copyright file says. None
of them is part of tactics; nothing is installed. Needs apt-get and dpkg-deb.

    package                        what                                            terms
    tuxpaint-stamps-default        things cut out: animals, fruit, tools, cars     GPL-2
    gcompris-qt-data               animals, monuments, tools, mills, fish          CC0, public domain, CC-BY, CC-BY-SA, a few GPL and GFDL
    stellarium-data                panoramas without their sky                     GPL-2+
    plasma-workspace-wallpapers    landscapes, patterns                            LGPL-3, GPL-2+
    mate-backgrounds               plants, water                                   GPL-2+
    lomiri-wallpapers-16.04, 20.04 animals, landscapes, things                     CC0, CC-BY-4.0, CC-BY-SA-3.0 and 4.0
    palapeli-data                  a bridge, a castle, a bee, a chameleon          GPL-2+
"""

import argparse
import re
import struct
import subprocess
import tempfile
import zlib
from pathlib import Path

import cv2
import numpy as np

MOST = 1000  # px

# Package, which of its files (a regular expression on the path), which of those not: drawings, signs, letters.
PACKAGES = (
    (
        "tuxpaint-stamps-default",
        r"stamps/.*\.png$",
        r"_mirror|cartoon|/(clothes|seasonal|symbols|naturalforces|body_parts|flags|toys|roadsigns|space|alphabets)/",
    ),
    ("gcompris-qt-data", r"/(categorization|explore_(monuments|world_animals|farm_animals|world_music)|erase|details|core)\.rcc$", r"^$"),
    (
        "stellarium-data",
        r"landscapes/(garching/garching-gl|guereins/guereins[1-8]\.|ocean/ocean[1-8]\.|hurricane/hurricane[1-8]\.|grossmugl/grossmugl_leeberg_crop)",
        r"^$",
    ),
    (
        "plasma-workspace-wallpapers",
        r"/(FallenLeaf|Path|DarkestHour|Volna|summer_1am|EveningGlow|Grey|Kite|ColorfulCups|OneStandsOut|ColdRipple|BytheWater)/contents/images/(2560x1600|5120x2880)\.jpg$",
        r"^$",
    ),
    ("mate-backgrounds", r"/nature/.*\.jpg$", r"^$"),
    ("lomiri-wallpapers-16.04", r"backgrounds/.*\.jpg$", r"analogpattern|greentock|umang"),
    ("lomiri-wallpapers-20.04", r"backgrounds/Kleiber.*\.jpg$", r"^$"),
    ("palapeli-data", r"collection/.*\.jpg$", r"^$"),
)


def carved(resource):
    """The pictures in a resource file of Qt: its data are entries of a length (32 bits) and so many bytes."""
    if resource[:4] != b"qres":
        return
    tree, data, names = struct.unpack(">III", resource[8:20])
    at, end = data, min([place for place in (tree, names, len(resource)) if place > data])
    while at + 4 <= end:
        length = struct.unpack(">I", resource[at : at + 4])[0]
        entry, at = resource[at + 4 : at + 4 + length], at + 4 + length
        if entry[4:6] in (b"\x78\x9c", b"\x78\xda"):
            try:
                entry = zlib.decompress(entry[4:])
            except zlib.error:
                continue
        if entry[:3] == b"\xff\xd8\xff" or entry[:4] == b"\x89PNG" or entry[8:12] == b"WEBP":
            yield entry


def photograph(encoded, whole):
    """The picture, or None: too small, of one channel, a drawing on white or (whole) clear in parts."""
    picture = cv2.imdecode(np.frombuffer(encoded, np.uint8), cv2.IMREAD_UNCHANGED)
    if picture is None or picture.ndim != 3 or picture.dtype != np.uint8 or min(picture.shape[:2]) < (200 if whole else 90):
        return None
    if whole and picture.shape[2] == 4:
        if (picture[..., 3] < 250).mean() > 0.003:
            return None
        picture = picture[..., :3]
    if whole and (picture.min(2) > 245).mean() > 0.35:
        return None
    scale = MOST / max(picture.shape[:2])
    return cv2.resize(picture, None, fx=scale, fy=scale, interpolation=cv2.INTER_AREA) if scale < 1 else picture


def fetch(package, out):
    name, wanted, unwanted = package
    with tempfile.TemporaryDirectory() as place:
        place = Path(place)
        place.chmod(0o755)
        subprocess.run(["apt-get", "download", "-q", name], cwd=place, check=True, stdout=subprocess.DEVNULL)
        archive = next(place.glob("*.deb"))
        subprocess.run(["dpkg-deb", "-x", archive, place / "tree"], check=True)
        (out / name).mkdir(parents=True, exist_ok=True)
        kept = 0
        for path in sorted(p for p in (place / "tree").rglob("*") if p.is_file()):
            inside = "/" + str(path.relative_to(place / "tree"))
            if not re.search(wanted, inside) or re.search(unwanted, inside):
                continue
            bytes_of_file, resource = path.read_bytes(), path.suffix == ".rcc"
            for number, encoded in enumerate(carved(bytes_of_file) if resource else [bytes_of_file]):
                picture = photograph(encoded, resource)
                if picture is not None:
                    short = re.sub(r"[^A-Za-z0-9.-]+", "_", "_".join(Path(inside).parts[-4:]))
                    cv2.imwrite(str(out / name / f"{short}{'_%d' % number if resource else ''}.png"), picture)
                    kept += 1
        terms = (place / "tree/usr/share/doc" / name / "copyright").read_text(errors="replace")
        licences = sorted(set(re.findall(r"^License: *(\S.*)$", terms, re.M)))
        return f"{name} {archive.name.split('_')[1]}: {kept} pictures; its copyright file names {', '.join(licences)}\n"


def main():
    words = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("out", type=Path, metavar="OUT")
    out = words.parse_args().out
    notes = []
    for package in PACKAGES:
        notes.append(fetch(package, out))
        print(notes[-1], end="", flush=True)
    (out / "SOURCES.txt").write_text("".join(notes))


if __name__ == "__main__":
    main()
