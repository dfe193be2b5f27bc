#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Fits what merging and choosing of regions go by, and what is said of the page, to what people drew.

    fit.py FOLDER BUILD [--map learned|plain]...

FOLDER is as photos.py says; BUILD a build folder with the program outline_features (-DTACTICS_BENCH=ON) and the net's weights.
Writes filters/pair_weights.inc, arc_weights.inc, silhouette_weights.inc (of the learned map) and trust_weights.inc. The regions that
are compared depend on the weights, so those of pairs are fitted three times, each to the merging by the ones before; the program is built again in between. How
far a page can be trusted is fitted last, to the pages that the others make.
"""

import argparse
import re
import subprocess
from pathlib import Path

import numpy as np
import torch
import torch.nn.functional as F

HERE = Path(__file__).resolve().parents[2]
PAIRS, ARCS, SILHOUETTES, TRUST = 11, 24, 14, 2
NETS, HIDDEN = 3, 16  # the mean of several is steadier than one
# How much it matters that an arc has the same chance in a disturbed copy of the picture: pages of copies agree more with it, and with
# people hardly less.
ALIKE = 0.5
ROUNDS = 3
SHARP = 15  # of the soft choice between parts; of 15 and 30 the one with the better overlap on the even half of the validation photographs
# Where the weights of pairs set out from, so that the same photographs and net end in the same weights.
START = {"learned": "0.8, 1.2, 0.7, 0.7, 1.0, 0.5, 1.3, 0.3, -0.3, -0.5, -7.6", "plain": "0.1, 0.0, 0.5, 1.0, 2.3, 0.6, 0.4, 1.4, -0.6, -0.2, -6.3"}


def rows(build, folder, map_name, what, columns):
    subprocess.run(["cmake", "--build", build, "--target", "outline_features"], check=True, stdout=subprocess.DEVNULL)
    out = subprocess.run([f"{build}/outline_features", folder, map_name, what], check=True, stdout=subprocess.PIPE).stdout
    return np.frombuffer(out, "<f4").reshape(-1, columns)


def logistic(x, y, weight):
    """Logistic regression by Newton's method."""
    b = np.zeros(x.shape[1])
    for _ in range(30):
        p = 1 / (1 + np.exp(-x @ b))
        slope = x.T @ (weight * (y - p)) - 1e-2 * b
        bend = (x * (weight * p * (1 - p))[:, None]).T @ x + 1e-2 * np.eye(len(b))
        b += np.linalg.solve(bend, slope)
    return b


def fit_pairs(table):
    """What is a mixture of two things counts less."""
    return logistic(table[:, :PAIRS].astype(float), table[:, PAIRS], np.clip(table[:, PAIRS + 1], 0, 1) ** 2)


def fit_trust(table):
    """The shares of the line and of what people agree on; where they agree on nothing there is none."""
    x = np.hstack([table[:, :TRUST].astype(float), np.ones((len(table), 1))])
    return [logistic(x, np.clip(y, 0, 1), (y >= 0).astype(float)) for y in table[:, TRUST:].T.astype(float)]


def fit_silhouettes(table):
    """A worth that makes the most of what the choice by it is expected to overlap with what was pointed at, if parts are chosen with
    e to the power of their worth."""
    torch.set_num_threads(1)
    table = torch.tensor(np.ascontiguousarray(table)).double()
    _, hint = torch.unique(table[:, 0].long(), return_inverse=True)
    x, overlap = table[:, 1:1 + SILHOUETTES], table[:, 1 + SILHOUETTES]
    weights = torch.zeros(SILHOUETTES, dtype=torch.double, requires_grad=True)
    optimiser = torch.optim.LBFGS([weights], max_iter=500, line_search_fn="strong_wolfe")

    def sums(values):
        return torch.zeros(int(hint.max()) + 1, dtype=torch.double).index_add(0, hint, values)

    def loss():
        optimiser.zero_grad()
        chance = torch.exp(SHARP * (x @ weights))
        value = -(sums(chance * overlap) / sums(chance)).mean() + 1e-4 * (weights ** 2).sum()
        value.backward()
        return value

    optimiser.step(loss)
    return weights.detach().tolist()


def fit_arcs(table):
    """NETS of fit_net in the mean, which is one net of NETS times HIDDEN sums."""
    nets = [fit_net(table, seed) for seed in range(NETS)]
    mean = [[w / NETS for _, last in nets for w in last[k][:-1]] + [sum(last[k][-1] for _, last in nets) / NETS] for k in range(2)]
    return [row for first, _ in nets for row in first], *mean


def fit_net(table, seed, passes=30, batch=1024):
    """A layer of HIDDEN rectified sums and two of those, to the share of an arc that at least three people drew and to that which is on
    the outline of their main object, alike in copies."""
    torch.manual_seed(seed)
    torch.set_num_threads(1)
    x, copy, y, length = (torch.tensor(np.ascontiguousarray(part))
                          for part in (table[:, :ARCS], table[:, ARCS:2 * ARCS], table[:, 2 * ARCS:2 * ARCS + 2], table[:, 2 * ARCS + 2:2 * ARCS + 3]))
    mean, deviation = x.mean(0), x.std(0) + 1e-6
    net = torch.nn.Sequential(torch.nn.Linear(ARCS, HIDDEN), torch.nn.ReLU(), torch.nn.Linear(HIDDEN, 2))
    optimiser = torch.optim.AdamW(net.parameters(), lr=1e-2, weight_decay=1e-3)
    slower = torch.optim.lr_scheduler.CosineAnnealingLR(optimiser, passes * -(-len(x) // batch))
    for _ in range(passes):
        for some in torch.randperm(len(x)).split(batch):
            share = length[some] / length[some].sum()
            logits = [net((of[some] - mean) / deviation) for of in (x, copy)]
            wrong = sum(F.binary_cross_entropy_with_logits(l, y[some], share, reduction="sum") for l in logits) / 2
            loss = wrong + ALIKE * (share * (logits[0].sigmoid() - logits[1].sigmoid()) ** 2).sum()
            optimiser.zero_grad()
            loss.backward()
            optimiser.step()
            slower.step()
    first = net[0].weight.detach() / deviation
    constant = net[0].bias.detach() - first @ mean
    return torch.cat([first, constant[:, None]], 1).tolist(), [w + [b] for w, b in zip(net[2].weight.tolist(), net[2].bias.tolist())]


def as_float(value):
    text = f"{value:.4g}"
    return text + ("f" if "." in text or "e" in text else ".0f")


def replace(path, name, kind, body):
    """Puts `constexpr kind name{body};` in place of the one that is there."""
    text, found = re.subn(rf"constexpr {kind} {name}\{{.*?\}};\n", lambda _: f"constexpr {kind} {name}{{{body}}};\n", path.read_text(), flags=re.S)
    if found != 1:
        raise SystemExit(f"{path}: there is no {name}")
    path.write_text(text)


def main():
    words = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("folder")
    words.add_argument("build")
    words.add_argument("--map", action="append", choices=["learned", "plain"])
    asked = words.parse_args()
    for name in asked.map or ["learned", "plain"]:
        title = name.capitalize()
        replace(HERE / "pair_weights.inc", f"k{title}Pairs", "PairWeights", START[name])
        for _ in range(ROUNDS):
            pairs = fit_pairs(rows(asked.build, asked.folder, name, "pairs", PAIRS + 2))
            replace(HERE / "pair_weights.inc", f"k{title}Pairs", "PairWeights", ", ".join(f"{v:.4f}" for v in pairs))
        first, *last = fit_arcs(rows(asked.build, asked.folder, name, "arcs", 2 * ARCS + 3))
        lines = ",\n    ".join("{" + ", ".join(map(as_float, row)) + "}" for row in first)
        replace(HERE / "arc_weights.inc", f"k{title}Arcs", "ArcWeights",
                "{\n    " + lines + "}" + "".join(",\n    {" + ", ".join(map(as_float, row)) + "}" for row in last))
        if name == "learned":
            worth = fit_silhouettes(rows(asked.build, asked.folder, name, "points", SILHOUETTES + 2))
            replace(HERE / "silhouette_weights.inc", "kSilhouetteWeights", "SilhouetteFeatures", ", ".join(f"{v:.3f}" for v in worth))
        trust = ["{" + ", ".join(map(as_float, row)) + "}" for row in fit_trust(rows(asked.build, asked.folder, name, "pages", TRUST + 2))]
        replace(HERE / "trust_weights.inc", f"k{title}Trust", "TrustWeights", ", ".join(trust))


if __name__ == "__main__":
    main()
