# SPDX-License-Identifier: Apache-2.0
"""Photographs with the contours that people drew on them, and crops of them to learn from.

A folder has images/NAME.jpg (or .png) and gt/NAME_gtK.png, K = 1, 2, ...: what annotator K drew, non-zero on a contour,
of the image's size.
"""

from pathlib import Path
from typing import NamedTuple

import cv2
import numpy as np

SPREAD = 2.0  # px of the half-size picture: the label falls off around a contour as exp(-d^2 / (2 SPREAD^2))
DISTANCE_STEPS = 16  # distances are kept in sixteenths of a pixel, up to 255 of them


class Photo(NamedTuple):
    image: np.ndarray  # H x W x 3, blue green red, 8 bits
    distances: np.ndarray  # annotators x H x W: to the next contour
    light: tuple  # mean and standard deviation of the luminance


def light_of(image):
    luminance = image.astype(np.float32) @ np.float32([0.114, 0.587, 0.299])
    return float(luminance.mean()), float(luminance.std())


def normalise(image, light):
    """The picture less its mean luminance, one gain for the whole of it: contrast is evened out, within bounds."""
    mean, deviation = light
    return (np.float32(image) - mean) * (np.clip(48 / max(deviation, 1e-3), 0.7, 5) / 64)


def read_photo(path, folder):
    image = cv2.imread(str(path))
    if image is None:
        raise SystemExit(f"{path}: not a picture that can be read")
    drawn = sorted((folder / "gt").glob(path.stem + "_gt*.png"))
    if not drawn:
        raise SystemExit(f"{path}: there is no {folder / 'gt' / path.stem}_gt1.png with its contours")
    distances = []
    for file in drawn:
        contour = cv2.imread(str(file), cv2.IMREAD_GRAYSCALE)
        if contour is None or contour.shape != image.shape[:2]:
            raise SystemExit(f"{file}: not a picture of the size of {path.name}")
        away = cv2.distanceTransform(np.uint8(contour == 0), cv2.DIST_L2, 5) if contour.any() else np.full(contour.shape, 99, np.float32)
        distances.append(np.uint8(np.clip(np.round(away * DISTANCE_STEPS), 0, 255)))
    return Photo(image, np.stack(distances), light_of(image))


def read_folder(folder):
    folder = Path(folder)
    paths = sorted(p for p in (folder / "images").glob("*") if p.suffix.lower() in (".jpg", ".jpeg", ".png"))
    if not paths:
        raise SystemExit(f"{folder}: there are no pictures in {folder / 'images'}")
    return [read_photo(path, folder) for path in paths]


def blank_crop(chance, side):
    """Nothing to draw: flat, or shaded, with noise."""
    down, across = np.mgrid[0:side, 0:side].astype(np.float32) / side
    colour = chance.uniform(20, 235, 3) + (chance.normal(0, 40) * across + chance.normal(0, 40) * down)[..., None] * chance.uniform(0, 1)
    noisy = np.clip(np.round(colour + chance.normal(0, chance.choice([0, 2, 5, 10, 20]), (side, side, 3))), 0, 255)
    return normalise(noisy, light_of(noisy)), np.zeros((side // 2, side // 2), np.float32)


def damaged(image, chance):
    """As pictures come: by JPEG, or with noise, or as they are."""
    kind = chance.random()
    if kind < 0.15:
        good = [cv2.IMWRITE_JPEG_QUALITY, int(chance.uniform(30, 90))]
        return cv2.imdecode(cv2.imencode(".jpg", image, good)[1], cv2.IMREAD_COLOR).astype(np.float32)
    image = np.float32(image)
    return image + chance.normal(0, chance.uniform(2, 14), image.shape).astype(np.float32) if kind < 0.3 else image


def crop(photos, chance, side):
    """(picture, label): a square of a photograph, turned, mirrored and scaled by chance, and at half its size the share of
    people who drew there."""
    if chance.random() < 0.04:
        return blank_crop(chance, side)
    photo = photos[chance.integers(len(photos))]
    height, width = photo.image.shape[:2]
    scale = 1.0 if chance.random() < 0.3 else float(np.exp(chance.uniform(np.log(0.6), np.log(1.6))))
    turn = np.deg2rad(chance.integers(4) * 90 + (0 if chance.random() < 0.4 else chance.uniform(-45, 45)))
    mirror = -1 if chance.random() < 0.5 else 1
    rotation = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]]) @ np.diag([mirror, 1]) / scale
    reach = side / 2 / scale * 0.75  # most of the crop lies inside
    middle = np.array([chance.uniform(min(reach, n / 2), max(n - reach, n / 2)) for n in (width, height)])
    origin = middle - rotation @ np.array([(side - 1) / 2] * 2)
    image = cv2.GaussianBlur(photo.image, (0, 0), 0.4 / scale) if scale < 0.8 else photo.image
    warp = dict(flags=cv2.INTER_LINEAR | cv2.WARP_INVERSE_MAP, borderMode=cv2.BORDER_REFLECT_101)
    picture = cv2.warpAffine(image, np.float32(np.c_[rotation, origin]), (side, side), **warp)
    halved = np.float32(np.c_[rotation * 2, rotation @ np.array([0.5, 0.5]) + origin])
    label = np.zeros((side // 2, side // 2), np.float32)
    for distances in photo.distances:
        away = cv2.warpAffine(distances, halved, (side // 2, side // 2), **warp).astype(np.float32) * (scale / DISTANCE_STEPS)
        label += np.exp(-(away**2) / (2 * SPREAD**2))
    picture = normalise(damaged(picture, chance), photo.light)
    if chance.random() < 0.5:
        picture = picture * np.float32(np.exp(chance.normal(0, 0.2))) + np.float32(chance.normal(0, 0.1, 3))
    return np.float32(picture), label / len(photo.distances)
