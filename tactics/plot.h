// SPDX-License-Identifier: Apache-2.0
// Data to be felt: points and curves over two axes.
#pragma once

#include <string>
#include <vector>

namespace tactics {

struct Axis {
    std::string name;          ///< with its unit: "time for a picture, ms"
    bool logarithmic = false;  ///< all values must be over 0
};

/// One thing that was measured.
struct PlotMark {
    std::string name;  ///< empty: it has no letter and no line in the key
    double x = 0;
    double y = 0;
    bool filled = true;  ///< a full disc; else a ring
};

struct PlotPoint {
    double x = 0;
    double y = 0;
};

struct PlotCurve {
    std::string name;  ///< empty: it needs no line in the key
    std::vector<PlotPoint> points;
};

/// All values are finite.
struct Plot {
    std::string title;
    Axis x;
    Axis y;
    std::vector<PlotCurve> curves;
    std::vector<PlotMark> marks;
};

}  // namespace tactics
