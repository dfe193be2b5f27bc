// SPDX-License-Identifier: Apache-2.0
// A drawing whose lines are too close, as the user meets it.
#include <gtest/gtest.h>

#include "tests/cli/converting.h"

namespace tactics::mending_test {
namespace {

using namespace tests;
namespace fs = std::filesystem;

// Black lines at that distance in pixels, on a picture of 200 x 200.
std::string stripes(int apart) {
    return grey_picture(200, 200, [apart](int x, int y) { return x > 20 && x < 180 && y % apart == apart / 2 ? 0 : 255; });
}

class Mending : public Convert {
protected:
    Mending() {
        write_bytes(folder / "wide.tif", stripes(20));
        write_bytes(folder / "near.tif", stripes(4));  // 3.7 mm on A4: 2.7 mm of white
        write_bytes(folder / "dense.tif", stripes(2));
    }
    Ending lines(const std::string& picture, const std::string& page, Words more = {}) {
        Words words{picture, "-f", "threshold", "-f", "trace shortest=0", "-o", page};
        words.insert(words.end(), more.begin(), more.end());
        return convert(words);
    }
    std::string hard_places(const std::string& page) { return run_tactics(folder, {"check", page, "--rule", "gap"}).out; }
};

TEST_F(Mending, ChangesWhatIsTooCloseAndSaysSo) {
    const Ending wide = lines("wide.tif", "wide.svg");
    EXPECT_FALSE(holds(wide.err, "changed to be felt")) << wide.err;
    const Ending near = lines("near.tif", "near.svg");
    EXPECT_EQ(near.code, 0);
    EXPECT_TRUE(holds(near.err, "near.tif: changed to be felt: ")) << near.err;
    EXPECT_TRUE(holds(hard_places("near.svg"), "no rule is broken")) << hard_places("near.svg");
    const Ending as_drawn = lines("near.tif", "drawn.svg", {"--as-drawn"});
    EXPECT_FALSE(holds(as_drawn.err, "changed to be felt")) << as_drawn.err;
    EXPECT_TRUE(holds(hard_places("drawn.svg"), "places break hard rules")) << hard_places("drawn.svg");
    const Ending checked =
        run_tactics(folder, {"check", "near.tif", "-f", "threshold", "-f", "trace shortest=0", "--rule", "gap"});
    EXPECT_TRUE(holds(checked.out, "no rule is broken")) << checked.out;
}

TEST_F(Mending, IsAPartOfTheDescription) {
    const Words words{"describe", "near.tif", "-f", "threshold", "-f", "trace shortest=0"};
    const Ending near = run_tactics(folder, words);
    EXPECT_TRUE(holds(near.out, "\nChanged to be felt:\n")) << near.out;
    Words as_drawn = words;
    as_drawn.push_back("--as-drawn");
    EXPECT_FALSE(holds(run_tactics(folder, as_drawn).out, "Changed to be felt"));
}

TEST_F(Mending, TellsEachPlaceToScripts) {
    const std::string json = lines("near.tif", "near.svg", {"--json"}).out;
    EXPECT_TRUE(holds(json, "\"hard_after\":0,\"kept\":0.")) << json;
    EXPECT_TRUE(holds(json, "\"changes\":[{\"what\":\"")) << json;
    EXPECT_FALSE(holds(json, "\"hard_before\":0,")) << json;
    // Pages that were not examined are not reported.
    EXPECT_FALSE(holds(lines("near.tif", "near.svg", {"--json", "--as-drawn"}).out, "hard_before"));
}

TEST_F(Mending, SaysWhatToDoAboutWhatCannotBeMended) {
    const Ending dense = lines("dense.tif", "dense.svg");
    EXPECT_EQ(dense.code, 0);
    EXPECT_TRUE(holds(dense.err, "dense.tif: too much is too close for a finger in this size; ")) << dense.err;
    EXPECT_TRUE(holds(dense.err, "describe it instead: tactics describe")) << dense.err;
    EXPECT_TRUE(holds(hard_places("dense.svg"), "no rule is broken"));
}

}  // namespace
}  // namespace tactics::mending_test
