# SPDX-License-Identifier: Apache-2.0
"""The contour net in integers, exactly as filters/net/ computes it: what the program is compared with.

Numbers between layers have 8 bits of fraction and are held within -MOST..MOST. A layer sums int16 x int16 in int32,
adds half of what it is about to lose, and shifts. Every sum here is below 2^53, so float64 holds it exactly.
"""

from typing import NamedTuple

import numpy as np
import torch
import torch.nn.functional as F

FRACTION, MOST, MOST_SHIFT = 8, 8191, 14
SIGMAS = (1, 2, 4)


class Layer(NamedTuple):
    stored: np.ndarray  # outputs x inputs x size x size, what the file holds
    up: np.ndarray  # an output's weights are stored << up
    bias: np.ndarray
    shift: int
    each: bool  # depthwise

    def weights(self):
        return self.stored << self.up[:, None, None, None]


def fits(weights, bias, shift):
    """No sum overflows, whatever comes in."""
    sums = np.abs(weights).sum((1, 2, 3)) * MOST + np.abs(bias) + (1 << shift >> 1)
    return sums.max() < 2**31 and np.abs(weights).max() < 2**15


def rounded(kernel, most):
    """Whole numbers within -most..most; what rounding one weight leaves is handed to its neighbour, row by row there and back.

    What comes in is mostly positive and alike side by side, so that errors which add up to nothing undo each other: the
    logits are off by a third of what rounding each by itself makes.
    """
    out, left = np.zeros(kernel.shape, np.int64), 0.0
    for i in range(kernel.shape[1]):
        for row in range(kernel.shape[2]):
            for column in range(kernel.shape[3])[:: 1 if row % 2 == 0 else -1]:
                wanted = kernel[:, i, row, column] + left
                out[:, i, row, column] = np.clip(np.round(wanted), -most, most)
                left = wanted - out[:, i, row, column]
    return out


def quantise(kernel, bias, groups, bits=8):
    """The layer with the largest shift that fits; a power of two for each output is what `bits` make the best of."""
    kernel, bias = kernel.double().numpy(), bias.double().numpy()
    most = 2 ** (bits - 1) - 1
    largest = np.maximum(np.abs(kernel).max((1, 2, 3)), 1e-9)
    for shift in range(MOST_SHIFT, 0, -1):
        fraction = np.minimum(np.floor(np.log2(most / largest)), shift).astype(int)
        layer = Layer(rounded(kernel * 2.0 ** fraction[:, None, None, None], most), shift - fraction,
                      np.round(bias * 2.0 ** (shift + FRACTION)).astype(np.int64), shift, groups > 1)
        if fits(layer.weights(), layer.bias, shift):
            return layer
    raise SystemExit("a layer's weights are too large for 32-bit sums")


def isqrt(n):
    root = int(np.sqrt(float(n)))
    while root * root > n:
        root -= 1
    while (root + 1) ** 2 <= n:
        root += 1
    return root


def normalised(image):
    """Blue, green, red with 8 bits of fraction, as normalise() in photos.py: one table for the whole picture."""
    blue, green, red = (image[..., c].astype(np.int64) for c in range(3))
    levels = np.bincount(((19595 * red + 38470 * green + 7471 * blue + 32768) >> 16).ravel(), minlength=256)
    count, value = int(levels.sum()), np.arange(256, dtype=np.int64)
    mean = (256 * int((levels * value).sum()) + count // 2) // count  # of the luminance, x 256
    deviation = isqrt(int((levels * (256 * value - mean) ** 2).sum()) // count)  # x 256
    gain = min(max(48 * 2**24 // max(deviation, 1), 45875), 327680)  # 48 / deviation within 0.7..5, x 65536
    return ((256 * value - mean) * gain + (1 << 21) >> 22)[image]


def mirrored(image, multiple=16):
    down, across = -image.shape[0] % multiple, -image.shape[1] % multiple
    return np.pad(image, ((0, down), (0, across), (0, 0)), "reflect")


def gauss(sigma):
    """Sums to 4096."""
    kernel = np.exp(-np.arange(-3 * sigma, 3 * sigma + 1.0) ** 2 / (2 * sigma**2))
    kernel = np.floor(kernel / kernel.sum() * 4096 + 0.5).astype(np.int64)
    kernel[3 * sigma] += 4096 - kernel.sum()
    return kernel


def derivatives(x):
    """Derivatives of model.py; x is H x W x 3. Between the steps there are 9 bits of fraction."""
    blue, green, red = (x[::2, ::2, c] + x[1::2, ::2, c] + x[::2, 1::2, c] + x[1::2, 1::2, c] for c in range(3))
    planes = (blue + 2 * green + red + 4 >> 3, red - green + 1 >> 1, 2 * blue - green - red + 2 >> 2)
    channels = []
    for sigma in SIGMAS:
        kernel, reach, sums = gauss(sigma), 3 * sigma, 0
        for plane in planes:
            height, width = plane.shape
            y = np.pad(plane, ((0, 0), (reach, reach)), "reflect")
            y = sum(k * y[:, i : i + width] for i, k in enumerate(kernel)) + 2048 >> 12
            y = np.pad(y, ((reach, reach), (0, 0)), "reflect")
            y = sum(k * y[i : i + height] for i, k in enumerate(kernel)) + 2048 >> 12
            y = np.pad(y, 1, "edge")
            across, down = y[1:-1, 2:] - y[1:-1, :-2], y[2:, 1:-1] - y[:-2, 1:-1]
            sums = sums + np.abs(np.stack([across, down, across + down, across - down]))
        straight, diagonal = sums[:2] * (2 * sigma + 1) + 2 >> 2, sums[2:] * (2 * sigma + 1) * 181 + 512 >> 10
        channels += [np.minimum(straight, MOST), np.minimum(diagonal, MOST)]
    return np.concatenate(channels)


def enlarged(x):
    """Twice as large; a sample is 9, 3, 3 and 1 sixteenths of its neighbours."""
    height, width = x.shape[2:]
    x = F.pad(x, (1, 1, 1, 1), mode="replicate")
    y = torch.zeros(*x.shape[:2], 2 * height, 2 * width, dtype=x.dtype)
    for down in (0, 1):
        for across in (0, 1):
            rows, columns = slice(2 * down, 2 * down + height), slice(2 * across, 2 * across + width)
            y[:, :, down::2, across::2] = torch.floor(
                (9 * x[:, :, 1:-1, 1:-1] + 3 * x[:, :, rows, 1:-1] + 3 * x[:, :, 1:-1, columns] + x[:, :, rows, columns] + 8) / 16)
    return y


def convolved(x, layer, relu=True, add=0):
    weights = torch.from_numpy(layer.weights().astype(np.float64))
    y = F.conv2d(x, weights, torch.from_numpy(layer.bias.astype(np.float64)), padding=weights.shape[2] // 2,
                 groups=x.shape[1] if layer.each else 1)
    return (torch.floor((y + 2.0 ** (layer.shift - 1)) / 2.0**layer.shift) + add).clamp(0 if relu else -MOST, MOST)


@torch.no_grad()
def logits_of(layers, blocks, image):
    """int16, half the size of the picture (H x W x 3, blue green red) rounded up."""
    x = mirrored(normalised(image))
    folded = F.pixel_unshuffle(torch.from_numpy(x.transpose(2, 0, 1)[None].astype(np.float64)), 2)
    x = torch.cat([folded, torch.from_numpy(derivatives(x)[None].astype(np.float64))], 1)
    rest = iter(layers)

    def residuals(x, count):
        for _ in range(count):
            y = convolved(x, next(rest))
            x = convolved(y, next(rest), add=x)
        return x

    def joined(fine, coarse):
        return (fine + enlarged(convolved(coarse, next(rest), relu=False))).clamp(0, MOST)

    half = residuals(convolved(x, next(rest)), blocks[0])
    quarter = residuals(convolved(F.max_pool2d(half, 2), next(rest)), blocks[1])
    eighth = residuals(convolved(F.max_pool2d(quarter, 2), next(rest)), blocks[2])
    coarse = residuals(convolved(F.max_pool2d(eighth, 2), next(rest)), blocks[3])
    eighth = residuals(joined(eighth, coarse), 1)
    quarter = residuals(joined(quarter, eighth), 1)
    half = convolved(joined(half, quarter), next(rest))
    out = convolved(half, next(rest), relu=False)[0, 0].numpy().astype("<i2")
    return out[: (image.shape[0] + 1) // 2, : (image.shape[1] + 1) // 2]


def drawn_picture():
    """A disc and a box before a slope, with grain: no file and no library has a say in it."""
    y, x = np.mgrid[0:70, 0:93]
    picture = np.stack([60 + x, 90 + y, 150 - x], 2)
    picture[(x - 30) ** 2 + (y - 35) ** 2 < 400] = (200, 90, 40)
    picture[(x >= 58) & (x < 83) & (y >= 12) & (y < 50)] = (30, 160, 230)
    return np.uint8(picture + ((x * 7919 ^ y * 10473) >> 3 & 15)[..., None])


def hash_of(logits):
    """FNV-1a, 64 bits, of the little-endian bytes."""
    value = 0xCBF29CE484222325
    for byte in logits.astype("<i2").tobytes():
        value = (value ^ byte) * 0x100000001B3 % 2**64
    return value
