// SPDX-License-Identifier: Apache-2.0
// Machines by the names of their models.
#include <set>

#include "print/embosser.h"
#include "print/format.h"
#include "tactics/text/words.h"
#include "tests/cli/converting.h"

namespace tactics::machine_names_test {
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

// What a model is set to can be set, and is of a name that is called.
TEST(MachineNames, SettingsOfModelsAreSettings) {
    std::size_t models = 0;
    for (const Format* format : formats()) {
        if (format->embosser == nullptr) continue;
        for (const ModelSettings& own : format->embosser->settings_by_model) {
            EXPECT_EQ(driver_of(own.called), format->name);
            EXPECT_EQ(settings_of_model(own.called), own.settings);
            Settings settings(format->options);
            set_model(settings, own.called, "test");
            EXPECT_EQ(settings.to_text(), own.settings);
            EXPECT_EQ(own_paper(*format, settings) == "letter", own.called == "romeo-attache");
            ++models;
        }
    }
    EXPECT_GT(models, 10u);
    EXPECT_TRUE(settings_of_model("everest").empty() && settings_of_model("nothing").empty());
}

class NamedMachine : public Convert {};

// The page keeps to the cells that the model has, and the bytes are those of its settings.
TEST_F(NamedMachine, IsSetAsItsModelIs) {
    const auto widest = [&](const std::string& name) {
        std::size_t most = 0;
        const std::string shown = run_tactics(folder, {"preview", name, "-e", "enabling", "--unicode"}).out;
        for (std::size_t at = 0, end = 0; (end = shown.find('\n', at)) != std::string::npos; at = end + 1)
            most = std::max(most, (end - at) / 3);  // bytes of a cell in UTF-8
        return most;
    };
    for (const auto& [model, cells] :
         {std::pair{"romeo", 40u}, {"romeo-attache", 32u}, {"Juliet Pro 60", 40u}, {"phoenix", 45u}}) {
        const std::string name = std::string(model) + ":a.prn";
        const Ending made = convert({"disc.tif", "-o", name, "-r", "none", "--title", std::string(200, 'x')});
        ASSERT_EQ(made.code, 0) << made.err;
        EXPECT_TRUE(holds(made.err, std::string(model) + " is driven as enabling, model=")) << made.err;
        EXPECT_LE(widest("a.prn"), cells) << model;
        EXPECT_GE(widest("a.prn"), cells - 2) << model;
    }
    EXPECT_EQ(convert({"disc.tif", "-q", "-o", "romeo:a.prn"}).code, 0);
    EXPECT_EQ(convert({"disc.tif", "-q", "-o", "enabling:b.prn", "--set", "enabling.model=romeo"}).code, 0);
    EXPECT_EQ(convert({"disc.tif", "-q", "-o", "juliet:c.prn", "--set", "enabling.model=romeo"}).code, 0);
    EXPECT_EQ(bytes_of(folder / "a.prn"), bytes_of(folder / "b.prn"));
    EXPECT_EQ(bytes_of(folder / "a.prn"), bytes_of(folder / "c.prn")) << "what is set counts";
    EXPECT_TRUE(holds(convert({"disc.tif", "-o", "romeo:a.prn", "-o", "juliet:b.prn"}).err, "convert for one machine at a time"));
}

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
}  // namespace tactics::machine_names_test
