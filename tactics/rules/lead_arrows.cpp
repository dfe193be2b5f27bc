// SPDX-License-Identifier: Apache-2.0
// A lead line ends bare: with a head it says that something goes there.
#include "tactics/rules/arrows.h"
#include "tactics/rules/page_geometry.h"
#include "tactics/rules/rule.h"

namespace tactics {

namespace {

Findings check_lead_arrows(const PageGeometry& geometry, double limit) {
    double headed = 0;
    Point first;
    for (const std::uint32_t c : chains_with(geometry, Role::lead)) {
        bool head = false;
        for (const PageGeometry::Meets& meets : geometry.contacts_of[c]) {
            const Contact& contact = geometry.contacts[meets.contact];
            const std::size_t other = meets.turned ? contact.one.chain : contact.other.chain;
            head = head || geometry.role_of(geometry.chains[other]) == Role::arrow;
        }
        if (head && headed++ == 0) first = geometry.point_at({c, 0});
    }
    if (headed <= limit) return {};
    return {{{headed,
              first,
              {},
              phrases(static_cast<std::size_t>(headed), "{0} lead line with an arrow head",
                      "{0} lead lines with arrow heads, the first here")}}};
}

}  // namespace

extern const Rule lead_arrows_rule;
const Rule lead_arrows_rule{
    .name = "lead-arrows",
    .summary = "lead lines have no arrow heads",
    .mend = "leave out the head",
    .source =
        "a rule file after BANA 3.4.3.5: the least line of the page, 3/4 to 1 1/2 in (2 to 3.75 cm) long, without arrow head; "
        "known at second hand",
    .confidence = Confidence::medium,
    .limit = {.name = "most",
              .type = Option::Type::whole,
              .fallback = 0,
              .min = 0,
              .max = 1000,
              .summary = "maximum number of lead lines with an arrow head"},
    .check = check_lead_arrows,
};

}  // namespace tactics
