// SPDX-License-Identifier: Apache-2.0
// Any bytes as SVG: a page or one line of what is wrong, and every rule comes to an end on it.
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "tactics/error.h"
#include "tactics/readers/svg/figure.h"
#include "tactics/readers/svg/own_page.h"
#include "tactics/readers/svg/svg.h"
#include "tactics/rules/rule.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace tactics;
    try {
        const std::string_view bytes =
            size == 0 ? std::string_view() : std::string_view(reinterpret_cast<const char*>(data), size);
        if (const auto own = read_own_page(bytes, "fuzzed.svg"))
            for (const PageStroke& stroke : own->page.strokes)
                for (const Point& p : stroke.points)
                    if (!(p.x >= 0 && p.x <= own->page.width && p.y >= 0 && p.y <= own->page.height)) std::abort();
        const FoundPage found = read_svg(bytes, "fuzzed.svg", 10, Paper{"a4", "", 210, 297});
        const Drawing drawing =
            drawing_of_figure(read_svg(bytes, "fuzzed.svg", 0, Paper{"a4", "", 210, 297}, SvgPurpose::figure), 200);
        for (const Stroke& stroke : drawing.strokes)
            if (stroke.points.size() < (stroke.closed ? 3u : 2u)) std::abort();
        if (!(found.page.width > 0) || !(found.page.height > 0)) std::abort();
        // All media have the same rules, with other limits; one of them for each input, so that a full page is searched once.
        const Medium& medium = media()[size % media().size()];
        for (const Verdict& verdict : check_page(found.page, demands_of(medium)))
            for (const Finding& finding : verdict.findings.places)
                if (!std::isfinite(finding.measured) || !std::isfinite(finding.at.x) || finding.message.empty()) std::abort();
    } catch (const Error& error) {
        if (error.what()[0] == '\0') std::abort();
    }
    return 0;
}
