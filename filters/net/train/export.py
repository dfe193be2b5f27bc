#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Writes a trained net as the integers that tactics runs.

    export.py NET.pt OUT.net                                    as train.py wrote it, for filters/net/weights/
    export.py NET.pt OUT.net --picture P.png --reference OUT    and what the net must answer to that picture: int16
                                                                logits row by row, half the picture's size, little-endian

OUT.net, numbers little-endian:
    "TNET", version, count of layers; channels at the four scales; residual blocks at the four scales (u16 each)
    u64  FNV-1a of the logits of a picture that integers.py draws: the program's tests draw it, too
    for each layer: outputs, inputs (u16), side of the kernel, 1 if depthwise, shift, 0 (u8)
    for each layer: u8 a output: its weights are shifted up by; i32 a output: bias; i8: weights[output][input][row][column]
    u32  CRC-32 of all before
"""

import argparse
import struct
import zlib
from pathlib import Path

import cv2
import numpy as np
import torch

import integers
from model import EIGHTH, HALF, QUARTER, SIXTEENTH, ContourNet

CHANNELS, BLOCKS = (HALF, QUARTER, EIGHTH, SIXTEENTH), (1, 1, 3, 4)


def layers_of(path, bits=8):
    net = ContourNet()
    net.load_state_dict(torch.load(path, map_location="cpu")["average"])
    return [integers.quantise(*folded, bits) for folded in net.eval().fold()]


def bytes_of(layers):
    proof = integers.hash_of(integers.logits_of(layers, BLOCKS, integers.drawn_picture()))
    out = b"TNET" + struct.pack("<10HQ", 1, len(layers), *CHANNELS, *BLOCKS, proof)
    for layer in layers:
        outputs, inputs, side, _ = layer.stored.shape
        out += struct.pack("<2H4B", outputs, outputs if layer.each else inputs, side, layer.each, layer.shift, 0)
    for layer in layers:
        out += layer.up.astype("u1").tobytes() + layer.bias.astype("<i4").tobytes() + layer.stored.astype("i1").tobytes()
    return out + struct.pack("<I", zlib.crc32(out))


def main():
    words = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("net", type=Path, metavar="NET.pt")
    words.add_argument("out", type=Path, metavar="OUT.net")
    words.add_argument("--picture", type=Path, metavar="P.png")
    words.add_argument("--reference", type=Path, metavar="OUT")
    asked = words.parse_args()
    if (asked.picture is None) != (asked.reference is None):
        raise SystemExit("export.py: --picture and --reference go together")
    layers = layers_of(asked.net)
    written = bytes_of(layers)
    asked.out.write_bytes(written)
    print(f"{asked.out}: {len(written)} bytes, shifts {' '.join(str(layer.shift) for layer in layers)}")
    if asked.picture:
        image = cv2.imread(str(asked.picture))
        if image is None:
            raise SystemExit(f"{asked.picture}: not a picture that can be read")
        logits = integers.logits_of(layers, BLOCKS, image)
        asked.reference.write_bytes(logits.tobytes())
        print(f"{asked.reference}: {logits.shape[1]} x {logits.shape[0]}, hash {integers.hash_of(logits):016x}")


if __name__ == "__main__":
    main()
