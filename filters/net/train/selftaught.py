#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Writes photographs with the contours that a net finds in them once they must be closed, for train.py: no labels needed.

    selftaught.py NET.pt OUT --photos FOLDER... [--levels .08,.13,.19,.27,.4]

The net looks at every photograph at several sizes and mirrored. What it says floods into regions (watershed), and regions are
merged, those first between which it says least; small and alike ones earlier. A border is worth as much as it takes to merge
what it parts. Each level of that makes one annotator: what is drawn at the highest is drawn by all.

The photographs of sources.py and scenes.py make a net without any others' terms:

    sources.py FREE
    scenes.py FIRST --count 400 --photos FREE
    train.py FIRST --out first.pt --steps 3000
    selftaught.py first.pt FOUND --photos FREE
    scenes.py SECOND --count 400 --seed 2 --photos FREE --drawn FOUND
    train.py FIRST SECOND FOUND --out net.pt
"""

import argparse
import heapq
from pathlib import Path

import cv2
import numpy as np
import torch
import torch.nn.functional as F
from skimage.measure import label as connected
from skimage.morphology import h_minima
from skimage.segmentation import watershed

from model import ContourNet
from photos import light_of, normalise

LONG = 480  # px
SCALES = (0.6, 1.0, 1.5)
SMALL = 0.012  # of the picture: regions below that join others earlier, as people leave out what is small
ALIKE = 25  # Lab: regions whose mean colours are nearer than that join earlier


@torch.no_grad()
def said(net, image, scale):
    h, w = image.shape[:2]
    light = light_of(image)
    scaled = cv2.resize(image, None, fx=scale, fy=scale, interpolation=cv2.INTER_AREA if scale < 1 else cv2.INTER_LINEAR)
    x = normalise(cv2.copyMakeBorder(scaled, 0, -scaled.shape[0] % 16, 0, -scaled.shape[1] % 16, cv2.BORDER_REFLECT_101), light)
    x = torch.from_numpy(np.float32(x).transpose(2, 0, 1)[None].copy())
    logits = 0.5 * (net(x) + net(x.flip(3)).flip(3))
    logits = F.interpolate(logits, scale_factor=2, mode="bilinear", align_corners=False)[0, 0, : scaled.shape[0], : scaled.shape[1]]
    return cv2.resize(logits.numpy(), (w, h), interpolation=cv2.INTER_LINEAR)


def agreed(net, image):
    """0 to 1 for every pixel, all sizes taken together."""
    return 1 / (1 + np.exp(-np.mean([said(net, image, scale) for scale in SCALES], 0)))


def merged(strength, image):
    """(regions, list of (cost, first, second)): the order in which regions join, costs never falling."""
    soft = cv2.GaussianBlur(np.float32(strength), (0, 0), 1.0)
    seeds = connected(h_minima(np.round(soft * 200).astype(np.int32), 2), connectivity=2)
    regions = watershed(soft, seeds) - 1
    many = int(regions.max()) + 1
    colour = cv2.cvtColor(np.float32(image) / 255, cv2.COLOR_BGR2Lab)
    area = np.bincount(regions.ravel(), minlength=many).astype(float)
    total = np.stack([np.bincount(regions.ravel(), colour[..., c].ravel(), many) for c in range(3)], 1)
    borders = [dict() for _ in range(many)]  # neighbour: [sum of strength, length]
    for first, second, left, right in (
        (regions[:, :-1], regions[:, 1:], strength[:, :-1], strength[:, 1:]),
        (regions[:-1], regions[1:], strength[:-1], strength[1:]),
    ):
        at = first != second
        for a, b, s in zip(first[at], second[at], np.maximum(left[at], right[at])):
            border = borders[a].setdefault(b, [0.0, 0])
            borders[b][a] = border
            border[0] += float(s)
            border[1] += 1
    small = SMALL * regions.size

    def cost(a, b):
        mean = borders[a][b][0] / borders[a][b][1]
        alike = np.linalg.norm(total[a] / area[a] - total[b] / area[b])
        return mean * min(1.0, (min(area[a], area[b]) / small) ** 0.4) * (0.7 + 0.3 * min(alike / ALIKE, 1.0))

    alive, version = [True] * many, {}
    heap = [(cost(a, b), a, b, 0) for a in range(many) for b in borders[a] if a < b]
    heapq.heapify(heap)
    joins, highest = [], 0.0
    while heap:
        price, a, b, age = heapq.heappop(heap)
        if not (alive[a] and alive[b]) or version.get((a, b), 0) != age:
            continue
        highest = max(highest, price)
        joins.append((highest, a, b))
        alive[b] = False
        area[a] += area[b]
        total[a] += total[b]
        del borders[a][b]
        for c, border in borders[b].items():
            if c == a:
                continue
            del borders[c][b]
            if c in borders[a]:
                borders[a][c][0] += border[0]
                borders[a][c][1] += border[1]
            else:
                borders[a][c] = borders[c][a] = border
        borders[b] = {}
        for c in borders[a]:
            pair = (min(a, c), max(a, c))
            version[pair] = version.get(pair, 0) + 1
            heapq.heappush(heap, (cost(*pair), *pair, version[pair]))
    return regions, joins


def at_level(regions, joins, level):
    """Regions after all joins that cost less."""
    root = np.arange(regions.max() + 1)
    for price, a, b in joins:
        if price >= level:
            break
        root[root == root[b]] = root[a]
    return root[regions]


def borders_of(regions):
    drawn = np.zeros(regions.shape, np.uint8)
    drawn[:, :-1] |= regions[:, :-1] != regions[:, 1:]
    drawn[:-1] |= regions[:-1] != regions[1:]
    return drawn * 255


def photographs(folders):
    """Opaque pictures, their longer side LONG."""
    for path in sorted(p for folder in folders for p in Path(folder).rglob("*") if p.suffix.lower() in (".jpg", ".jpeg", ".png")):
        picture = cv2.imread(str(path), cv2.IMREAD_UNCHANGED)
        if picture is None or picture.ndim != 3 or picture.dtype != np.uint8 or min(picture.shape[:2]) < 200:
            continue
        if picture.shape[2] == 4 and (picture[..., 3] < 250).mean() > 0.003:
            continue
        scale = LONG / max(picture.shape[:2])
        way = cv2.INTER_AREA if scale < 1 else cv2.INTER_LINEAR
        yield path.stem, cv2.resize(picture[..., :3], None, fx=scale, fy=scale, interpolation=way)


def main():
    words = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("net", type=Path, metavar="NET.pt")
    words.add_argument("out", type=Path, metavar="OUT")
    words.add_argument("--photos", nargs="+", required=True, metavar="FOLDER")
    words.add_argument("--levels", default=".08,.13,.19,.27,.4")
    asked = words.parse_args()
    cv2.setNumThreads(1)
    torch.set_num_threads(1)
    net = ContourNet().eval()
    net.load_state_dict(torch.load(asked.net)["average"])
    for folder in ("images", "gt"):
        (asked.out / folder).mkdir(parents=True, exist_ok=True)
    for name, image in photographs(asked.photos):
        regions, joins = merged(agreed(net, image), image)
        cv2.imwrite(str(asked.out / "images" / f"{name}.jpg"), image, [cv2.IMWRITE_JPEG_QUALITY, 92])
        for k, level in enumerate(asked.levels.split(",")):
            cv2.imwrite(str(asked.out / "gt" / f"{name}_gt{k + 1}.png"), borders_of(at_level(regions, joins, float(level))))


if __name__ == "__main__":
    main()
