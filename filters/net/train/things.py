# SPDX-License-Identifier: Apache-2.0
"""What stands in generated scenes: drawn by chance, part by part, or cut out of photographs that are clear around a thing."""

from typing import NamedTuple

import cv2
import numpy as np

from textures import bricks, flat, folds, grainy, leaves, noise, smooth, spots, strokes, stripes, texture

FUR, CLOTH = (strokes, grainy, flat, spots, spots), (folds, flat, stripes, grainy, spots)


class Part(NamedTuple):
    mask: np.ndarray  # H x W, 0 to 1
    weight: float  # how sure people are to draw its border: 1 always, 0.2 one in five


class Thing(NamedTuple):
    image: np.ndarray  # H x W x 3
    alpha: np.ndarray  # H x W, 0 to 1
    parts: list  # of Part, the first of them the whole
    ragged: float  # px: people draw its outline as if it were smoothed by so much


def filled(h, w, outline):
    mask = np.zeros((h, w), np.uint8)
    cv2.fillPoly(mask, [np.int32(np.round(np.asarray(outline) * 16))], 255, cv2.LINE_AA, 4)
    return np.float32(mask) / 255


def rounded(points, steps=3):
    """Chaikin's corner cutting of a closed outline."""
    points = np.asarray(points, float)
    for _ in range(steps):
        after = np.roll(points, -1, 0)
        points = np.stack([0.75 * points + 0.25 * after, 0.25 * points + 0.75 * after], 1).reshape(-1, 2)
    return points


def limb(h, w, path, thick):
    """A path of points with a thickness at each: arms, legs, necks, branches."""
    path, thick = np.asarray(path, float), np.asarray(thick, float)
    fine = np.linspace(0, len(path) - 1, 24)
    x, y, r = (np.interp(fine, np.arange(len(path)), v) for v in (path[:, 0], path[:, 1], thick))
    if len(path) > 2:
        x, y = (np.convolve(np.pad(v, 2, mode="edge"), np.ones(5) / 5, "valid") for v in (x, y))
    mask = np.zeros((h, w), np.uint8)
    for i in range(len(fine)):
        cv2.circle(mask, (int(x[i] * 16), int(y[i] * 16)), int(max(r[i], 0.6) * 16), 255, -1, cv2.LINE_AA, 4)
    return np.float32(mask) / 255


def blob_outline(chance, h, w, rough=1.0):
    turn = np.linspace(0, 2 * np.pi, 90, endpoint=False)
    radius = np.ones_like(turn)
    for k in range(2, 9):
        radius += rough * chance.normal(0, 0.35) / k**1.4 * np.cos(k * turn + chance.uniform(0, 7))
    radius = np.maximum(radius, 0.25)
    radius /= radius.max()
    return np.stack([w / 2 + np.cos(turn) * radius * (w / 2 - 2), h / 2 + np.sin(turn) * radius * (h / 2 - 2)], 1)


def domed(chance, mask, strength=None):
    """How light a body of this outline is where: bulging, lit from one side. Its shading is no contour."""
    if min(mask.shape) < 12:
        return np.ones_like(mask)
    small = cv2.resize(mask, None, fx=0.25, fy=0.25, interpolation=cv2.INTER_AREA)
    away = np.sqrt(cv2.distanceTransform(np.uint8(np.pad(small, 1) > 0.5), cv2.DIST_L2, 5)[1:-1, 1:-1])
    height = smooth(away, max(1.0, 0.12 * away.max() ** 2)) * chance.uniform(1, 4)
    dy, dx = np.gradient(height)
    angle = chance.uniform(-np.pi, 0)
    light = (1 + 1.2 * (dx * -np.cos(angle) + dy * -np.sin(angle))) / np.sqrt(1 + dx * dx + dy * dy)
    strength = chance.uniform(0.1, 0.7) if strength is None else strength
    return 1 + strength * (cv2.resize(light, mask.shape[::-1]) - 0.85)


def dressed(chance, h, w, looks, layers, ragged=0.5, shade=None):
    """A thing of layers (mask, kinds of texture or an image, weight), each upon those before."""
    image, alpha, parts = np.zeros((h, w, 3), np.float32), np.zeros((h, w), np.float32), []
    whole = np.max([mask for mask, _, _ in layers], 0)
    for mask, look, weight in layers:
        rows, columns = np.nonzero(mask > 0.01)
        if not len(rows):
            continue
        top, left, bottom, right = rows.min(), columns.min(), rows.max() + 1, columns.max() + 1
        if isinstance(look, np.ndarray):
            surface = np.broadcast_to(look, (bottom - top, right - left, 3))
        else:
            surface = texture(chance, bottom - top, right - left, looks, look)[: bottom - top, : right - left]
        share = mask[top:bottom, left:right, None]
        surface = surface * domed(chance, share[..., 0], shade)[..., None]
        image[top:bottom, left:right] += (surface - image[top:bottom, left:right]) * share
        alpha = np.maximum(alpha, mask)
        parts.append(Part(mask, weight))
    hollow = alpha < 0.5  # colour under the soft rim, so that nothing dark shines through
    spread = cv2.dilate(image * ~hollow[..., None], np.ones((5, 5)))
    image = np.where(hollow[..., None], spread, image)
    return Thing(image, alpha, [Part(whole, 1.0)] + parts, ragged)


def blob(chance, size, looks):
    h, w = (int(size * chance.uniform(0.5, 1)) + 8 for _ in range(2))
    kind = chance.random()
    if kind < 0.5:
        outline = blob_outline(chance, h, w, chance.uniform(0.3, 1.5))
    elif kind < 0.7:
        outline = blob_outline(chance, h, w, 0)
    else:
        corners = chance.integers(3, 8)
        turn = np.sort(chance.uniform(0, 2 * np.pi, corners))
        outline = np.stack([w / 2 + np.cos(turn) * (w / 2 - 2), h / 2 + np.sin(turn) * (h / 2 - 2)], 1)
        outline = rounded(outline, int(chance.integers(0, 4)))
    layers = [(filled(h, w, outline), None, 1.0)]
    if chance.random() < 0.35:
        patch = filled(h, w, blob_outline(chance, h, w) * chance.uniform(0.3, 0.8) + chance.uniform(0, 0.4) * size)
        layers.append((patch * layers[0][0], None, 0.35))
    return dressed(chance, h, w, looks, layers)


def animal(chance, size, looks):
    """A body, legs, a neck, a head with ears, a tail; sometimes a lighter belly, always an eye."""
    w, h = int(size) + 16, int(size * chance.uniform(0.7, 1.1)) + 16
    body_h, body_w = h * chance.uniform(0.2, 0.4), w * chance.uniform(0.4, 0.55)
    leg = h * chance.uniform(0.15, 0.4)
    x0, y0 = w * 0.22, h - 4 - leg - body_h
    turn = np.linspace(0, 2 * np.pi, 40, endpoint=False)
    body = np.stack([x0 + body_w / 2 + np.cos(turn) * body_w / 2, y0 + body_h / 2 + np.sin(turn) * body_h / 2 * (1 + 0.15 * np.sin(2 * turn))], 1)
    masks = [filled(h, w, body)]
    thick = body_h * chance.uniform(0.09, 0.2)
    for share in (0.12, 0.25, 0.78, 0.9):
        x = x0 + body_w * share
        knee, foot = chance.normal(0, 0.04, 2) * w
        masks.append(limb(h, w, [(x, y0 + body_h * 0.6), (x + knee, y0 + body_h + leg * 0.4), (x + foot, h - 5)], [thick * 1.6, thick, thick * 0.8]))
    head_x, head_y = x0 + body_w + w * chance.uniform(0.02, 0.15), y0 + h * chance.uniform(-0.25, 0.1)
    head = body_h * chance.uniform(0.2, 0.4)
    head_y = max(head_y, head * 1.8)
    masks.append(limb(h, w, [(x0 + body_w * 0.85, y0 + body_h * 0.4), (head_x, head_y)], [body_h * 0.35, head * 0.7]))
    snout = (min(head_x + head * chance.uniform(0.8, 1.8), w - head * 0.6 - 3), head_y + head * chance.uniform(0, 0.8))
    face = np.maximum(
        limb(h, w, [(head_x, head_y), snout], [head, head * 0.55]),
        limb(h, w, [(head_x - head * 0.3, head_y - head * 0.6), (head_x - head * 0.5, head_y - head * 1.5)], [head * 0.4, head * 0.15]),
    )
    masks += [
        face,
        limb(
            h,
            w,
            [(x0 + 4, y0 + body_h * 0.3), (x0 - w * 0.1, y0 + body_h * 0.4), (x0 - w * 0.13, y0 + body_h * chance.uniform(0.2, 1.3))],
            [thick, thick * 0.6, thick * 0.5],
        ),
    ]
    whole = np.max(masks, 0)
    layers = [(whole, FUR, 1.0)]
    if chance.random() < 0.3:
        layers.append((whole * filled(h, w, blob_outline(chance, h, w) * [0.6, 0.5] + [w * 0.2, h * 0.3]), FUR, 0.35))
    layers.append((limb(h, w, [(head_x + head * 0.3, head_y - head * 0.2)] * 2, [head * 0.13] * 2), np.float32([15, 15, 20]), 0.15))
    thing = dressed(chance, h, w, looks, layers, ragged=1.0)
    return mirrored_thing(thing) if chance.random() < 0.5 else thing


def mirrored_thing(thing):
    return Thing(thing.image[:, ::-1], thing.alpha[:, ::-1], [Part(p.mask[:, ::-1], p.weight) for p in thing.parts], thing.ragged)


def person(chance, size, looks):
    """Standing, or cut at the chest: hair, face, eyes and mouth, clothes, arms, legs."""
    portrait = chance.random() < 0.4
    head = size * (chance.uniform(0.13, 0.2) if portrait else 0.065)
    h, w = int(size) + 8, int(size * (0.9 if portrait else 0.5)) + 8
    x, y = w / 2 + chance.normal(0, 0.03) * w, head * chance.uniform(1.5, 2)
    skin = np.float32([1, 1.25, 1.7]) * chance.uniform(30, 135) * (1 + chance.normal(0, 0.05, 3).astype(np.float32))
    turn = np.linspace(0, 2 * np.pi, 48, endpoint=False)
    face = np.stack([x + np.cos(turn) * head * 0.78, y + np.sin(turn) * head * 1.05], 1)
    hair = np.stack([x + np.cos(turn) * head * chance.uniform(0.9, 1.15), y + np.sin(turn) * head * (1.25 + 0.1 * np.sin(3 * turn)) - head * 0.12], 1)
    shoulder = head * chance.uniform(1.7, 2.3)
    chest = y + head * 1.6
    hip = h + 20 if portrait else chest + head * chance.uniform(3.2, 4.5)
    torso = rounded(
        [
            (x - head * 0.5, chest - head * 0.3),
            (x + head * 0.5, chest - head * 0.3),
            (x + shoulder, chest + head * 0.4),
            (x + shoulder * 0.8, hip),
            (x - shoulder * 0.8, hip),
            (x - shoulder, chest + head * 0.4),
        ],
        2,
    )
    layers = []
    if not portrait:
        spread = chance.uniform(0.2, 1.0) * head
        legs = [
            limb(h, w, [(x + s * head * 0.5, hip - head * 0.4), (x + s * (head * 0.5 + spread), h - 5)], [head * 0.65, head * 0.4]) for s in (-1, 1)
        ]
        layers.append((np.maximum(*legs), CLOTH, 0.75))
    layers.append((limb(h, w, [(x, y + head * 0.6), (x, chest)], [head * 0.45] * 2), skin, 0.8))
    layers.append((filled(h, w, torso), CLOTH, 0.8))
    for s in (-1, 1):
        elbow = (x + s * (shoulder + head * chance.uniform(0, 0.7)), chest + head * 2.2)
        hand = (elbow[0] - s * head * chance.uniform(-0.5, 1.6), elbow[1] + head * chance.uniform(-1, 1.8))
        layers.append(
            (
                limb(h, w, [(x + s * shoulder * 0.85, chest + head * 0.6), elbow, hand], [head * 0.5, head * 0.42, head * 0.3]),
                skin if chance.random() < 0.4 else CLOTH,
                0.5,
            )
        )
        layers.append((limb(h, w, [hand] * 2, [head * 0.38] * 2), skin, 0.55))
    mane = filled(h, w, hair)
    if chance.random() < 0.35:
        mane = np.maximum(
            mane,
            filled(
                h,
                w,
                rounded([(x - head, y - head * 0.5), (x + head, y - head * 0.5), (x + head * 1.2, y + head * 1.9), (x - head * 1.2, y + head * 1.9)]),
            ),
        )
    face_mask = filled(h, w, face)
    layers.insert(0, (mane, FUR, 0.9))
    fringe = face_mask * (1 - filled(h, w, [(0, y - head * chance.uniform(0.4, 0.8)), (w, y - head * chance.uniform(0.4, 0.8)), (w, h), (0, h)]))
    layers += [(face_mask, skin, 0.8), (fringe, (strokes, grainy, flat), 0.6)]
    for s in (-1, 1):
        at = (x + s * head * 0.32, y - head * 0.1)
        layers.append(
            (
                limb(h, w, [(at[0] - head * 0.1, at[1]), (at[0] + head * 0.1, at[1])], [head * 0.08] * 2),
                np.float32([30, 30, 40]),
                0.3 if portrait else 0.05,
            )
        )
    layers.append(
        (
            limb(h, w, [(x - head * 0.25, y + head * 0.55), (x + head * 0.25, y + head * 0.55)], [head * 0.07] * 2),
            skin * np.float32([0.5, 0.5, 0.8]),
            0.3 if portrait else 0.05,
        )
    )
    if chance.random() < 0.25:
        hat = rounded(
            [
                (x - head * 1.5, y - head * 0.6),
                (x - head * 0.8, y - head * 0.8),
                (x - head * 0.7, y - head * 1.6),
                (x + head * 0.7, y - head * 1.6),
                (x + head * 0.8, y - head * 0.8),
                (x + head * 1.5, y - head * 0.6),
            ],
            1,
        )
        layers.append((filled(h, w, hat), CLOTH, 0.85))
    return dressed(chance, h, w, looks, layers, ragged=0.7)


def tree(chance, size, looks):
    h, w = int(size) + 8, int(size * chance.uniform(0.5, 0.9)) + 8
    trunk = limb(
        h,
        w,
        [(w / 2, h - 3), (w / 2 + chance.normal(0, 0.03) * w, h * 0.5), (w / 2, h * 0.35)],
        np.array([0.05, 0.035, 0.02]) * size * chance.uniform(0.7, 1.5),
    )
    crown = np.zeros((h, w), np.float32)
    if chance.random() < 0.3:
        crown = filled(h, w, [(w / 2, 4), (w * 0.9, h * 0.85), (w * 0.1, h * 0.85)])
    else:
        for _ in range(chance.integers(4, 12)):
            r = w * chance.uniform(0.1, 0.24)
            at = (w / 2 + chance.normal(0, 0.18) * w, h * 0.35 + chance.normal(0, 0.13) * h)
            at = np.clip(at, r + 2, (w - r - 2, h - r - 2))
            crown = np.maximum(crown, limb(h, w, [at, at], [r, r]))
    fringe = noise(chance, h, w, 0.9)
    crown = np.clip((smooth(crown, size * 0.02) + fringe * 0.12 - 0.42) * 4, 0, 1)
    thing = dressed(chance, h, w, looks, [(trunk, (strokes, grainy), 0.9), (crown, (leaves, leaves, strokes, grainy), 0.5)], ragged=3.0)
    return thing


def branch(chance, size, looks):
    """A trunk or a bough, with twigs, from one side to the other."""
    h, w = int(size * chance.uniform(0.5, 1)) + 8, int(size) + 8
    y = chance.uniform(0.2, 0.8, 3) * h
    thick = size * chance.uniform(0.01, 0.05)
    masks = [limb(h, w, [(0, y[0]), (w / 2, y[1]), (w, y[2])], [thick * 1.3, thick, thick * 0.6])]
    for _ in range(chance.integers(0, 5)):
        s = chance.uniform(0.1, 0.9)
        start = (w * s, np.interp(s, [0, 0.5, 1], y))
        masks.append(
            limb(
                h,
                w,
                [
                    start,
                    (start[0] + chance.normal(0.1, 0.1) * w, start[1] + chance.normal(0, 0.2) * h),
                    (start[0] + chance.normal(0.2, 0.2) * w, start[1] + chance.normal(0, 0.4) * h),
                ],
                np.array([0.5, 0.35, 0.2]) * thick,
            )
        )
    return dressed(chance, h, w, looks, [(np.max(masks, 0), (strokes, grainy, bricks), 1.0)], ragged=0.7)


def building(chance, size, looks):
    """A front with rows of windows and a door, a roof, sometimes a side in the shade."""
    h, w = int(size * chance.uniform(0.6, 1.3)) + 8, int(size) + 8
    roof = h * chance.uniform(0.0, 0.3)
    side = w * (chance.uniform(0.15, 0.4) if chance.random() < 0.5 else 0)
    wall_look = texture(chance, h, w, looks, (flat, grainy, bricks, flat))
    layers = [
        (
            filled(h, w, [(2, roof), (w - 2, roof), (w - 2, h - 2), (2, h - 2)]),
            wall_look[:1, :1].mean((0, 1)) if chance.random() < 0.4 else (flat, grainy, bricks),
            0.9,
        )
    ]
    if side:
        layers.append(
            (
                filled(h, w, [(w - side, roof), (w - 2, roof + chance.uniform(0, 0.1) * h), (w - 2, h - 2), (w - side, h - 2)]),
                (flat, grainy, bricks),
                0.7,
            )
        )
    if roof > 6:
        inset = chance.uniform(0, 0.45) * w
        layers.append((filled(h, w, [(0, roof), (inset, 2), (w - inset, 2), (w, roof)]), (bricks, flat, grainy, stripes), 0.85))
    rows, columns = chance.integers(1, 7), chance.integers(1, 8)
    cell_h, cell_w = (h - roof) / (rows + 0.3), (w - side) / (columns + 0.2)
    share_h, share_w = chance.uniform(0.35, 0.7), chance.uniform(0.3, 0.65)
    glass, frame = looks.colour(chance) * chance.uniform(0.2, 0.9), looks.colour(chance)
    weight = 0.55 if rows * columns <= 12 else 0.25
    panes = np.zeros((h, w), np.float32)
    for r in range(rows):
        for c in range(columns):
            left, top = cell_w * (c + 0.6 - share_w / 2), roof + cell_h * (r + 0.65 - share_h / 2)
            panes = np.maximum(
                panes,
                filled(
                    h,
                    w,
                    [(left, top), (left + cell_w * share_w, top), (left + cell_w * share_w, top + cell_h * share_h), (left, top + cell_h * share_h)],
                ),
            )
    if chance.random() < 0.4:
        layers.append((cv2.dilate(panes, np.ones((5, 5))), frame, weight * 0.6))
    layers.append((panes, glass.astype(np.float32), weight))
    return dressed(chance, h, w, looks, layers, ragged=0.4, shade=chance.uniform(0, 0.15))


def vessel(chance, size, looks):
    """Turned on a lathe: a vase, a bottle, a lamp, a post; lit from the side."""
    h, w = int(size) + 8, int(size * chance.uniform(0.3, 0.9)) + 8
    knots = chance.uniform(0.25, 1, chance.integers(3, 7))
    y = np.linspace(3, h - 3, 60)
    half = np.interp(np.linspace(0, len(knots) - 1, 60), np.arange(len(knots)), knots)
    half = np.convolve(np.pad(half, 4, mode="edge"), np.ones(9) / 9, "valid") * (w / 2 - 3)
    mask = filled(h, w, np.concatenate([np.stack([w / 2 + half, y], 1), np.stack([w / 2 - half, y], 1)[::-1]]))
    layers = [(mask, (flat, grainy, stripes, folds), 1.0)]
    if chance.random() < 0.5:
        top, tall = chance.uniform(0.1, 0.7) * h, chance.uniform(0.05, 0.3) * h
        layers.append((mask * filled(h, w, [(0, top), (w, top), (w, top + tall), (0, top + tall)]), None, 0.45))
    return dressed(chance, h, w, looks, layers, shade=chance.uniform(0.3, 0.9))


def flower(chance, size, looks):
    h = w = int(size) + 8
    petals, longer = chance.integers(4, 16), chance.uniform(0.25, 0.45) * size
    colour, layers = texture(chance, h, w, looks, (flat, grainy, folds)), []
    for i in range(petals):
        turn = 2 * np.pi * i / petals
        at = (w / 2 + np.cos(turn) * longer * 0.62, h / 2 + np.sin(turn) * longer * 0.62)
        tip = (w / 2 + np.cos(turn) * longer * 1.05, h / 2 + np.sin(turn) * longer * 1.05)
        wide = longer * min(0.45, 2.2 / petals)
        petal = limb(h, w, [(w / 2, h / 2), at, tip], [wide * 0.3, wide, wide * 0.5])
        layers.append((petal, colour[h // 2, w // 2] * np.float32(chance.uniform(0.8, 1.15)), 0.45))
    layers.append((limb(h, w, [(w / 2, h / 2)] * 2, [longer * chance.uniform(0.15, 0.35)] * 2), (grainy, leaves, spots), 0.75))
    return dressed(chance, h, w, looks, layers, ragged=0.7)


DRAWN_THINGS = ((blob, 3), (animal, 3), (person, 4), (tree, 2), (branch, 1.5), (building, 2.5), (vessel, 2), (flower, 1))
