// `tactics emboss` and `tactics devices`: the real program, files and a queue that is a script.
#include <sys/stat.h>

#include "tests/cli/converting.h"

namespace tactics {
namespace {

using namespace tests;

class Emboss : public Convert {
protected:
    Ending emboss(Words words) {
        words.insert(words.begin(), "emboss");
        return run_tactics(folder, words);
    }
};

TEST_F(Emboss, SendsFilesInTheirOrderAsOneJob) {
    write_bytes(folder / "a.brf", "ABC\r\n\f");
    write_bytes(folder / "b.brf", "DEF\r\n\f");
    const Ending ending = emboss({"a.brf", "b.brf", "a.brf", "--to", "all.prn", "--embosser", "generic"});
    EXPECT_EQ(ending.code, 0);
    EXPECT_EQ(ending.err, "all.prn: 18 bytes written\n");
    EXPECT_EQ(bytes_of(folder / "all.prn"), "ABC\r\n\fDEF\r\n\fABC\r\n\f");
    EXPECT_EQ(emboss({"a.brf", "--to", "one.prn", "-q"}).err, "");
    EXPECT_EQ(emboss({"a.brf", "--to", "one.prn", "--json"}).out, "{\"to\":\"one.prn\",\"ending\":\"done\",\"accepted\":6,\"bytes\":6}\n");
}

TEST_F(Emboss, GoesOnAtAPageWithWhatSetsTheMachineUp) {
    ASSERT_EQ(convert({"disc.tif", "-q", "-o", "braillo:disc.prn", "--label", "50%,50%=a long word for the key to hold and more", "--title", "A disc"}).code, 0);
    const std::string disc = bytes_of(folder / "disc.prn");
    const std::string set_up = disc.substr(0, disc.find("R0") + 2);
    write_bytes(folder / "more.prn", disc + "SECOND\r\n\fTHIRD\r\n\f");
    const Ending told = emboss({"more.prn", "--to", "out.prn", "-e", "braillo", "--from-page", "3"});
    EXPECT_EQ(told.code, 0) << told.err;
    const std::string sent = bytes_of(folder / "out.prn");
    EXPECT_TRUE(sent.starts_with(set_up)) << sent;
    EXPECT_TRUE(sent.ends_with("THIRD\r\n\f"));
    EXPECT_LT(sent.size(), disc.size());
    // The last set-up counts, wherever it stands.
    ASSERT_EQ(convert({"disc.tif", "-q", "-o", "index-v4:fine.prn", "--set", "index-v4.pitch=1.6"}).code, 0);
    ASSERT_EQ(emboss({"a.brf", "fine.prn", "a.brf", "--to", "out.prn", "-e", "index-v4", "--from-page", "3"}).code, 2);
    write_bytes(folder / "a.brf", "ABC\r\n\f");
    ASSERT_EQ(emboss({"a.brf", "fine.prn", "a.brf", "--to", "out.prn", "-e", "index-v4", "--from-page", "3"}).code, 0);
    EXPECT_TRUE(holds(bytes_of(folder / "out.prn"), "GD2;")) << bytes_of(folder / "out.prn");
    EXPECT_TRUE(bytes_of(folder / "out.prn").ends_with("ABC\r\n\f"));
    ASSERT_EQ(emboss({"a.brf", "fine.prn", "--to", "out.prn", "-e", "index-v4", "--from-page", "2"}).code, 0);
    EXPECT_EQ(bytes_of(folder / "out.prn"), bytes_of(folder / "fine.prn"));
    EXPECT_EQ(emboss({"more.prn", "--to", "out.prn", "-e", "braillo", "--from-page", "9"}).code, 1);
    EXPECT_EQ(emboss({"more.prn", "--to", "out.prn", "--from-page", "2"}).code, 1);
}

TEST_F(Emboss, PrintsByAQueue) {
    write_bytes(folder / "lp", "#!/bin/sh\necho \"$@\" > words\ncat > job\n");
    chmod((folder / "lp").c_str(), 0755);
    write_bytes(folder / "a.brf", "ABC\r\n\f");
    const std::string program = TACTICS_PROGRAM;
    const Ending ending = run_tool(folder, {"sh", "-c", "PATH=.:$PATH exec \"$0\" emboss a.brf --to queue:Everest", program});
    EXPECT_EQ(ending.code, 0) << ending.err;
    EXPECT_EQ(bytes_of(folder / "job"), "ABC\r\n\f");
    EXPECT_EQ(bytes_of(folder / "words"), "-d Everest -t tactics -o raw\n");
    // A picture for the driver of a ViewPlus goes through it.
    ASSERT_EQ(convert({"disc.tif", "-q", "-o", "viewplus:disc.png"}).code, 0);
    const Ending picture = run_tool(folder, {"sh", "-c", "PATH=.:$PATH exec \"$0\" emboss disc.png --to queue:Tiger -e viewplus", program});
    EXPECT_EQ(picture.code, 0) << picture.err;
    EXPECT_EQ(bytes_of(folder / "words"), "-d Tiger -t tactics -o ppi=20\n");
    EXPECT_EQ(bytes_of(folder / "job"), bytes_of(folder / "disc.png"));
    EXPECT_EQ(emboss({"disc.png", "--to", "out.prn"}).code, 1);
    EXPECT_EQ(emboss({"disc.png", "--to", "tcp:127.0.0.1:9", "-e", "viewplus"}).code, 1);
    write_bytes(folder / "lp", "#!/bin/sh\nexit 1\n");
    const Ending refused = run_tool(folder, {"sh", "-c", "PATH=.:$PATH exec \"$0\" emboss a.brf --to queue:Everest", program});
    EXPECT_EQ(refused.code, 2);
    EXPECT_TRUE(holds(refused.err, "queue:Everest: lp did not take the job")) << refused.err;
}

TEST_F(Emboss, RefusesWhatNoEmbosserTakes) {
    EXPECT_EQ(emboss({}).code, 1);
    EXPECT_TRUE(holds(emboss({"disc.tif"}).err, "say where to: queue:NAME"));
    const Ending picture = emboss({"disc.tif", "--to", "out.prn"});
    EXPECT_EQ(picture.code, 1);
    EXPECT_TRUE(holds(picture.err, "disc.tif: is a picture, which no embosser takes as it is; first tactics convert disc.tif -o index-v4:page.prn")) << picture.err;
    EXPECT_EQ(emboss({"missing.prn", "--to", "out.prn"}).code, 2);
    write_bytes(folder / "a.brf", "ABC\r\n\f");
    const Ending missing = emboss({"a.brf", "--to", "/dev/usb/lp77"});
    EXPECT_EQ(missing.code, 2);
    EXPECT_TRUE(holds(missing.err, "/dev/usb/lp77: there is no such device")) << missing.err;
    EXPECT_EQ(emboss({"a.brf", "--to", "out.prn", "-e", "indx-v4"}).code, 1);
    EXPECT_EQ(names(), "a.brf disc.tif");
}

TEST_F(Emboss, DevicesAreListedWithoutAny) {
    const Ending ending = run_tactics(folder, {"devices", "--json"});
    EXPECT_EQ(ending.code, 0);
    EXPECT_EQ(run_tactics(folder, {"devices", "now"}).code, 1);
}

}  // namespace
}  // namespace tactics
