// SPDX-License-Identifier: Apache-2.0
// `tactics emboss` and `tactics devices`: the real program, files and a queue that is a script.
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/stat.h>

#include "tests/cli/converting.h"

namespace tactics::emboss_test {
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
    EXPECT_EQ(emboss({"a.brf", "--to", "one.prn", "--json"}).out,
              "{\"schema\":1,\"to\":\"one.prn\",\"ending\":\"done\",\"accepted\":6,\"bytes\":6}\n");
}

TEST_F(Emboss, GoesOnAtAPageWithWhatSetsTheMachineUp) {
    ASSERT_EQ(convert({"disc.tif", "-q", "-o", "braillo:disc.prn", "--label", "50%,50%=a long word for the key to hold and more",
                       "--title", "A disc"})
                  .code,
              0);
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
    ASSERT_EQ(emboss({"text.prn", "fine.prn", "text.prn", "--to", "out.prn", "-e", "index-v4", "--from-page", "3"}).code, 2);
    write_bytes(folder / "text.prn", "ABC\r\n\f");
    ASSERT_EQ(emboss({"text.prn", "fine.prn", "text.prn", "--to", "out.prn", "-e", "index-v4", "--from-page", "3"}).code, 0);
    EXPECT_TRUE(holds(bytes_of(folder / "out.prn"), "GD2,")) << bytes_of(folder / "out.prn");
    EXPECT_TRUE(bytes_of(folder / "out.prn").ends_with("ABC\r\n\f"));
    // Text that the machine is to set has a set-up of its own, and what ends its job does not begin the next.
    write_bytes(folder / "a.brf", "ABC\r\n\f");
    ASSERT_EQ(emboss({"a.brf", "fine.prn", "a.brf", "--to", "out.prn", "-e", "index-v4", "--from-page", "2"}).code, 0);
    EXPECT_TRUE(bytes_of(folder / "out.prn").starts_with(bytes_of(folder / "fine.prn")));
    EXPECT_TRUE(bytes_of(folder / "out.prn").ends_with("CH33,LP29,LS50,BT0;ABC\f\x1a")) << bytes_of(folder / "out.prn");
    EXPECT_EQ(emboss({"more.prn", "--to", "out.prn", "-e", "braillo", "--from-page", "9"}).code, 1);
    EXPECT_EQ(emboss({"more.prn", "--to", "out.prn", "--from-page", "2"}).code, 1);
}

// The next file that is opened takes the number of a stream that is closed: that is the machine, and it is told how far the job
// is. It reads slowly, so that there is something to tell.
TEST_F(Emboss, WordsForAClosedStreamDoNotReachTheMachine) {
    std::string story, sent;
    for (int page = 0; page < 3000; ++page) story += "PAGE\r\nOF A BOOK\r\n\f", sent += "PAGE\r\nOF A BOOK\f";
    write_bytes(folder / "book.brf", story);
    const int machine = posix_openpt(O_RDWR | O_NOCTTY);
    ASSERT_TRUE(grantpt(machine) == 0 && unlockpt(machine) == 0);
    const Folder streams;
    const pid_t id = start(folder,
                           {"sh", "-c", "exec \"$0\" emboss book.brf --to \"$1\" -e index-v4 2>&-", TACTICS_PROGRAM,
                            std::string(ptsname(machine)) + "@115200,none"},
                           streams.path(), "");
    std::string got;
    char block[200];
    for (pollfd ready{machine, POLLIN, 0}; poll(&ready, 1, 5'000) > 0; usleep(6'000)) {
        const ssize_t count = read(machine, block, sizeof block);
        if (count <= 0) break;  // all that had it open are gone
        got.append(block, static_cast<std::size_t>(count));
    }
    EXPECT_EQ(end_of(id, streams.path()).code, 0);
    close(machine);
    EXPECT_TRUE(holds(got, sent));
    EXPECT_FALSE(holds(got, "of 3000"));
}

// A machine that reads slowly: the page that was begun comes out whole, what ends a job is sent, and nothing else.
TEST_F(Emboss, CancelledBehindAPageEndsTheJob) {
    std::string story;
    for (int page = 0; page < 3000; ++page) story += "PAGE\r\nOF A BOOK\r\n\f";
    write_bytes(folder / "book.brf", story);
    const int machine = posix_openpt(O_RDWR | O_NOCTTY);
    ASSERT_EQ(grantpt(machine), 0);
    ASSERT_EQ(unlockpt(machine), 0);
    const Folder streams;
    const pid_t id = start(
        folder, {TACTICS_PROGRAM, "emboss", "book.brf", "--to", std::string(ptsname(machine)) + "@115200,none", "-e", "index-v4"},
        streams.path(), "");
    std::string got;
    char block[256];
    // The line is full until it is read from.
    for (pollfd ready{machine, POLLIN, 0}; poll(&ready, 1, 10'000) <= 0;) ASSERT_TRUE(false) << "nothing came";
    kill(id, SIGINT);
    for (pollfd ready{machine, POLLIN, 0}; poll(&ready, 1, 2'000) > 0;) {
        const ssize_t count = read(machine, block, sizeof block);
        if (count <= 0) break;
        got.append(block, static_cast<std::size_t>(count));
    }
    const Ending ending = end_of(id, streams.path());
    close(machine);
    EXPECT_EQ(ending.code, 7) << ending.err;
    EXPECT_LT(got.size(), story.size() / 2);
    EXPECT_TRUE(got.ends_with("OF A BOOK\f\x1a")) << got.substr(got.size() - std::min<std::size_t>(60, got.size()));
    EXPECT_TRUE(holds(ending.err, "go on with --from-page ")) << ending.err;
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
    const Ending picture =
        run_tool(folder, {"sh", "-c", "PATH=.:$PATH exec \"$0\" emboss disc.png --to queue:Tiger -e viewplus", program});
    EXPECT_EQ(picture.code, 0) << picture.err;
    EXPECT_EQ(bytes_of(folder / "words"), "-d Tiger -t tactics -o ppi=20\n");
    EXPECT_EQ(bytes_of(folder / "job"), bytes_of(folder / "disc.png"));
    EXPECT_EQ(emboss({"disc.png", "--to", "out.prn"}).code, 1);
    EXPECT_EQ(emboss({"disc.png", "--to", "tcp:127.0.0.1:9", "-e", "viewplus"}).code, 1);
    write_bytes(folder / "lp", "#!/bin/sh\necho 'lp: The printer or class does not exist.' >&2\nexit 1\n");
    const Ending refused = run_tool(folder, {"sh", "-c", "PATH=.:$PATH exec \"$0\" emboss a.brf --to queue:Everest", program});
    EXPECT_EQ(refused.code, 2);
    EXPECT_TRUE(holds(refused.err, "queue:Everest: lp did not take the job: lp: The printer or class does not exist.; look at"))
        << refused.err;
}

TEST_F(Emboss, RefusesWhatNoEmbosserTakes) {
    EXPECT_EQ(emboss({}).code, 1);
    EXPECT_TRUE(holds(emboss({"disc.tif"}).err, "say where to: queue:NAME"));
    const Ending picture = emboss({"disc.tif", "--to", "out.prn"});
    EXPECT_EQ(picture.code, 1);
    EXPECT_TRUE(
        holds(picture.err,
              "disc.tif: is a picture, which no embosser takes as it is; first tactics convert disc.tif -o index-v4:page.prn"))
        << picture.err;
    EXPECT_EQ(emboss({"missing.prn", "--to", "out.prn"}).code, 2);
    write_bytes(folder / "a.brf", "ABC\r\n\f");
    const Ending missing = emboss({"a.brf", "--to", "/dev/usb/lp77"});
    EXPECT_EQ(missing.code, 2);
    EXPECT_TRUE(holds(missing.err, "/dev/usb/lp77: there is no such device")) << missing.err;
    EXPECT_EQ(emboss({"a.brf", "--to", "out.prn", "-e", "indx-v4"}).code, 1);
    EXPECT_EQ(names(), "a.brf disc.tif");
}

// Every machine's bytes go to it; sent to another that would not understand them, they are refused with their own machine's name.
TEST_F(Emboss, BytesForAnotherMachineAreRefused) {
    const std::vector<std::string> machines{"index-v3", "index-v4", "index-v4-floating", "enabling", "braillo",
                                            "cidat",    "nippon"};
    for (const std::string& machine : machines)
        ASSERT_EQ(convert({"disc.tif", "-q", "-o", machine + ":" + machine + ".prn"}).code, 0) << machine;
    std::size_t refused = 0;
    for (const std::string& from : machines)
        for (const std::string& to : machines) {
            const Ending end = emboss({from + ".prn", "--to", "./sent", "-q", "-e", to});
            if (from == to) {
                EXPECT_EQ(end.code, 0) << end.err;
            } else if (end.code != 0) {
                ++refused;
                EXPECT_TRUE(holds(end.err, from + ".prn: these bytes are for ") && holds(end.err, from)) << end.err;
            }
        }
    EXPECT_GT(refused, 20u);
    const Ending end = emboss({"enabling.prn", "--to", "./sent", "-e", "index-v4"});
    EXPECT_TRUE(holds(end.err, "index-v4 would not understand byte ") && holds(end.err, "add --embosser enabling")) << end.err;
    write_bytes(folder / "odd.prn", "\x1b?ABC\r\n\f");  // nobody's
    EXPECT_EQ(emboss({"odd.prn", "--to", "./sent", "-q", "-e", "index-v4"}).code, 0);
}

TEST_F(Emboss, WhatWouldDoNothingIsRefused) {
    write_bytes(folder / "a.brf", "ABC\r\n\f");
    write_bytes(folder / "t.bin", "ABC\r\n\f");
    const auto refused = [&](Words words, std::string_view told) {
        words.insert(words.end(), {"--to", "out.prn"});
        const Ending ending = emboss(words);
        EXPECT_EQ(ending.code, 1) << told;
        EXPECT_TRUE(holds(ending.err, told)) << ending.err;
        EXPECT_EQ(names(), "a.brf disc.tif t.bin");
    };
    refused({"a.brf", "--paper", "a3"},
            "--paper: no machine is named that it would be for, so this would do nothing; add --embosser NAME, or leave it out");
    refused({"a.brf", "--set", "index-v4.copies=2"}, "--set: no machine is named that it would be for, so this would do nothing");
    refused({"t.bin", "-e", "index-v4", "--paper", "a3"},
            "--paper: no file is text (.brf) that would be set on it, so this would do nothing; leave it out");
    EXPECT_EQ(emboss({"t.bin", "a.brf", "-e", "index-v4", "--paper", "a5", "--to", "out.prn"}).code, 0);
}

TEST_F(Emboss, DevicesAreListedWithoutAny) {
    const Ending ending = run_tactics(folder, {"devices", "--json"});
    EXPECT_EQ(ending.code, 0);
    EXPECT_EQ(run_tactics(folder, {"devices", "now"}).code, 1);
}

}  // namespace
}  // namespace tactics::emboss_test
