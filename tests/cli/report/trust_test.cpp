// SPDX-License-Identifier: Apache-2.0
// A page that is not to be trusted, as the user meets it: said by convert, in its JSON, at the end of a batch and by check.
#include "tests/cli/converting.h"
#include "tests/filters/pictures.h"

namespace tactics::trust_test {
namespace {

using namespace tests;

constexpr char kWarning[] = "probably not fit to be handed out as it is: about ";

class TrustTold : public Convert {
protected:
    TrustTold() {
        const Image leaves = pictures::leaves();
        write_bytes(folder / "leaves.tif",
                    grey_picture(leaves.width, leaves.height, [&](int x, int y) { return leaves.row(y)[x]; }));
        write_bytes(folder / "round.tif",
                    grey_picture(480, 320, [](int x, int y) { return std::hypot(x - 200, y - 150) < 90 ? 60 : 190; }));
    }
};

TEST_F(TrustTold, OfWhatIsUnsureOnceForAllOutputsAndNotOfWhatIsClear) {
    const Ending busy = convert({"leaves.tif", "-r", "photo", "-o", "a.pdf", "-o", "a.svg", "-o", "a.brf"});
    EXPECT_EQ(busy.code, 0);
    const auto at = busy.err.find(std::string("leaves.tif: ") + kWarning);
    ASSERT_NE(at, std::string::npos) << busy.err;
    EXPECT_TRUE(holds(busy.err, "--subject 20%,30%-70%,90%") && holds(busy.err, "tactics describe")) << busy.err;
    EXPECT_EQ(busy.err.find(kWarning, at + 20), std::string::npos) << "said twice: " << busy.err;
    const Ending clear = convert({"round.tif", "-r", "photo", "-o", "a.pdf"});
    EXPECT_FALSE(holds(clear.err, kWarning)) << clear.err;
    EXPECT_EQ(convert({"leaves.tif", "-r", "photo", "-o", "a.pdf", "--quiet"}).err, "");
    EXPECT_TRUE(holds(convert({"leaves.tif", "-r", "photo", "--as-drawn", "-o", "a.pdf"}).err, kWarning));
}

TEST_F(TrustTold, IsSilentWhereAPersonChoseOrNothingIsKnown) {
    const Ending boxed = convert({"round.tif", "-r", "photo", "--subject", "15%,10%-70%,85%", "-o", "a.pdf", "--json"});
    EXPECT_FALSE(holds(boxed.out, "\"trust\"")) << boxed.out;
    EXPECT_FALSE(holds(convert({"leaves.tif", "-r", "photo", "--detail", "contours", "-o", "a.pdf"}).err, kWarning));
    EXPECT_FALSE(holds(convert({"leaves.tif", "-r", "photo", "--detail", "0.5", "-o", "a.pdf"}).err, kWarning));
    for (const char* recipe : {"portrait", "fast", "kmeans"})
        EXPECT_FALSE(holds(convert({"leaves.tif", "-r", recipe, "-o", "a.pdf", "--json"}).out, "\"trust\"")) << recipe;
}

TEST_F(TrustTold, ToScriptsInNumbersAndWords) {
    const std::string busy = convert({"leaves.tif", "-r", "photo", "-o", "a.pdf", "--json"}).out;
    EXPECT_TRUE(holds(busy, "\"trust\":{\"line\":0.") && holds(busy, std::string("\"doubt\":\"") + kWarning)) << busy;
    const std::string clear = convert({"round.tif", "-r", "photo", "-o", "a.pdf", "--json"}).out;
    EXPECT_TRUE(holds(clear, "\"trust\":{\"line\":0.") && !holds(clear, "\"doubt\"")) << clear;
}

TEST_F(TrustTold, AtTheEndOfABatchAndByCheck) {
    const Ending batch = convert({"round.tif", "leaves.tif", "-r", "photo", "-o", "out/"});
    EXPECT_EQ(batch.code, 0);
    EXPECT_TRUE(batch.err.ends_with("\n1 page needs a look before being handed out, as told above:\n  leaves.tif\n"))
        << batch.err;
    EXPECT_TRUE(holds(run_tactics(folder, {"check", "leaves.tif", "-r", "photo"}).out, kWarning));
    EXPECT_FALSE(holds(run_tactics(folder, {"check", "round.tif", "-r", "photo"}).out, kWarning));
}

}  // namespace
}  // namespace tactics::trust_test
