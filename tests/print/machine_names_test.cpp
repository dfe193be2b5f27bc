// SPDX-License-Identifier: Apache-2.0
// Machines by the names of their models.
#include <set>

#include "print/embosser.h"
#include "print/format.h"
#include "tactics/text/words.h"
#include "tests/cli/converting.h"

namespace tactics {
namespace {

using namespace tests;

std::string driver_of(std::string_view name) {
    const Format* format = find_model(name);
    return format == nullptr ? "none" : std::string(format->name);
}

TEST(MachineNames, FindWhatDrivesThem) {
    for (const std::string_view name :
         {"everest", "Everest-D", "everest-d v5", "basic-d", "Index Basic-D V4", "index everest-d", "juliet 120"})
        EXPECT_EQ(driver_of(name), "index-v4") << name;
    for (const std::string_view name : {"romeo", "Juliet", "enabling_technologies_thomas"})
        EXPECT_EQ(driver_of(name), "enabling") << name;
    EXPECT_EQ(driver_of("Basic V3"), "index-v3");
    EXPECT_EQ(driver_of("spotdot") + driver_of("ViewPlus SpotDot"), "viewplusviewplus");
    for (const std::string_view name : {"", "-", "d", "everest-d-v7", "viewplus-everest", "printer"})
        EXPECT_EQ(driver_of(name), "none") << name;
    EXPECT_EQ(driver_of(std::string(100'000, 'x')), "none");
}

// Parted at commas and semicolons, what an entry tells people is understood; a name is one machine's, and no format's.
TEST(MachineNames, EveryModelThatIsToldIsKnown) {
    std::set<std::string_view> names;
    for (const Format* format : formats()) {
        if (format->embosser == nullptr) continue;
        for (const std::string_view called : words_of(format->embosser->called)) {
            EXPECT_TRUE(names.insert(called).second) << called;
            EXPECT_EQ(find_format(called), nullptr) << called;
            EXPECT_EQ(driver_of(called), format->name);
        }
        if (format->embosser->called.empty() || format->embosser->display != nullptr) continue;
        std::string told(format->embosser->models), maker;
        for (std::size_t end = 0; !told.empty(); told.erase(0, std::min(end + 2, told.size()))) {
            end = std::min(told.find_first_of(",;"), told.size());
            std::string name = told.substr(0, end);
            name = name.substr(0, name.find(" and "));
            if (driver_of(name) == "none" && !maker.empty()) name = maker + " " + name;
            if (maker.empty()) maker = name.substr(0, name.find(' '));
            EXPECT_NE(driver_of(name), "none") << name;
        }
    }
}

class NamedMachine : public Convert {};

TEST_F(NamedMachine, IsDrivenAndTold) {
    const Ending model = convert({"disc.tif", "-o", "everest:a.prn"});
    EXPECT_EQ(model.code, 0) << model.err;
    EXPECT_TRUE(model.err.starts_with("everest is driven as index-v4\n")) << model.err;
    EXPECT_EQ(convert({"disc.tif", "-q", "-o", "index-v4:b.prn"}).err, "");
    EXPECT_EQ(bytes_of(folder / "a.prn"), bytes_of(folder / "b.prn"));
    EXPECT_EQ(convert({"disc.tif", "--warnings", "-o", "out/", "--to", "Romeo"}).code, 0);
    EXPECT_EQ(convert({"disc.tif", "-o", "out/", "--to", "evrest"}).err,
              "tactics: --to: there is no format \"evrest\" (everest?); see tactics list formats\n");
    const std::string help = run_tactics(folder, {"help", "spotdot"}).out;
    EXPECT_TRUE(help.starts_with("spotdot is driven as viewplus.\n") && holds(help, "embosser viewplus: ")) << help;
    EXPECT_TRUE(holds(run_tactics(folder, {"list", "embossers"}).out, "; called basic-d basic everest-d everest "));
    EXPECT_TRUE(holds(run_tactics(folder, {"list", "embossers", "--json"}).out, "\"models\":[\"basic-d\",\"basic\","));
    const Ending preview = run_tactics(folder, {"preview", "a.prn", "--embosser", "everest-d v5"});
    EXPECT_EQ(preview.code, 0) << preview.err;
    EXPECT_TRUE(holds(preview.err, "everest-d v5 is driven as index-v4\n")) << preview.err;
}

}  // namespace
}  // namespace tactics
