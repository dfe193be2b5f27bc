// SPDX-License-Identifier: Apache-2.0
// A page as heights: lines, areas and dots raised from a flat ground. All height formats take their rows from here.
#pragma once

#include <memory>
#include <string_view>

#include "print/height_files.h"
#include "tactics/option.h"
#include "tactics/page.h"

namespace tactics {

// With a pitch over 0.5 mm, a line of 0.7 mm could fall between two samples.
inline constexpr Option kReliefPitch{.name = "pitch",
                                     .type = Option::Type::length,
                                     .fallback = 0.1,
                                     .min = 0.02,
                                     .max = 0.5,
                                     .unit = "mm",
                                     .summary = "distance of two samples"};
// Braille dots are 0.48 (NLS Specification 800) to 0.5 mm high (Marburg Medium).
inline constexpr Option kReliefHeight{.name = "height",
                                      .type = Option::Type::length,
                                      .fallback = 0.5,
                                      .min = 0.05,
                                      .max = 10,
                                      .unit = "mm",
                                      .summary = "height of lines, areas and dots"};
inline constexpr Option kReliefProfile{.name = "profile",
                                       .type = Option::Type::choice,
                                       .fallback = 0,
                                       .min = 0,
                                       .max = 1,
                                       .summary = "cross-section of the lines",
                                       .choices = "round flat"};
// The grid is lower than the axes, and these lower than the data, so that a finger can tell them apart by height alone. The
// shares are our own choice: no source gives numbers.
inline constexpr Option kReliefAxes{.name = "axes",
                                    .type = Option::Type::number,
                                    .fallback = 70,
                                    .min = 5,
                                    .max = 100,
                                    .unit = "% of height",
                                    .summary = "height of axes, ticks, lead lines, scale bars and marks"};
inline constexpr Option kReliefGrid{.name = "grid",
                                    .type = Option::Type::number,
                                    .fallback = 40,
                                    .min = 5,
                                    .max = 100,
                                    .unit = "% of height",
                                    .summary = "height of grid lines"};

// Ten layers of 0.2 mm: stiff enough to be lifted off a printer's bed. Our own choice.
inline constexpr Option kPlateBase{.name = "base",
                                   .type = Option::Type::length,
                                   .fallback = 2,
                                   .min = 0.2,
                                   .max = 100,
                                   .unit = "mm",
                                   .summary = "thickness of the plate below the lowest place"};

/// The page must outlive it. Rows are computed one by one from the geometry, so only one row is in memory.
class PageRelief {
public:
    /// Throws Error(usage) at `format` if there would be too many samples.
    PageRelief(const Page& page, const Settings& settings, std::string_view format);
    ~PageRelief();
    PageRelief(const PageRelief&) = delete;
    PageRelief& operator=(const PageRelief&) = delete;

    const HeightSheet& sheet() const { return sheet_; }
    HeightRows rows();  ///< use once, from the top
    HeightMap map();    ///< alternatively, all rows at once

private:
    class Surface;
    HeightSheet sheet_;
    std::unique_ptr<Surface> surface_;
};

}  // namespace tactics
