// SPDX-License-Identifier: Apache-2.0
// `tactics evaluate --study matching`: the pilot study of TACTICS with simulated readers.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "studies/study.h"
#include "tactics/measure/fingertip.h"
#include "tactics/measure/score.h"

namespace tactics {

/// One sheet: what is on it, beside how well it is found again.
struct SheetFacts {
    double ink = 0;     ///< share of the sheet that is raised
    double length = 0;  ///< mm of stroke
    Counts contours;    ///< against people's contour maps; no truth if there are none
    std::size_t hits = 0;
};

struct Mistake {
    std::size_t picture = 0, taken_for = 0;
    std::size_t times = 0;
};

struct MatchedRecipe {
    std::string name;
    std::vector<SheetFacts> sheets;  ///< by picture
    std::vector<Mistake> mistakes;   ///< most frequent first
    std::vector<double> changed;     ///< rates of the readers with one parameter changed
    std::vector<double> random;      ///< rates of the readers with all parameters at random

    std::size_t hits() const;
    std::size_t empty() const;  ///< sheets with nothing on them
};

/// The usual reader but for one thing.
struct ChangedReader {
    Phrase change;  ///< "places 8"
    FingertipReader reader;
};

struct MatchingStudy {
    std::vector<std::string> pictures;  ///< those of which every recipe made a sheet
    std::vector<std::size_t> sets;      ///< how many pictures each closed set has, in the order of the pictures
    int readers = 0;                    ///< each looks once for each picture
    FingertipReader reader;
    std::vector<MatchedRecipe> recipes;
    std::vector<ChangedReader> changed_readers;
    std::vector<FingertipReader> random_readers;
    std::vector<Phrase> problems;

    std::size_t trials() const { return pictures.size() * static_cast<std::size_t>(readers); }  ///< of each recipe
    double chance() const;  ///< the rate of a reader who guesses
};

}  // namespace tactics
