#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A page of a picture from Python, through the library for C.

    samples/hello.py photo.jpg photo.pdf title="Hot air balloon" paper=a4 strict

Behind the two files come the options of `tactics convert` without their dashes. The library is libtactics.so.0 where the system
looks for libraries, or the file that the variable TACTICS_LIBRARY names."""
import ctypes
import json
import os
import sys


class Tactics:
    """libtactics.so.0, with the types of its functions."""

    STEPS = ("reading", "drawing", "laying out", "writing")
    WATCH = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_int, ctypes.c_void_p)

    def __init__(self, path):
        job, text, code = ctypes.c_void_p, ctypes.c_char_p, ctypes.c_int
        self.library = ctypes.CDLL(path)
        for name, result, arguments in (
            ("version", text, []), ("new", job, []), ("free", None, [job]), ("input", code, [job, text]),
            ("input_bytes", code, [job, ctypes.c_char_p, ctypes.c_size_t, text]), ("output", code, [job, text]),
            ("option", code, [job, text, text]), ("on_step", None, [job, self.WATCH, ctypes.c_void_p]), ("cancel", None, [job]),
            ("run", code, [job]), ("message", text, [job]), ("told_count", ctypes.c_size_t, [job]),
            ("told", text, [job, ctypes.c_size_t]), ("told_asks", ctypes.c_int, [job, ctypes.c_size_t]), ("json", text, [job])):
            function = getattr(self.library, "tactics_" + name)
            function.restype, function.argtypes = result, arguments
            setattr(self, name, function)


class Failure(Exception):
    """Its code is that with which the program would end."""

    def __init__(self, code, message):
        super().__init__(message)
        self.code = code


def convert(tactics, source, target, options, step=lambda name: None):
    """Makes the page. Gives what was told, a line each, and the same as a dictionary. Several threads may do so at a time."""
    job = tactics.new()
    watch = Tactics.WATCH(lambda at, user: step(Tactics.STEPS[at]) or 0)  # kept until the job is done

    def check(code):
        if code != 0:
            raise Failure(code, tactics.message(job).decode())

    try:
        check(tactics.input(job, os.fsencode(source)))
        check(tactics.output(job, os.fsencode(target)))
        for name, value in options:
            check(tactics.option(job, name.encode(), None if value is None else value.encode()))
        tactics.on_step(job, watch, None)
        check(tactics.run(job))
        told = [tactics.told(job, i).decode() for i in range(tactics.told_count(job))]
        return told, json.loads(tactics.json(job))
    finally:
        tactics.free(job)


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    tactics = Tactics(os.environ.get("TACTICS_LIBRARY", "libtactics.so.0"))
    options = [(word.partition("=")[0], word.partition("=")[2] if "=" in word else None) for word in sys.argv[3:]]
    try:
        told, _ = convert(tactics, sys.argv[1], sys.argv[2], options, lambda name: print(name, file=sys.stderr))
    except Failure as failure:
        print(failure, file=sys.stderr)
        sys.exit(failure.code)
    print("\n".join(told))


if __name__ == "__main__":
    main()
