// SPDX-License-Identifier: Apache-2.0
#include "tactics/text/named_unit.h"

#include <gtest/gtest.h>

namespace tactics::named_unit_test {
namespace {

TEST(NamedUnit, IsTakenApart) {
    struct Case {
        const char *text, *name, *unit;
    };
    for (const Case& one : {Case{"time (s)", "time", "s"},
                            {"time [s]", "time", "s"},
                            {"time, s", "time", "s"},
                            {" length(mm) ", "length", "mm"},
                            {"F (0 to 1) (%)", "F (0 to 1)", "%"},
                            {"time for a picture, ms", "time for a picture", "ms"},
                            {"force, N/mm", "force", "N/mm"},
                            {"moment, kg·m²/s²", "moment", "kg·m²/s²"},
                            {"light, counts", "light", "counts"},
                            {"rivers, named", "rivers", "named"},
                            {"rivers, unnamed", "rivers, unnamed", ""},
                            {"a, of b", "a, of b", ""},
                            {"dots a page", "dots a page", ""},
                            {"(s)", "(s)", ""},
                            {", s", ", s", ""},
                            {"a,", "a,", ""},
                            {"", "", ""},
                            {"a)", "a)", ""},
                            {"pressure [bar] (mean)", "pressure [bar]", "mean"}}) {
        const NamedUnit taken = name_and_unit(one.text);
        EXPECT_EQ(taken.name, one.name) << one.text;
        EXPECT_EQ(taken.unit, one.unit) << one.text;
    }
}

}  // namespace
}  // namespace tactics::named_unit_test
