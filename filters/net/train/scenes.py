#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Writes scenes whose contours are known, for train.py: a folder as photos.py says.

    scenes.py OUT [--count 400] [--seed 1] [--photos FOLDER...] [--drawn FOLDER...]

Every scene is put together from layers: skies, grounds, drawn things, and, where folders of photographs are given (freely
licensed ones: see sources.py), surfaces, colours, backgrounds out of focus and things cut out of them (pictures that are
clear around a thing, or above a skyline). --drawn are folders as photos.py says, such as selftaught.py writes: some of the
scenes have one of these photographs as their background, with its contours. Several annotators agree on the borders of things and less on parts, on what is
small and on what is hardly seen. The same photographs, count, seed and libraries give the same scenes.
"""

import argparse
from pathlib import Path

import cv2
import numpy as np

from cutouts import Sources
from textures import ground, mix, noise, sky, smooth, texture
from things import DRAWN_THINGS, Part, Thing, blob_outline, filled

LONG, SHORT = 480, 320  # px of a scene
OVER = 1.5  # scenes are put together enlarged by this, then made small
ANNOTATORS = 5


class Scene:
    """A picture and, for every pixel, which border it may be inside of: labels of parts, each part of an owner."""

    def __init__(self, chance, sources):
        self.chance, self.sources, self.looks = chance, sources, sources.looks
        w, h = (LONG, SHORT) if chance.random() < 0.7 else (SHORT, LONG)
        self.h, self.w = int(h * OVER), int(w * OVER)
        self.image = np.zeros((self.h, self.w, 3), np.float32)
        self.labels = np.zeros((self.h, self.w), np.int32)
        self.owner, self.weight, self.owner_weight = [0], [1.0], [1.0]
        self.drawn = []  # contours of the background, where label 0 is still seen

    def cover(self, image, mask=None, weight=1.0, ragged=0.5, blur=0.0):
        """A layer of the whole scene: a sky, a hill, a floor."""
        if mask is None:
            mask = np.ones((self.h, self.w), np.float32)
        self.put(Thing(image, mask, [Part(mask, 1.0)], ragged), 0, 0, weight, blur, shadow=False)

    def put(self, thing, x, y, weight=1.0, blur=0.0, shadow=None, light=1.0):
        """A thing with its upper left corner at (x, y)."""
        x, y = int(x), int(y)
        left, top = max(x, 0), max(y, 0)
        right, bottom = min(x + thing.alpha.shape[1], self.w), min(y + thing.alpha.shape[0], self.h)
        if right - left < 4 or bottom - top < 4:
            return
        there, here = (slice(top, bottom), slice(left, right)), (slice(top - y, bottom - y), slice(left - x, right - x))
        image, alpha = thing.image, thing.alpha
        if blur > 0.3:
            image, alpha = smooth(image * alpha[..., None], blur), smooth(alpha, blur)
            image = image / np.maximum(alpha, 0.02)[..., None]
        if shadow is None:
            shadow = self.chance.random() < 0.6
        if shadow:
            self.shade(thing, x, y)
        alpha = alpha[here][..., None]
        self.image[there] += (image[here] * light - self.image[there]) * alpha
        owner = len(self.owner_weight)
        extent = np.sqrt((thing.alpha > 0.5).sum())
        self.owner_weight.append(weight * float(np.clip(extent / 50, 0.25, 1)))
        for part in thing.parts:
            extent = np.sqrt((part.mask > 0.5).sum())
            seen = smooth(part.mask, thing.ragged)[here] > 0.5
            self.labels[there][seen] = len(self.owner)
            self.owner.append(owner)
            self.weight.append(part.weight * float(np.clip(extent / 35, 0.3, 1)))

    def shade(self, thing, x, y):
        """A soft shadow on what lies behind; its border is no contour."""
        chance, (h, w) = self.chance, thing.alpha.shape
        dark = np.zeros((self.h, self.w), np.float32)
        if chance.random() < 0.5:
            ellipse = ((float(x + w / 2), float(y + h * 0.97)), (float(w * 1.05), float(max(h * 0.14, 4))), 0.0)
            cv2.ellipse(dark, ellipse, 1.0, -1)
        else:
            slant, flatter = chance.normal(0, 0.8), chance.uniform(0.15, 0.6)
            to = np.float32([[1, -slant * flatter, x + slant * flatter * h], [0, flatter, y + h * (1 - flatter) * 0.98]])
            cv2.warpAffine(thing.alpha, to, (self.w, self.h), dst=dark, borderMode=cv2.BORDER_TRANSPARENT)
        self.image *= 1 - smooth(dark, chance.uniform(1.5, 10))[..., None] * chance.uniform(0.2, 0.65)

    def thing(self, size, kinds=None):
        chance = self.chance
        if self.sources.cutouts and kinds is None and chance.random() < 0.6:
            return self.sources.cutouts[chance.integers(len(self.sources.cutouts))].thing(chance, size)
        choice = [kind for kind, _ in DRAWN_THINGS if kinds is None or kind.__name__ in kinds]
        often = np.array([n for kind, n in DRAWN_THINGS if kinds is None or kind.__name__ in kinds], float)
        return choice[chance.choice(len(choice), p=often / often.sum())](chance, size, self.looks)

    def stand(self, thing, foot, x=None, **how):
        x = self.chance.uniform(-0.1, 1.1) * self.w if x is None else x
        self.put(thing, x - thing.alpha.shape[1] / 2, foot - thing.alpha.shape[0], **how)

    def below(self, line):
        """What lies below a line given as a height for every column, antialiased."""
        return np.clip(np.arange(self.h, dtype=np.float32)[:, None] - np.float32(line)[None] + 0.5, 0, 1)

    def line(self, height, rough):
        steps = noise(self.chance, 1, self.w * 2, self.chance.uniform(1.0, 1.6))[0, : self.w]
        return height + smooth(steps[None], 1.0)[0] * rough


def backdrop(scene, blur):
    """A wall, a meadow from above, a photograph out of focus."""
    chance = scene.chance
    if scene.sources.drawn and chance.random() < 0.6:
        scene.image, scene.drawn = scene.sources.drawn_photo(chance, scene.w, scene.h, OVER)
        return
    kind = chance.random()
    if kind < 0.4 and scene.sources.photos:
        photo = scene.sources.photos[chance.integers(len(scene.sources.photos))]
        side = chance.uniform(0.4, 1)
        part_h, part_w = (max(int(n * side), 60) for n in photo.shape[:2])
        y, x = (chance.integers(n - m + 1) for n, m in zip(photo.shape, (min(part_h, photo.shape[0]), min(part_w, photo.shape[1]))))
        image = cv2.resize(photo[y : y + part_h, x : x + part_w], (scene.w, scene.h), interpolation=cv2.INTER_AREA).astype(np.float32)
        scene.cover(smooth(image, chance.uniform(9, 30)))
    else:
        scene.cover(smooth(texture(chance, scene.h, scene.w, scene.looks), blur * chance.choice([0, 1, 2])))
        if chance.random() < 0.4:
            at = scene.line(chance.uniform(0.35, 0.85) * scene.h, chance.uniform(0, 8))
            scene.cover(ground(chance, scene.h, scene.w, scene.looks, -int(at.min()) + 8 if at.min() < 0 else 8), scene.below(at), 0.85, 1.0, blur)


def terrain(scene):
    """Sky, ridges, ground or water; returns the height of the horizon."""
    chance, h, w = scene.chance, scene.h, scene.w
    horizon = chance.uniform(0.2, 0.7) * h
    scene.cover(sky(chance, h, w, scene.looks))
    if scene.sources.skylines and chance.random() < 0.35:
        picture = scene.sources.skylines[chance.integers(len(scene.sources.skylines))]
        rows = np.nonzero(picture[..., 3].max(1) > 128)[0]
        side = int(min(picture.shape[1], picture.shape[0] - rows[0]) * chance.uniform(0.5, 1))
        x, y = chance.integers(picture.shape[1] - side + 1), max(rows[0] - int(side * chance.uniform(0, 0.3)), 0)
        part = cv2.resize(picture[y : y + side, x : x + int(side * 1.2)][:, :: chance.choice([-1, 1])], (w, h), interpolation=cv2.INTER_AREA)
        scene.cover(part[..., :3].astype(np.float32) * np.exp(chance.normal(0, 0.2)), part[..., 3] / np.float32(255), 1.0, 3.0)
        return max(horizon, 0.45 * h)
    haze = scene.image.mean((0, 1))
    for far in sorted(chance.uniform(0, 0.7, chance.integers(0, 4)))[::-1]:
        at = scene.line(horizon - chance.uniform(0, 0.3) * h * far, chance.uniform(2, 30))
        scene.cover(
            mix(texture(chance, h, w, scene.looks), np.float32(haze), np.full((h, w), far * chance.uniform(0.3, 1), np.float32)),
            scene.below(at),
            0.9,
            2.0,
            chance.uniform(0, 2),
        )
    at = scene.line(horizon, chance.choice([0, 1, 4]))
    if chance.random() < 0.25:
        mirrored = scene.image[::-1]
        shift = int(2 * horizon) - h
        mirrored = np.roll(mirrored, shift, 0) * chance.uniform(0.5, 0.9)
        ripple = noise(chance, h, w, 1.0, 1 / 6)
        image = smooth(mirrored, chance.uniform(1, 6)) + ripple[..., None] * chance.uniform(2, 18)
    else:
        image = np.zeros((h, w, 3), np.float32)
        top = int(max(at.min(), 0))
        image[top:] = ground(chance, h - top, w, scene.looks, chance.uniform(2, 30))
    scene.cover(image, scene.below(at), 1.0, 1.5)
    if chance.random() < 0.45:  # a road, a field, a shore
        outline = blob_outline(chance, h, w, 0.8) * [chance.uniform(0.5, 1.6), 0.5] + [chance.uniform(-0.4, 0.4) * w, horizon + 3]
        scene.cover(texture(chance, h, w, scene.looks), filled(h, w, outline) * scene.below(at), 0.7, 1.5)
    return horizon


def landscape(scene):
    chance, horizon = scene.chance, terrain(scene)
    kinds = [None, ("tree",), ("tree", "animal"), ("person",), ("building", "tree"), ("animal",)][chance.integers(6)]
    feet = np.sort(chance.uniform(horizon + 8, scene.h * 1.1, chance.integers(1, 9)))
    tall = scene.h * chance.uniform(0.4, 1.0)
    for foot in feet:
        size = tall * (foot - horizon) / (scene.h - horizon + 1) * chance.uniform(0.6, 1.2) + 18
        scene.stand(scene.thing(size, kinds if chance.random() < 0.8 else None), foot, blur=chance.choice([0, 0, 0.8]))


def close_up(scene):
    chance = scene.chance
    if chance.random() < 0.2:
        terrain(scene)
    else:
        backdrop(scene, chance.uniform(0.5, 4))
    if chance.random() < 0.4 and not scene.drawn:
        scene.image = smooth(scene.image, chance.uniform(1, 6))
    for _ in range(chance.integers(1, 4)):
        size = chance.uniform(0.45, 1.2) * scene.h
        scene.stand(scene.thing(size), chance.uniform(0.65, 1.25) * scene.h, chance.uniform(0.15, 0.85) * scene.w)
    if chance.random() < 0.25:
        scene.stand(scene.thing(scene.h, ("branch", "tree", "blob")), chance.uniform(0.9, 1.5) * scene.h, blur=chance.uniform(1, 6), weight=0.7)


def street(scene):
    chance, horizon = scene.chance, terrain(scene)
    x = -20.0
    while x < scene.w and chance.random() < 0.93:
        thing = scene.thing(scene.h * chance.uniform(0.3, 1.1), ("building",))
        scene.stand(thing, horizon + chance.uniform(0.1, 0.3) * scene.h, x + thing.alpha.shape[1] / 2, shadow=False)
        x += thing.alpha.shape[1] * chance.uniform(0.7, 1.5)
    for foot in np.sort(chance.uniform(horizon + 0.25 * scene.h, scene.h * 1.15, chance.integers(0, 7))):
        scene.stand(scene.thing(scene.h * chance.uniform(0.2, 0.7), ("person", "person", "tree", "vessel")), foot)


def group(scene):
    """Several of a kind, one before another."""
    chance = scene.chance
    horizon = terrain(scene) if chance.random() < 0.5 else (backdrop(scene, chance.uniform(0.5, 4)), 0.3 * scene.h)[1]
    size, cutouts = scene.h * chance.uniform(0.2, 0.7), scene.sources.cutouts
    kind = [("person",), ("animal",), ("vessel",), ("flower",)][chance.integers(4)]
    same = cutouts[chance.integers(len(cutouts))] if cutouts and chance.random() < 0.5 else None
    for foot in np.sort(chance.uniform(horizon + size * 0.5, scene.h * 1.1, chance.integers(3, 12))):
        own = size * chance.uniform(0.75, 1.25)
        scene.stand(same.thing(chance, own) if same else scene.thing(own, kind), foot)


def heap(scene):
    """Surfaces one upon another, of all sizes: dead leaves."""
    chance = scene.chance
    backdrop(scene, 1.0)
    for size in np.sort(scene.h * 0.12 / chance.uniform(0.08, 1, chance.integers(8, 40)))[::-1]:
        thing = scene.thing(size, ("blob",)) if chance.random() < 0.8 else scene.thing(size)
        scene.stand(thing, chance.uniform(0, 1.2) * scene.h, blur=chance.choice([0, 0, 0, 2]))


KINDS = ((landscape, 3), (close_up, 4), (street, 1.5), (group, 2), (heap, 1.5))


def photographed(scene):
    """The scene as a camera and a file would have it."""
    chance, image = scene.chance, scene.image
    h, w = image.shape[:2]
    if chance.random() < 0.4:  # patches of light and shade over everything
        field = noise(chance, h // 4, w // 4, chance.uniform(1.6, 2.4))
        shade = 1 / (1 + np.exp(-(field - chance.normal()) * chance.uniform(1, 5)))
        image = image * (1 - chance.uniform(0.1, 0.5) * cv2.resize(smooth(shade, 1.0), (w, h)))[..., None]
    y, x = np.mgrid[0:h, 0:w].astype(np.float32)
    x, y = x / w - 0.5, y / h - 0.5
    light = 1 + chance.normal(0, 0.2) * x + chance.normal(0, 0.2) * y - chance.uniform(0, 0.6) * (x * x + y * y)
    image = smooth(image * light[..., None], chance.uniform(0.3, 1.3))
    image = cv2.resize(image, (int(w / OVER), int(h / OVER)), interpolation=cv2.INTER_AREA)
    low, high = np.percentile(image[::4, ::4], (1, 99))
    if chance.random() < 0.6:
        image = (image - low) * (chance.uniform(140, 250) / max(high - low, 60)) + chance.uniform(0, 25)
    image = 255 * np.clip(image / 255, 0, 1) ** np.exp(chance.normal(0, 0.15))
    if chance.random() < 0.05:
        image = np.repeat(image.mean(2, keepdims=True), 3, 2)
    elif chance.random() < 0.5:
        grey = image.mean(2, keepdims=True)
        image = grey + (image - grey) * chance.uniform(0.4, 1.1)
    image = image + smooth(chance.normal(0, chance.uniform(0.5, 8), image.shape), chance.choice([0, 0.6]))
    if chance.random() < 0.6:
        image = image + (image - smooth(image, 1.0)) * chance.uniform(0.2, 1.2)
    if chance.random() < 0.1:  # the dark edge of a slide
        top, bottom, left, right = chance.integers(0, 6, 4) * (chance.random(4) < 0.5)
        image[:top], image[image.shape[0] - bottom :], image[:, :left], image[:, image.shape[1] - right :] = (chance.uniform(0, 40),) * 4
    return np.uint8(np.clip(np.round(image), 0, 255))


def drawings(scene, image):
    """What each annotator draws: a border counts by whose it is and by how well it is seen, and is placed nearly right."""
    chance = scene.chance
    h, w = image.shape[:2]
    labels = cv2.resize(scene.labels.astype(np.float32), (w, h), interpolation=cv2.INTER_NEAREST).astype(np.int32)
    owner, weight, owner_weight = np.array(scene.owner), np.array(scene.weight), np.array(scene.owner_weight)
    soft = smooth(image.astype(np.float32), 2.5)
    edge = np.max([np.abs(cv2.Sobel(soft, cv2.CV_32F, *way)).max(2) for way in ((1, 0), (0, 1))], 0)
    visible, maps = {}, []
    down, across = np.mgrid[0:h, 0:w].astype(np.float32)
    for person in range(ANNOTATORS):
        about = 0.15 + 0.7 * person / (ANNOTATORS - 1) + chance.normal(0, 0.04)
        off = [cv2.resize(noise(chance, h // 8, w // 8, 1.2), (w, h)) * (0.8 if person else 0) for _ in range(2)]
        own = cv2.remap(labels.astype(np.float32), across + off[0], down + off[1], cv2.INTER_NEAREST, borderMode=cv2.BORDER_REPLICATE).astype(
            np.int32
        )
        drawn = np.zeros((h, w), np.uint8)
        for dy, dx in ((0, 1), (1, 0)):
            first, second = own[: h - dy, : w - dx], own[dy:, dx:]
            at = np.nonzero(first != second)
            a, b = np.minimum(first[at], second[at]), np.maximum(first[at], second[at])
            pairs, which = np.unique(a.astype(np.int64) * len(owner) + b, return_inverse=True)
            low, high = pairs // len(owner), pairs % len(owner)
            sure = np.where(owner[low] == owner[high], weight[high] * owner_weight[owner[high]], owner_weight[owner[high]])
            contrast = np.bincount(which, edge[at], len(pairs)) / np.bincount(which, minlength=len(pairs))
            for i, pair in enumerate(pairs):  # all annotators see the same, each of them a little differently
                visible.setdefault(pair, float(np.clip((contrast[i] - 2) / 16, 0.15, 1)))
            seen = np.array([visible[pair] for pair in pairs])
            drawn[at] |= np.uint8((sure * seen**0.5 + chance.normal(0, 0.08, len(pairs)) > about)[which])
        if scene.drawn:
            drawn |= np.uint8(scene.drawn[min(person, len(scene.drawn) - 1)] & (own == 0))
        maps.append(drawn * 255)
    return maps


def make(chance, sources):
    often = np.array([n for _, n in KINDS], float)
    scene = Scene(chance, sources)
    KINDS[chance.choice(len(KINDS), p=often / often.sum())][0](scene)
    image = photographed(scene)
    return image, drawings(scene, image)


def main():
    words = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("out", type=Path, metavar="OUT")
    words.add_argument("--count", type=int, default=400)
    words.add_argument("--seed", type=int, default=1)
    words.add_argument("--photos", nargs="+", default=[], metavar="FOLDER")
    words.add_argument("--drawn", nargs="+", default=[], metavar="FOLDER")
    asked = words.parse_args()
    cv2.setNumThreads(1)
    sources = Sources(asked.photos, asked.drawn)
    print(f"{len(sources.photos)} photographs, {len(sources.cutouts)} cut-outs, {len(sources.skylines)} skylines", flush=True)
    for folder in ("images", "gt"):
        (asked.out / folder).mkdir(parents=True, exist_ok=True)
    for number in range(asked.count):
        image, maps = make(np.random.default_rng([asked.seed, number]), sources)
        cv2.imwrite(str(asked.out / "images" / f"scene{number:05}.jpg"), image, [cv2.IMWRITE_JPEG_QUALITY, 92])
        for k, drawn in enumerate(maps):
            cv2.imwrite(str(asked.out / "gt" / f"scene{number:05}_gt{k + 1}.png"), drawn)


if __name__ == "__main__":
    main()
