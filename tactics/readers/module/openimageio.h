// SPDX-License-Identifier: Apache-2.0
// The border between the program and its OpenImageIO module. Linking OpenImageIO costs 0.2 s and 128 MiB at every start,
// so it is in a shared object of its own that is opened for the first file that needs it.
//
// Only C types cross, and no exception does: both sides may be built by different compilers. A function that fails says
// so by its result and writes one line of text to `why` (cut at `why_size`). Pictures are independent of each other;
// different threads may use different ones.
#pragma once

#include <cstddef>

extern "C" {

typedef struct TacticsOiioPicture TacticsOiioPicture;

typedef struct TacticsOiioFacts {
    int width;
    int height;
    int colours;     /* 1 grey, 3 red green blue */
    int alpha;       /* behind the colours: 0 none, 1 straight, 2 premultiplied */
    int linear;      /* samples are 0: unsigned char, sRGB-coded; 1: float, linear light */
    int orientation; /* 1 to 8 as in EXIF */
    int batch;       /* how many rows are read at a time with least work */
} TacticsOiioFacts;

/* Text that stands in a file under a name. */
typedef struct TacticsOiioWord {
    const char* name;
    const char* text;
} TacticsOiioWord;

/* A grey picture of decimal numbers to be written, and what calls back for its rows and takes the file. `user` is handed to both.
 */
typedef struct TacticsOiioPlan {
    int width;
    int height;
    const TacticsOiioWord* words;
    int word_count;
    void* user;
    const float* (*row)(void* user, int y); /* asked for once each, from the top */
    void (*take)(void* user, const void* bytes, std::size_t size);
} TacticsOiioPlan;

typedef struct TacticsOiio {
    /* `format` is OpenImageIO's name of it ("webp"); the file's name plays no part. NULL on failure. */
    TacticsOiioPicture* (*open)(const char* format, const char* path, TacticsOiioFacts* facts, char* why, std::size_t why_size);
    /* Rows first to end - 1, in order from the top, without padding. `first` is a multiple of `batch`. 0 on failure. */
    int (*read)(TacticsOiioPicture* picture, int first, int end, void* rows, char* why, std::size_t why_size);
    void (*close)(TacticsOiioPicture* picture);
    /* The text that the file has under that name, cut at `size` with its final 0. 0 if there is none. */
    int (*word)(TacticsOiioPicture* picture, const char* name, char* text, std::size_t size);
    /* A whole file in memory. 0 on failure. */
    int (*write)(const char* format, const TacticsOiioPlan* plan, char* why, std::size_t why_size);
} TacticsOiio;

/* The module's only symbol. The number goes up with every change of this file, so that an old module is not misused. */
const TacticsOiio* tactics_oiio_2(void);
}
