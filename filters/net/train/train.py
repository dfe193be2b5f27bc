#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Trains the contour net from nothing.

    train.py FOLDER... --out NET.pt [--steps 30000] [--seed 1]

FOLDER is as photos.py says. NET.pt is written every 500 steps; started again with the same words, training goes on
from there. The same folders, seed, steps and libraries give the same numbers on one machine.
"""

import argparse
import copy
import math
import os
import time
from pathlib import Path

import cv2
import numpy as np
import torch
import torch.nn.functional as F

from model import ContourNet, count
from photos import crop, read_folder

BATCH, SIDE, RATE, WARM_UP = 4, 256, 3e-3, 200
AVERAGE = 0.998  # of the weights over steps: the average is what is kept
SAVE_EVERY, TELL_EVERY = 500, 100


def batch(photos, chance):
    pictures, labels = zip(*(crop(photos, chance, SIDE) for _ in range(BATCH)))
    x = torch.from_numpy(np.stack(pictures).transpose(0, 3, 1, 2).copy()).contiguous(memory_format=torch.channels_last)
    return x, torch.from_numpy(np.stack(labels)[:, None].copy())


def loss_of(logits, label):
    """Binary cross-entropy against the share of people; contours are few, so they weigh up to four times as much."""
    return (F.binary_cross_entropy_with_logits(logits, label, reduction="none") * (1 + 3 * label)).mean()


def rate_at(step, steps):
    return RATE * min(1, (step + 1) / WARM_UP) * (0.5 + 0.5 * math.cos(math.pi * step / steps)) + 1e-6


def optimiser_of(net):
    kernels = [p for p in net.parameters() if p.ndim > 1]
    others = [p for p in net.parameters() if p.ndim <= 1]
    return torch.optim.AdamW([dict(params=kernels, weight_decay=1e-3), dict(params=others, weight_decay=0)], lr=RATE)


@torch.no_grad()
def follow(average, net, step):
    keep = min(AVERAGE, (step + 1) / (step + 10))
    for mean, now in zip(average.state_dict().values(), net.state_dict().values()):
        if mean.is_floating_point():
            mean.mul_(keep).add_(now, alpha=1 - keep)
        else:
            mean.copy_(now)


def save(path, **what):
    unfinished = path.with_suffix(".part")
    torch.save(what, unfinished)
    os.replace(unfinished, path)


def main():
    words = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("folders", nargs="+", metavar="FOLDER")
    words.add_argument("--out", type=Path, required=True, metavar="NET.pt")
    words.add_argument("--steps", type=int, default=30000)
    words.add_argument("--seed", type=int, default=1)
    words.add_argument("--threads", type=int, default=1)
    asked = words.parse_args()
    torch.set_num_threads(asked.threads)
    cv2.setNumThreads(1)
    torch.manual_seed(asked.seed)
    chance = np.random.default_rng(asked.seed)
    photos = [photo for folder in asked.folders for photo in read_folder(folder)]
    net = ContourNet()
    print(f"{len(photos)} photographs, a net of {count(net)} numbers, {asked.steps} steps", flush=True)
    net = net.to(memory_format=torch.channels_last).train()
    average, optimiser, first = copy.deepcopy(net), optimiser_of(net), 0
    if asked.out.exists():
        kept = torch.load(asked.out)
        if (kept["steps"], kept["seed"], kept["folders"]) != (asked.steps, asked.seed, asked.folders):
            raise SystemExit(f"{asked.out}: was trained with other words; name another --out")
        net.load_state_dict(kept["net"])
        average.load_state_dict(kept["average"])
        optimiser.load_state_dict(kept["optimiser"])
        chance.bit_generator.state, first = kept["chance"], kept["step"]
        print(f"going on after step {first}", flush=True)
    begin, sum_of_losses = time.monotonic(), 0.0
    for step in range(first, asked.steps):
        for group in optimiser.param_groups:
            group["lr"] = rate_at(step, asked.steps)
        x, label = batch(photos, chance)
        logits, quarter, eighth = net(x, taught=True)
        quarter_label = F.max_pool2d(label, 2)
        loss = loss_of(logits, label)
        total = loss + 0.25 * loss_of(quarter, quarter_label) + 0.25 * loss_of(eighth, F.max_pool2d(quarter_label, 2))
        optimiser.zero_grad(set_to_none=True)
        total.backward()
        optimiser.step()
        follow(average, net, step)
        sum_of_losses += float(loss)
        done = step + 1
        if done % TELL_EVERY == 0:
            print(f"{done} steps, loss {sum_of_losses / TELL_EVERY:.4f}, {(time.monotonic() - begin) / 60:.1f} min", flush=True)
            sum_of_losses = 0.0
        if done % SAVE_EVERY == 0 or done == asked.steps:
            save(asked.out, net=net.state_dict(), average=average.state_dict(), optimiser=optimiser.state_dict(),
                 chance=chance.bit_generator.state, step=done, steps=asked.steps, seed=asked.seed, folders=asked.folders)


if __name__ == "__main__":
    main()
