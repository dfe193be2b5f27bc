# SPDX-License-Identifier: Apache-2.0
"""The pictures that scenes are made of: photographs, things cut out of them, skylines, and photographs with contours."""

from pathlib import Path

import cv2
import numpy as np
from skimage.morphology import thin

from textures import Looks, smooth
from things import Part, Thing, mirrored_thing

MOST = 1000  # px: photographs are kept no longer than this


class Cutout:
    """A thing of a photograph, clear around it; where its colours change a lot inside, few people draw that."""

    def __init__(self, picture):
        rows, columns = np.nonzero(picture[..., 3] > 20)
        self.picture = np.ascontiguousarray(picture[rows.min() : rows.max() + 1, columns.min() : columns.max() + 1])
        self.inner = None

    def find_parts(self):
        size = max(self.picture.shape[:2])
        small = cv2.resize(self.picture, None, fx=160 / size, fy=160 / size, interpolation=cv2.INTER_AREA)
        colour = smooth(cv2.cvtColor(small[..., :3], cv2.COLOR_BGR2Lab), 3).astype(np.float32)
        inside = small[..., 3] > 128
        self.inner = []
        if inside.sum() < 400:
            return
        cv2.setRNGSeed(1)
        _, kind, centres = cv2.kmeans(colour[inside], 3, None, (3, 20, 0.5), 2, cv2.KMEANS_PP_CENTERS)
        most = np.bincount(kind.ravel(), minlength=3).argmax()
        for k in range(3):
            apart = float(np.linalg.norm(centres[k] - centres[most]))
            mask = np.zeros(inside.shape, np.uint8)
            mask[inside] = (kind.ravel() == k) * 255
            mask = cv2.medianBlur(mask, 9)
            if k != most and apart > 18 and mask.mean() > 255 * 0.02:
                self.inner.append((mask, float(np.clip((apart - 10) / 150, 0.1, 0.4))))

    def thing(self, chance, size):
        if self.inner is None:
            self.find_parts()
        scale = size / max(self.picture.shape[:2])
        wanted = [max(int(n * scale), 4) for n in self.picture.shape[1::-1]]
        picture = cv2.resize(self.picture, wanted, interpolation=cv2.INTER_AREA if scale < 1 else cv2.INTER_LINEAR).astype(np.float32)
        alpha = picture[..., 3] / 255
        parts = [Part(alpha, 1.0)] + [Part(np.float32(cv2.resize(mask, wanted)) / 255 * alpha, weight) for mask, weight in self.inner]
        length = cv2.morphologyEx(np.uint8(alpha > 0.5), cv2.MORPH_GRADIENT, np.ones((3, 3))).sum() / 2
        jagged = length / np.sqrt(max((alpha > 0.5).sum(), 1))  # 3.5 of a disc
        image = picture[..., :3] * np.exp(chance.normal(0, 0.12)) + chance.normal(0, 6, 3)
        thing = Thing(image, alpha, parts, float(np.clip((jagged - 6) / 5, 0.5, 3.5)))
        return mirrored_thing(thing) if chance.random() < 0.5 else thing


class Sources:
    def __init__(self, folders, drawn=()):
        self.photos, self.cutouts, self.skylines = [], [], []
        self.drawn = sorted(p for folder in drawn for p in (Path(folder) / "images").glob("*.jpg"))
        for path in sorted(p for folder in folders for p in Path(folder).rglob("*") if p.suffix.lower() in (".jpg", ".jpeg", ".png", ".webp")):
            picture = cv2.imread(str(path), cv2.IMREAD_UNCHANGED)
            if picture is None or picture.ndim != 3 or min(picture.shape[:2]) < 90 or picture.dtype != np.uint8:
                continue
            scale = MOST / max(picture.shape[:2])
            if scale < 1:
                picture = cv2.resize(picture, None, fx=scale, fy=scale, interpolation=cv2.INTER_AREA)
            clear = picture[..., 3] < 128 if picture.shape[2] == 4 else np.zeros((2, 2), bool)
            if clear.mean() < 0.01:
                self.photos.append(np.ascontiguousarray(picture[..., :3]))
            elif clear[-1].mean() < 0.02 and clear[0].mean() > 0.5:
                self.skylines.append(picture)
            elif clear.mean() < 0.95:
                self.cutouts.append(Cutout(picture))
        self.looks = Looks(self.photos)

    def drawn_photo(self, chance, w, h, over):
        """One of the photographs with contours, filling w x h, and its contours at 1 / over of that, as they come."""
        path = self.drawn[chance.integers(len(self.drawn))]
        maps = [cv2.imread(str(p), cv2.IMREAD_GRAYSCALE) for p in sorted((path.parents[1] / "gt").glob(path.stem + "_gt*.png"))]
        image, mirror = cv2.imread(str(path)), int(chance.choice([-1, 1]))
        scale = max(w / image.shape[1], h / image.shape[0]) * chance.uniform(1, 1.3)
        spare = np.array([scale * image.shape[1] - w, scale * image.shape[0] - h])
        x, y = spare * chance.uniform(0, 1, 2)
        image = cv2.warpAffine(image[:, ::mirror], np.float32([[scale, 0, -x], [0, scale, -y]]), (w, h), borderMode=cv2.BORDER_REFLECT)
        small, less = (int(w / over), int(h / over)), scale / over
        to = np.float32([[less, 0, -x / over], [0, less, -y / over]])
        thick = [cv2.warpAffine(cv2.dilate(m[:, ::mirror], np.ones((3, 3))), to, small) for m in maps]
        return image.astype(np.float32), [thin(m > 127) for m in thick]
