# SPDX-License-Identifier: Apache-2.0
"""The contour net: which pixels lie on a contour that people would draw.

Input:  (batch, 3, H, W), blue, green, red as normalise() leaves them, H and W multiples of 16.
Output: (batch, 1, H/2, W/2), logits; sample (i, j) lies at (2i + 0.5, 2j + 0.5) of the input.

Four scales, from half size down to a sixteenth. The first convolution sees the picture (2x2 pixels folded into 12
channels) and 12 channels of derivatives made by hand; everything else is learned. tactics runs it in integers: what
fold() returns is a list of plain convolutions, and filters/net/net.cpp applies them in the same order.
"""

import torch
import torch.nn as nn
import torch.nn.functional as F

HALF, QUARTER, EIGHTH, SIXTEENTH = 16, 24, 32, 48  # channels at each scale
SIGMAS = (1, 2, 4)  # of the derivatives, in pixels of the half-size picture
CENTRE = 0.7  # share of the central difference in the first stages (Su et al., Pixel Difference Networks, ICCV 2021)


class Convolution(nn.Module):
    """Convolution, batch normalisation and, if asked for, a ReLU; fold() makes one convolution with a bias of it."""

    def __init__(self, inputs, outputs, size=3, *, each=False, relu=True, centre=0.0):
        super().__init__()
        self.weight = nn.Conv2d(inputs, outputs, size, padding=size // 2, groups=inputs if each else 1, bias=False)
        self.norm = nn.BatchNorm2d(outputs)
        self.relu, self.centre = relu, centre

    def kernel(self):
        kernel = self.weight.weight
        if not self.centre:
            return kernel
        middle = torch.zeros_like(kernel)
        middle[:, :, kernel.shape[2] // 2, kernel.shape[3] // 2] = kernel.sum((2, 3))
        return kernel - self.centre * middle

    def forward(self, x):
        y = self.norm(F.conv2d(x, self.kernel(), padding=self.weight.padding, groups=self.weight.groups))
        return F.relu(y) if self.relu else y

    def fold(self):
        """(kernel, bias, groups) of the one convolution that does the same."""
        gain = self.norm.weight / torch.sqrt(self.norm.running_var + self.norm.eps)
        kernel = self.kernel() * gain[:, None, None, None]
        return kernel.detach(), (self.norm.bias - self.norm.running_mean * gain).detach(), self.weight.groups


class Residual(nn.Module):
    """What comes in, plus two convolutions of it: 3x3 and 3x3, or depthwise size x size and 1x1."""

    def __init__(self, channels, size=3, *, each=True, centre=0.0):
        super().__init__()
        self.first = Convolution(channels, channels, size, each=each, centre=centre)
        self.second = Convolution(channels, channels, 1 if each else 3, relu=False)

    def forward(self, x):
        return F.relu(x + self.second(self.first(x)))


class Derivatives(nn.Module):
    """|derivative| in four directions at three scales, summed over luminance and two opponent colours: 12 channels of
    half the input's size."""

    def __init__(self):
        super().__init__()
        # Rows: luminance, red less green, blue less their mean; columns: blue, green, red.
        self.register_buffer("opponents", torch.tensor([[0.25, 0.5, 0.25], [0, -1, 1], [1, -0.5, -0.5]])[:, :, None, None], persistent=False)
        for sigma in SIGMAS:
            at = torch.arange(-3 * sigma, 3 * sigma + 1.0)
            kernel = torch.exp(-at**2 / (2 * sigma**2))
            self.register_buffer(f"gauss{sigma}", (kernel / kernel.sum()).repeat(3, 1, 1, 1), persistent=False)

    @torch.no_grad()
    def forward(self, x):
        x = F.conv2d(F.avg_pool2d(x, 2), self.opponents)
        channels = []
        for sigma in SIGMAS:
            kernel, reach = getattr(self, f"gauss{sigma}"), 3 * sigma
            y = F.conv2d(F.pad(x, (reach, reach, 0, 0), mode="reflect"), kernel, groups=3)
            y = F.conv2d(F.pad(y, (0, 0, reach, reach), mode="reflect"), kernel.transpose(2, 3), groups=3)
            y = F.pad(y, (1, 1, 1, 1), mode="replicate") * (sigma + 0.5)
            across, down = y[:, :, 1:-1, 2:] - y[:, :, 1:-1, :-2], y[:, :, 2:, 1:-1] - y[:, :, :-2, 1:-1]
            diagonal = 0.5**0.5
            channels += [d.abs().sum(1, keepdim=True) for d in (across, down, (across + down) * diagonal, (across - down) * diagonal)]
        return torch.cat(channels, 1)


def enlarged(x, like):
    return F.interpolate(x, size=like.shape[2:], mode="bilinear", align_corners=False)


class ContourNet(nn.Module):
    def __init__(self):
        super().__init__()
        self.derivatives = Derivatives()
        self.stem = Convolution(24, HALF, centre=CENTRE)
        self.at_half = Residual(HALF, each=False, centre=CENTRE)
        self.to_quarter = Convolution(HALF, QUARTER)
        self.at_quarter = Residual(QUARTER, each=False)
        self.to_eighth = Convolution(QUARTER, EIGHTH)
        self.at_eighth = nn.Sequential(*[Residual(EIGHTH, 5) for _ in range(3)])
        self.to_sixteenth = Convolution(EIGHTH, SIXTEENTH, 1)
        self.at_sixteenth = nn.Sequential(*[Residual(SIXTEENTH, 5) for _ in range(4)])
        self.up_eighth = Convolution(SIXTEENTH, EIGHTH, 1, relu=False)
        self.fine_eighth = Residual(EIGHTH, 5)
        self.up_quarter = Convolution(EIGHTH, QUARTER, 1, relu=False)
        self.fine_quarter = Residual(QUARTER, 3)
        self.up_half = Convolution(QUARTER, HALF, 1, relu=False)
        self.fine_half = Convolution(HALF, HALF)
        self.out = nn.Conv2d(HALF, 1, 1)
        # Teach the coarser scales directly; not in what is shipped.
        self.taught_eighth, self.taught_quarter = nn.Conv2d(EIGHTH, 1, 1), nn.Conv2d(QUARTER, 1, 1)

    def forward(self, x, taught=False):
        a = self.at_half(self.stem(torch.cat([F.pixel_unshuffle(x, 2), self.derivatives(x)], 1)))
        b = self.at_quarter(self.to_quarter(F.max_pool2d(a, 2)))
        c = self.at_eighth(self.to_eighth(F.max_pool2d(b, 2)))
        d = self.at_sixteenth(self.to_sixteenth(F.max_pool2d(c, 2)))
        c = self.fine_eighth(F.relu(c + enlarged(self.up_eighth(d), c)))
        b = self.fine_quarter(F.relu(b + enlarged(self.up_quarter(c), b)))
        a = self.fine_half(F.relu(a + enlarged(self.up_half(b), a)))
        return (self.out(a), self.taught_quarter(b), self.taught_eighth(c)) if taught else self.out(a)

    def fold(self):
        """The convolutions in order of their use, as (kernel, bias, groups)."""
        shipped = [m for name, m in self.named_modules() if isinstance(m, Convolution)]
        return [m.fold() for m in shipped] + [(self.out.weight.detach(), self.out.bias.detach(), 1)]


def count(net):
    """How many numbers are shipped."""
    return sum(kernel.numel() + bias.numel() for kernel, bias, _ in net.fold())


if __name__ == "__main__":
    print(count(ContourNet()), "numbers")
