# SPDX-License-Identifier: Apache-2.0
"""What the things of generated scenes are made of: surfaces without a contour, drawn by chance or cut from photographs."""

import cv2
import numpy as np

# Hue in degrees, saturation and value that surfaces outdoors and indoors have, and how often: only where there are no
# photographs to take colours from.
NATURAL = (
    ((60, 110), (0.2, 0.7), (0.1, 0.7), 5),  # leaves, grass
    ((20, 45), (0.15, 0.6), (0.1, 0.8), 5),  # earth, stone, wood, fur
    ((195, 225), (0.1, 0.6), (0.4, 1.0), 3),  # sky, water, haze
    ((0, 360), (0.0, 0.08), (0.03, 1.0), 5),  # walls, clouds, roads, shade
    ((8, 28), (0.25, 0.55), (0.5, 0.95), 2),  # skin
    ((0, 360), (0.3, 0.9), (0.2, 0.9), 2),  # cloth, flowers, paint
)


def smooth(image, sigma):
    return cv2.GaussianBlur(image, (0, 0), sigma) if sigma > 0.15 else image


def noise(chance, height, width, power=1.5, stretch=1.0):
    """Noise of mean 0 and deviation 1 whose amplitude falls as frequency^-power; stretched across by that factor."""
    rows, columns = cv2.getOptimalDFTSize(height + 16), cv2.getOptimalDFTSize(width + 16)
    down, across = np.fft.fftfreq(rows)[:, None], np.fft.rfftfreq(columns)[None] * stretch
    spectrum = np.fft.rfft2(chance.standard_normal((rows, columns)).astype(np.float32))
    spectrum *= np.maximum(np.hypot(down, across), 1.5 / max(rows, columns)) ** -power
    spectrum[0, 0] = 0
    field = np.fft.irfft2(spectrum, (rows, columns))[:height, :width].astype(np.float32)
    return field / (field.std() + 1e-6)


class Looks:
    """Colours and crops of the photographs that may be used; without any, colours from the table above."""

    def __init__(self, photos):
        self.photos = photos

    def colour(self, chance):
        if self.photos and chance.random() < 0.8:
            photo = self.photos[chance.integers(len(self.photos))]
            y, x = chance.integers(photo.shape[0] - 4), chance.integers(photo.shape[1] - 4)
            return photo[y : y + 4, x : x + 4].reshape(-1, 3).mean(0).astype(np.float32)
        weights = np.array([row[3] for row in NATURAL], float)
        hue, saturation, value, _ = NATURAL[chance.choice(len(NATURAL), p=weights / weights.sum())]
        drawn = np.float32([[[chance.uniform(*hue) % 360, chance.uniform(*saturation), chance.uniform(*value)]]])
        return cv2.cvtColor(drawn, cv2.COLOR_HSV2BGR)[0, 0] * 255

    def near(self, chance, colour, spread=25):
        """A colour of the same surface: mostly lighter or darker."""
        return np.clip(colour + chance.normal(0, spread) + chance.normal(0, spread / 3, 3), 0, 255).astype(np.float32)

    def crop(self, chance, height, width):
        """Of several crops of photographs the one that is busy, but alike all over."""
        best, best_score = None, np.inf
        for _ in range(chance.integers(12, 30)):
            photo = self.photos[chance.integers(len(self.photos))]
            side = int(min(photo.shape[:2]) * np.exp(chance.uniform(np.log(0.12), np.log(0.5))))
            y, x = chance.integers(photo.shape[0] - side + 1), chance.integers(photo.shape[1] - side + 1)
            part = photo[y : y + side, x : x + side]
            small = cv2.resize(part, (64, 64), interpolation=cv2.INTER_AREA).astype(np.float32)
            cells = cv2.resize(smooth(small, 4), (6, 6), interpolation=cv2.INTER_AREA)
            fine = np.abs(small - smooth(small, 2)).mean(2)
            busy = cv2.resize(fine, (5, 5), interpolation=cv2.INTER_AREA)
            score = cells.std((0, 1)).mean() / (4 * fine.mean() + 4) + 1.5 * (1 - busy.min() / (busy.max() + 0.3))
            if score < best_score:
                best, best_score = part, score
        scale = np.exp(chance.uniform(np.log(0.4), np.log(1.3)))
        scale = max(scale, 48 / best.shape[0])
        part = cv2.resize(best, None, fx=scale, fy=scale, interpolation=cv2.INTER_AREA if scale < 1 else cv2.INTER_LINEAR)
        part = np.rot90(part, chance.choice([0, 0, 0, 2, 1]))[:, :: chance.choice([-1, 1])]
        rows, columns = (mirrored(n, size, chance) for n, size in zip(part.shape, (height, width)))
        return part[rows][:, columns].astype(np.float32)


def mirrored(n, size, chance):
    """Indices that run to and fro through n samples."""
    at = (np.arange(size) + chance.integers(2 * n)) % (2 * n)
    return np.where(at < n, at, 2 * n - 1 - at)


def mix(first, second, share):
    return first + (second - first) * share[..., None]


def flat(chance, h, w, looks):
    colour = looks.colour(chance)
    shade = noise(chance, max(h // 8, 8), max(w // 8, 8), 2.0)
    image = np.repeat(np.repeat(colour[None, None], h, 0), w, 1)
    return image + cv2.resize(shade, (w, h))[..., None] * np.float32(chance.uniform(0, 10))


def grainy(chance, h, w, looks):
    first = looks.colour(chance)
    second = looks.near(chance, first, 35) if chance.random() < 0.8 else looks.colour(chance)
    field = noise(chance, h, w, chance.uniform(0.5, 1.8), np.exp(chance.normal(0, 0.5)))
    return mix(first, second, np.clip(0.5 + field * chance.uniform(0.15, 0.5), -0.3, 1.3))


def strokes(chance, h, w, looks):
    """Fur, grass, straw: short lines, nearly of one direction."""
    first = looks.colour(chance)
    second = looks.near(chance, first, 35)
    length, thick, along = chance.uniform(6, 45), int(chance.choice([1, 1, 2, 3])), chance.uniform(0, np.pi)
    many = int(np.clip(h * w * 2.5 / (length * thick), 200, 6000))
    image = np.repeat(np.repeat(first[None, None] * 0.8, h, 0), w, 1).astype(np.float32)
    turn = noise(chance, h // 8 + 2, w // 8 + 2, 2.0) * chance.uniform(0.1, 0.5)
    x, y, share = chance.uniform(-10, w + 10, many), chance.uniform(-10, h + 10, many), np.clip(chance.normal(0.5, 0.35, many), 0, 1)
    spread = chance.normal(0, chance.uniform(0.1, 0.4), many)
    for i in range(many):
        angle = along + spread[i] + turn[min(max(int(y[i]) // 8, 0), h // 8), min(max(int(x[i]) // 8, 0), w // 8)]
        dx, dy = np.cos(angle) * length / 2, np.sin(angle) * length / 2
        colour = first + (second - first) * share[i]
        cv2.line(image, (int(x[i] - dx), int(y[i] - dy)), (int(x[i] + dx), int(y[i] + dy)), colour.tolist(), thick, cv2.LINE_AA)
    return smooth(image, chance.uniform(0.4, 1.0))


def leaves(chance, h, w, looks):
    """Foliage, petals, pebbles from afar: many small ellipses, the later ones lighter."""
    first = looks.colour(chance)
    second = looks.near(chance, first, 45)
    size = np.exp(chance.uniform(np.log(3), np.log(26)))
    many = int(np.clip(h * w * chance.uniform(0.8, 2.5) / size**2, 60, 5000))
    image = np.repeat(np.repeat(first[None, None] * chance.uniform(0.15, 0.7), h, 0), w, 1).astype(np.float32)
    longer, x, y = chance.uniform(0.4, 1.2, (many, 2)) * size, chance.uniform(0, w, many), chance.uniform(0, h, many)
    share, turn = np.clip(chance.normal(0.5, 0.3, many), 0, 1) * np.linspace(0.5, 1, many), chance.uniform(0, 180, many)
    for i in range(many):
        colour = (first + (second - first) * share[i]) * (0.6 + 0.5 * share[i])
        cv2.ellipse(
            image, (int(x[i]), int(y[i])), (int(longer[i, 0]) + 1, int(longer[i, 1] / 2) + 1), turn[i], 0, 360, colour.tolist(), -1, cv2.LINE_AA
        )
    return smooth(image, chance.uniform(0.4, 1.2))


def gravel(chance, h, w, looks):
    """Stones, cobbles, cracked mud: cells about chance points, darker where they meet."""
    size = np.exp(chance.uniform(np.log(6), np.log(55)))
    points = np.ones((h, w), np.uint8)
    many = int(h * w / size**2) + 2
    points[chance.integers(0, h, many), chance.integers(0, w, many)] = 0
    away, cell = cv2.distanceTransformWithLabels(points, cv2.DIST_L2, 5, labelType=cv2.DIST_LABEL_PIXEL)
    first = looks.colour(chance)
    spread = chance.uniform(8, 35)
    colours = np.float32([looks.near(chance, first, spread) for _ in range(cell.max() + 1)])
    image = colours[cell] * (1.15 - 0.5 * np.clip(away / size, 0, 1) ** 2)[..., None]
    return smooth(image, chance.uniform(0.6, 1.5))


def bricks(chance, h, w, looks):
    """Bricks, tiles, planks, shingles."""
    tall, long = chance.uniform(8, 30), chance.uniform(12, 80)
    y, x = np.mgrid[0:h, 0:w].astype(np.float32)
    y, x = y + chance.uniform(0, 99), x + chance.uniform(0, 99) + 0.15 * y * chance.normal()
    row = np.floor(y / tall)
    column = np.floor(x / long + 0.5 * (row % 2))
    rest = np.minimum(y / tall % 1 * tall, (x / long + 0.5 * (row % 2)) % 1 * long)
    first = looks.colour(chance)
    table = np.float32([looks.near(chance, first, chance.uniform(3, 20)) for _ in range(97)])
    image = table[((row * 31 + column * 17) % 97).astype(int)]
    image = np.where((rest < chance.uniform(1, 3))[..., None], looks.near(chance, first, 30), image)
    return smooth(image + noise(chance, h, w, 0.8)[..., None] * 5, 0.8)


def stripes(chance, h, w, looks):
    """Stripes, checks, corduroy, zebras, blinds: bent by a slow warp."""
    period, angle = np.exp(chance.uniform(np.log(5), np.log(40))), chance.uniform(0, np.pi)
    y, x = np.mgrid[0:h, 0:w].astype(np.float32)
    warp = cv2.resize(noise(chance, h // 8 + 2, w // 8 + 2, 2.2), (w, h)) * chance.uniform(0, 12)
    wave = np.sin((x * np.cos(angle) + y * np.sin(angle) + warp) * (2 * np.pi / period))
    if chance.random() < 0.3:
        wave = wave * 0.6 + 0.6 * np.sin((y * np.cos(angle) - x * np.sin(angle) + warp) * (2 * np.pi / period))
    share = 0.5 + 0.5 * np.tanh(wave * np.exp(chance.uniform(-0.5, 2)))
    first = looks.colour(chance)
    return mix(first, looks.near(chance, first, 50) if chance.random() < 0.6 else looks.colour(chance), share)


def spots(chance, h, w, looks):
    """Spots, rings, patches: coats of animals, lichen, rust, foam."""
    first = looks.colour(chance)
    field = noise(chance, h, w, chance.uniform(1.4, 2.6), np.exp(chance.normal(0, 0.4)))
    field = field - smooth(field, np.exp(chance.uniform(np.log(6), np.log(30))))
    field /= field.std() + 1e-6
    field = field - chance.uniform(0, 1.2) if chance.random() < 0.6 else 0.5 - np.abs(field - chance.uniform(-0.5, 1))
    second = looks.near(chance, first, 60) if chance.random() < 0.7 else looks.colour(chance)
    return mix(first, second, 0.5 + 0.5 * np.tanh(field * chance.uniform(2, 8)))


def shards(chance, h, w, looks):
    """Litter, rubble, a crowd from afar: small angular pieces of many colours."""
    first, size = looks.colour(chance), np.exp(chance.uniform(np.log(5), np.log(24)))
    colours = np.float32([looks.near(chance, first, 45) for _ in range(8)] + [looks.colour(chance) for _ in range(chance.integers(0, 3))])
    image = np.repeat(np.repeat(first[None, None] * 0.6, h, 0), w, 1).astype(np.float32)
    for _ in range(int(np.clip(h * w * 1.8 / size**2, 60, 4000))):
        turn = np.sort(chance.uniform(0, 2 * np.pi, 4))
        far = size * chance.uniform(0.3, 1.2, 4)
        corners = np.stack([chance.uniform(0, w) + np.cos(turn) * far, chance.uniform(0, h) + np.sin(turn) * far], 1)
        cv2.fillConvexPoly(image, np.int32(corners * 16), colours[chance.integers(len(colours))].tolist(), cv2.LINE_AA, 4)
    return smooth(image, chance.uniform(0.5, 1.5))


def water(chance, h, w, looks):
    first = looks.colour(chance)
    field = noise(chance, h, w, chance.uniform(0.8, 1.4), 1 / chance.uniform(3, 9))
    return mix(first, looks.near(chance, first, 40), np.clip(0.4 + 0.4 * field, 0, 1.4))


def folds(chance, h, w, looks):
    """Cloth: one colour, shaded by folds."""
    field = noise(chance, h // 4 + 2, w // 4 + 2, 2.0, np.exp(chance.normal(0, 0.8)))
    shade = cv2.resize(np.tanh(field * 1.2), (w, h))
    return looks.colour(chance)[None, None] * (1 + chance.uniform(0.1, 0.4) * shade)[..., None]


DRAWN = (
    (flat, 4),
    (grainy, 4),
    (strokes, 2),
    (leaves, 2),
    (gravel, 1),
    (bricks, 1),
    (stripes, 1.3),
    (spots, 2),
    (shards, 1.5),
    (water, 1),
    (folds, 2.5),
)


def texture(chance, h, w, looks, kinds=None, from_photos=0.55):
    """A surface of h x w, blue green red, about 0 to 255."""
    h, w = max(h, 16), max(w, 16)
    if looks.photos and chance.random() < from_photos:
        return looks.crop(chance, h, w)
    weights = np.array([weight for kind, weight in DRAWN if kinds is None or kind in kinds])
    choice = [kind for kind, _ in DRAWN if kinds is None or kind in kinds]
    kind = choice[chance.choice(len(choice), p=weights / weights.sum())]
    image = kind(chance, h, w, looks)
    return np.float32(image)[:h, :w]


def ground(chance, h, w, looks, horizon):
    """A texture that lies on a plane seen to its horizon (in rows, above the first row of what is returned)."""
    size = 640
    plane = texture(chance, size, size, looks, kinds=(flat, grainy, strokes, leaves, gravel, shards, water, bricks))
    levels = [plane, smooth(plane, 2), smooth(plane, 5), smooth(plane, 14)]
    near = chance.uniform(0.7, 1.6)
    y, x = np.mgrid[0:h, 0:w].astype(np.float32)
    depth = (h + horizon) / (y + horizon + 1)
    to_x = np.mod((x - w / 2) * depth * near + 3000, 2 * size)
    to_y = np.mod(depth * near * (h + horizon) * 0.5, 2 * size)
    to_x, to_y = (np.where(t < size, t, 2 * size - 1 - t).astype(np.float32) for t in (to_x, to_y))
    seen = [cv2.remap(level, to_x, to_y, cv2.INTER_LINEAR, borderMode=cv2.BORDER_REFLECT_101) for level in levels]
    level = np.clip(np.log2(np.maximum(depth * depth * near * 0.5, 1)), 0, 2.999)
    image = np.zeros_like(seen[0])
    for i, layer in enumerate(seen):
        image += layer * np.maximum(1 - np.abs(level - i), 0)[..., None]
    return image


def sky(chance, h, w, looks):
    """Clear, hazy, clouded or dusky."""
    top = np.float32([chance.uniform(120, 255), chance.uniform(90, 200), chance.uniform(40, 190)])
    if chance.random() < 0.35:
        top = np.full(3, chance.uniform(100, 250), np.float32)
    if chance.random() < 0.15:
        top = looks.colour(chance)
    low = np.clip(top + chance.uniform(-10, 70) + chance.normal(0, 10, 3), 0, 255)
    image = np.repeat(mix(np.float32(top), np.float32(low), np.linspace(0, 1, h, dtype=np.float32)[:, None]), w, 1)
    if chance.random() < 0.55:
        cloud = noise(chance, h, w, chance.uniform(1.6, 2.3), 1 / chance.uniform(1, 3))
        share = 1 / (1 + np.exp(-(cloud - chance.normal(0.3, 0.7)) * np.exp(chance.uniform(0, 2.3))))
        image = mix(image, np.full(3, chance.uniform(160, 255), np.float32), share * chance.uniform(0.2, 0.9))
    return np.float32(image)
