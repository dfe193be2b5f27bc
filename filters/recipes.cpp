// SPDX-License-Identifier: Apache-2.0
// The recipes that come with the program. Each text is a recipe file: `--save-recipe` writes it, a start for
// one's own.
#include "filters/list.h"

namespace tactics {

namespace {

// The first five are the five sequences of the pilot study of TACTICS (J. P. Fritz, T. P. Way, K. E. Barner, Haptic
// Representation of Scientific Data for Visually Impaired or Blind Persons, section 2): no processing, either filter, both
// in either order.
constexpr NamedRecipe kRecipes[] = {
    {"none", "the picture as it is, in black dots",
     "resample dpi=100\n"
     "halftone\n"},
    {"kmeans", "regions of similar grey, in black dots",
     "resample dpi=100\n"
     "kmeans k=4\n"
     "halftone\n"},
    {"sobel", "edges of the picture above a fixed strength",
     "resample dpi=100\n"
     "sobel\n"
     "threshold method=fixed level=40\n"
     "trace\n"
     "thin-crowds\n"
     "simplify\n"},
    {"kmeans-sobel", "regions of similar grey, then the edges between them",
     "resample dpi=100\n"
     "kmeans k=4\n"
     "sobel\n"
     "threshold method=fixed level=10\n"
     "trace\n"
     "simplify\n"},
    {"sobel-kmeans", "edges first, then segmentation selects the strong ones: best in the pilot study",
     "resample dpi=100\n"
     "sobel\n"
     "kmeans k=4 keep=2\n"
     "trace\n"
     "thin-crowds\n"
     "simplify\n"},
    {"photo", "photographs: a few whole outlines of what people would draw",
     "resample dpi=50\n"
     "nest\n"
     "outlines\n"
     "simplify\n"},
    // The cut by classes of strength follows the picture's own contrast; only the weakest of eight goes. What is finer than 0.95
    // % of the side, 2 mm on A4, is left out, so that the drawing stays what it is when the picture is stored, lit or turned
    // otherwise.
    {"fast", "photographs in a fraction of the time of photo, as edges in short lines: for many pictures or a slow machine",
     "resample dpi=25\n"
     "contours scene=0.95 along=2.5mm\n"
     "kmeans k=8 keep=7\n"
     "strongest\n"
     "trace\n"
     "separate\n"
     "simplify\n"},
    // A face on A4 has eyes of 10 to 25 mm: regions from 5 mm, lines rounded less and as near as the rules allow, 3.2 mm of
    // ground between lines of 0.7 and 1 mm. Lips are fainter to a map of contours than the border of a head.
    {"portrait", "faces: as photo, with lines for eyes, nose and mouth",
     "resample dpi=75\n"
     "nest smallest=5mm\n"
     "outlines sure=0.55 gap=4.1mm bend=1mm inner=0.25\n"
     "simplify\n"},
    // Axes of charts are 0.3 mm on A4, curves 0.5.
    {"diagram", "charts and diagrams: lines and outlines, most of the lettering left out",
     "resample dpi=150\n"
     "contours blur=0.4mm along=0.6mm surround=0 lines=0.8mm\n"
     "threshold method=hysteresis low=15 high=40\n"
     "despeckle size=9mm\n"
     "trace shortest=12mm\n"
     "separate gap=2.5mm shortest=9mm\n"
     "simplify\n",
     true},
    {"map", "maps: borders of large coloured regions, small blocks and lettering left out",
     "resample dpi=75\n"
     "denoise method=median size=4mm\n"
     "contours blur=1.2mm along=1.2mm surround=0\n"
     "kmeans k=4 keep=3\n"
     "trace shortest=20mm\n"
     "separate\n"
     "simplify\n",
     true},
    // A border lies between two flat colours, whatever line is drawn there, so it needs no edge detector; and
    // borders meet, so they are not kept apart: page mending does that where they come too near.
    {"borders", "maps in plain colours: every border between two regions, whole and once",
     "resample dpi=90\n"
     "borders\n"
     "simplify\n",
     true},
    // Fine enough for the frame and the curves on a field; a level line is smoothed wider than that.
    {"levels", "heat maps, filled contours and pictures with a colour bar: a few levels of value, each with a texture",
     "resample dpi=75\n"
     "levels\n"
     "simplify\n",
     true},
    // Clean, soft borders first: what a median of 3 mm takes away has no room for a texture. The numbers of colours and of
    // regions are chosen from the picture (kmeans k=0, regions smallest=0).
    {"regions", "maps, diagrams of areas and simple scenes: each region with its outline and a texture",
     "resample dpi=75\n"
     "denoise method=median size=3mm\n"
     "kmeans k=0 colour=yes\n"
     "regions\n",
     true},
    // A coloured curve is ink, too, and a dotted one a line; what stays a speck then is too short for trace.
    {"line-art", "drawings in ink of any colour: the middle of each line",
     "resample dpi=150\n"
     "darken\n"
     "threshold method=otsu\n"
     "dashes\n"
     "despeckle size=0.6mm\n"
     "trace\n"
     "simplify\n",
     true},
};

}  // namespace

std::span<const NamedRecipe> named_recipes() { return kRecipes; }

}  // namespace tactics
