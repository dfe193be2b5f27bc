// SPDX-License-Identifier: Apache-2.0
// A page that two hands can survey.
#include "tactics/rules/page_geometry.h"
#include "tactics/rules/rule.h"

namespace tactics {

namespace {

constexpr double kSquareMmPerCm = 100;
constexpr double kA3 = 297 * 420 / kSquareMmPerCm;

Findings check_paper(const PageGeometry& geometry, double limit) {
    const Page& page = geometry.page;
    const double size = page.width * page.height / kSquareMmPerCm;
    if (size <= limit + kRounding) return {};
    return {{{size,
              {0, 0},
              {},
              phrase("a page of {0} x {1} mm, {2} square cm", shown(page.width), shown(page.height), shown(size)),
              true}}};
}

}  // namespace

extern const Rule paper_rule;
const Rule paper_rule{
    .name = "paper",
    .summary = "a page no larger than A3",
    .mend = "use A4, or divide the drawing over several pages",
    .source =
        "tacticos.eu guidelines, chapter 4: A4 suits two hands, more than A3 is inconvenient. Measured by area, so 11 x 17 in "
        "passes",
    .confidence = Confidence::good,
    .limit = {.name = "most",
              .type = Option::Type::number,
              .fallback = kA3,
              .min = 10,
              .max = 1e6,
              .unit = "square cm",
              .summary = "maximum area of a page"},
    .check = check_paper,
};

}  // namespace tactics
