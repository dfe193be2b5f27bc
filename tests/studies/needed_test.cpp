// SPDX-License-Identifier: Apache-2.0
// `tactics evaluate --study needed` as the user meets it.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/filters/weights.h"
#include "tests/patterns.h"
#include "tests/studies/discs.h"

namespace tactics::needed_test {
namespace {

using namespace tests;
namespace fs = std::filesystem;
using EvaluateNeeded = EvaluateDiscs;

// The numbers after `name`, of the nth time that it occurs.
std::vector<double> numbers_after(const std::string& json, const std::string& name, std::size_t from = 0) {
    const auto at = json.find("\"" + name + "\":[", from);
    std::vector<double> numbers;
    if (at == std::string::npos) return numbers;
    const auto open = json.find('[', at), close = json.find(']', at);
    const std::string inside = json.substr(open + 1, close - open - 1);
    for (const tests::Fit& number : tests::all_fits(inside, "[-0-9.e]+")) numbers.push_back(std::stod(number[0]));
    return numbers;
}

TEST_F(EvaluateNeeded, TheStudyOfWhatIsNeeded) {
    SKIP_WITHOUT_WEIGHTS();
    const Ending ending = evaluate({"-q", "--json", "-r", "photo", "-r", "none", "--study", "needed", "--chart", "n.svg"});
    EXPECT_EQ(ending.code, 0) << ending.err;
    const std::string photo = ending.out.substr(0, ending.out.find('\n'));
    const auto own_f = [&](std::size_t from) { return std::stod(photo.substr(photo.find("\"own_f\":", from) + 8)); };
    // All of the grey levels of a grey picture, and all strokes, are the recipe as it is.
    std::size_t pictures = 0;
    for (std::size_t at = photo.find("{\"picture\":"); at != std::string::npos;
         at = photo.find("{\"picture\":", at + 1), ++pictures) {
        const std::size_t dial = photo.rfind("\"dial\":\"", at);
        const std::vector<double> f = numbers_after(photo, "f", at);
        if (photo.compare(dial + 8, 4, "dots") != 0) {
            EXPECT_NEAR(f.back(), own_f(at), 1e-4) << photo.substr(at, 300);
        }
        EXPECT_GT(f.back(), 0.5) << "a disc is found: " << photo.substr(at, 300);
        // Three greys are three, into however many more classes they are cut; in two the faint disc is gone.
        if (photo.compare(dial + 8, 4, "grey") == 0) {
            EXPECT_EQ(std::vector<double>(f.begin() + 1, f.end()), std::vector<double>(6, f.back())) << photo.substr(at, 300);
            EXPECT_GT(f.front(), f.back()) << photo.substr(at, 300);
        }
        // The faint strokes come last, and find nothing.
        if (photo.compare(dial + 8, 4, "stro") == 0) {
            EXPECT_GT(*std::max_element(f.begin(), f.end()), f.back()) << photo.substr(at, 300);
        }
    }
    EXPECT_EQ(pictures, 9u) << "three dials of three pictures";
    EXPECT_FALSE(tests::first_fit(photo, "\"dial\":\"grey levels\".*\"needed_median\":2,").empty()) << photo;
    EXPECT_TRUE(fs::exists(folder / "n-levels.svg") && fs::exists(folder / "n-dpi.svg") && fs::exists(folder / "n-strokes.svg"));
    // A recipe that prints a picture has no strokes.
    EXPECT_TRUE(holds(ending.out.substr(photo.size()),
                      R"("dial":"strokes","values":[1.0000,2.0000,5.0000,10.0000,20.0000,50.0000,100.0000,"all"],"scored":0)"))
        << ending.out;
}

TEST_F(EvaluateNeeded, TheStudyIsTheSameOnAnyNumberOfThreads) {
    const Words words{"-q", "--json", "--study", "needed"};
    Words one = words, four = words;
    one.insert(one.end(), {"--jobs", "1"});
    four.insert(four.end(), {"--jobs", "4"});
    const std::string alone = evaluate(one).out;
    EXPECT_TRUE(holds(alone, "\"recipe\":\"auto\",\"chosen\":\"")) << alone;
    EXPECT_EQ(alone, evaluate(four).out);
    const Ending text = evaluate({"-q", "--study", "needed", "-m", "embosser"});
    EXPECT_TRUE(holds(text.out, "30: ")) << text.out;
    EXPECT_FALSE(holds(text.out, "45: ")) << "an embosser shows no more: " << text.out;
}

}  // namespace
}  // namespace tactics::needed_test
