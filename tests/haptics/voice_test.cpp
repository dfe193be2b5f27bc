// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/voice/voice.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <regex>
#include <thread>

#include "tactics/error.h"
#include "tactics/transport/child.h"

namespace tactics::voice_test {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

std::string content_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

bool comes_true(const std::function<bool()>& what) {
    for (int i = 0; i < 1000; ++i) {
        if (what()) return true;
        std::this_thread::sleep_for(20ms);
    }
    return false;
}

// A variable of the environment for as long as this lives.
class Setting {
public:
    Setting(const char* name, const std::string& value) : name_(name) {
        const char* before = std::getenv(name);
        if (before != nullptr) before_ = before;
        was_ = before != nullptr;
        setenv(name, value.c_str(), 1);
    }
    ~Setting() { was_ ? setenv(name_, before_.c_str(), 1) : unsetenv(name_); }
    Setting(const Setting&) = delete;
    Setting& operator=(const Setting&) = delete;

private:
    const char* name_;
    std::string before_;
    bool was_ = false;
};

class VoiceTest : public testing::Test {
protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() / ("tactics-voice-" + std::to_string(getpid()));
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    // A folder with a program of that name in it that runs the shell's text, before all others.
    std::string path_with(const std::string& name, const std::string& shell) {
        const fs::path programs = folder_ / "programs";
        fs::create_directories(programs);
        std::ofstream(programs / name) << "#!/bin/sh\n" << shell;
        fs::permissions(programs / name, fs::perms::owner_all);
        const char* path = std::getenv("PATH");
        return programs.string() + ":" + (path == nullptr ? "/usr/bin:/bin" : path);
    }
    fs::path folder_;
};

// A text server on loopback.
class Server {
public:
    Server() : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
        sockaddr_in at{};
        at.sin_family = AF_INET;
        at.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        const int small = 4096;
        setsockopt(socket_, SOL_SOCKET, SO_RCVBUF, &small, sizeof small);
        EXPECT_EQ(bind(socket_, reinterpret_cast<sockaddr*>(&at), sizeof at), 0);
        EXPECT_EQ(listen(socket_, 1), 0);
        socklen_t size = sizeof at;
        getsockname(socket_, reinterpret_cast<sockaddr*>(&at), &size);
        port_ = ntohs(at.sin_port);
    }
    ~Server() {
        hang_up();
        close(socket_);
    }
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;

    std::string voice() const { return "tcp:127.0.0.1:" + std::to_string(port_); }
    // So many lines, or what came until nothing more does.
    std::string hear(int lines) {
        if (peer_ < 0) peer_ = accept(socket_, nullptr, nullptr);
        std::string heard;
        char bytes[4096];
        while (std::count(heard.begin(), heard.end(), '\n') < lines) {
            pollfd ready{peer_, POLLIN, 0};
            if (poll(&ready, 1, 20'000) <= 0) break;
            const ssize_t count = read(peer_, bytes, sizeof bytes);
            if (count <= 0) break;
            heard.append(bytes, static_cast<std::size_t>(count));
        }
        return heard;
    }
    void hang_up() {
        if (peer_ >= 0) close(peer_);
        peer_ = -1;
    }

private:
    int socket_, peer_ = -1, port_ = 0;
};

TEST_F(VoiceTest, WhatMeansNothingIsRefused) {
    for (const VoiceWish& wish :
         {VoiceWish{"sing"}, VoiceWish{"tcp"}, VoiceWish{"tcp:9"}, VoiceWish{"none:x"}, VoiceWish{"recording"}, VoiceWish{""},
          VoiceWish{"none", ""}, VoiceWish{"none", "-x"}, VoiceWish{"none", "en us"}, VoiceWish{"none", "en", 79},
          VoiceWish{"none", "en", 451}, VoiceWish{"recording:" + (folder_ / "missing" / "file").string()}})
        EXPECT_THROW(open_voice(wish), Error) << wish.kind << " " << wish.language << " " << wish.rate;
    EXPECT_EQ(open_voice({"none"}).voice->name(), "none");
}

TEST_F(VoiceTest, ARecordingHasALineForEachUtterance) {
    const fs::path file = folder_ / "said";
    const OpenedVoice opened = open_voice({"recording:" + file.string()});
    opened.voice->say("time 2.5 s");
    opened.voice->say("nothing");
    EXPECT_EQ(opened.note.english(), "");
    EXPECT_EQ(opened.voice->trouble().english(), "");
    EXPECT_TRUE(std::regex_match(content_of(file), std::regex("\\d+\\.\\d{3} time 2\\.5 s\n\\d+\\.\\d{3} nothing\n")))
        << content_of(file);
}

TEST_F(VoiceTest, ATextServerIsSentLines) {
    Server server;
    const OpenedVoice opened = open_voice({server.voice()});
    opened.voice->say("Größe 2.5 µm");
    opened.voice->say("nothing");
    EXPECT_EQ(server.hear(2), "Größe 2.5 µm\nnothing\n");
    server.hang_up();
    EXPECT_TRUE(comes_true([&] {
        opened.voice->say("again");
        return !opened.voice->trouble().empty();
    }));
}

// All that it takes in the end are whole lines; the system may find room for some of those behind.
TEST_F(VoiceTest, ATextServerThatStallsIsNotWaitedFor) {
    Server server;
    const OpenedVoice opened = open_voice({server.voice()});
    const std::string line(kMostSpoken, 'x');
    EXPECT_TRUE(comes_true([&] {
        for (int i = 0; i < 2000 && opened.voice->trouble().empty(); ++i) opened.voice->say(line);
        return !opened.voice->trouble().empty();
    }));
    for (int i = 0; i < 3; ++i) opened.voice->say("left out");
    std::thread reader([&] {
        const std::string heard = server.hear(1 << 30);
        for (std::size_t at = 0; at < heard.size();) {
            const std::size_t end = heard.find('\n', at);
            ASSERT_NE(end, std::string::npos);
            const std::string one = heard.substr(at, end - at);
            EXPECT_TRUE(one == line || one == "left out" || one == "last") << one.size();
            at = end + 1;
        }
        EXPECT_TRUE(heard.ends_with("\nlast\n"));
    });
    std::this_thread::sleep_for(200ms);
    opened.voice->say("last");
    const_cast<OpenedVoice&>(opened).voice.reset();
    reader.join();
}

TEST_F(VoiceTest, AbsentSpeechIsANote) {
    const Setting path("PATH", folder_.string());
    const Setting address("SPEECHD_ADDRESS", "inet_socket:127.0.0.1:1");
    for (const std::string kind : {"espeak-ng", "speechd", "tcp:127.0.0.1:1", "auto"}) {
        const OpenedVoice opened = open_voice({kind});
        EXPECT_EQ(opened.voice->name(), "none");
        EXPECT_FALSE(opened.note.empty()) << kind;
        EXPECT_EQ(opened.note.english().find("install ") != std::string::npos, !kind.starts_with("tcp")) << opened.note.english();
    }
}

TEST_F(VoiceTest, OneUtteranceEndsTheOther) {
    const Setting path(
        "PATH",
        path_with("espeak-ng", "[ \"$3\" = -q ] && exit 0\nread line\necho \"begin $* $line\" >>" + (folder_ / "log").string() +
                                   "\n[ \"$line\" = last ] || sleep 60\necho end >>" + (folder_ / "log").string() + "\n"));
    const OpenedVoice opened = open_voice({"espeak-ng", "de"});
    ASSERT_EQ(opened.voice->name(), "espeak-ng") << opened.note.english();
    const auto begun = [&](const std::string& text) {
        return comes_true([&] { return content_of(folder_ / "log").find(text) != std::string::npos; });
    };
    opened.voice->say("first");
    EXPECT_TRUE(begun("begin -v de first"));
    opened.voice->say("last");
    EXPECT_TRUE(begun("end"));
    EXPECT_EQ(content_of(folder_ / "log"), "begin -v de first\nbegin -v de last\nend\n");
    EXPECT_EQ(opened.voice->trouble().english(), "");
}

TEST_F(VoiceTest, ASynthesiserThatFailsIsTold) {
    const Setting path("PATH", path_with("espeak-ng", "[ \"$3\" = -q ] && exit 0\nexit 3\n"));
    const OpenedVoice opened = open_voice({"espeak-ng"});
    opened.voice->say("a");
    EXPECT_TRUE(comes_true([&] { return !opened.voice->trouble().empty(); }));
}

// The real program, which writes the sound into a file, as machines for tests have no loudspeaker.
TEST_F(VoiceTest, EspeakNgMakesASound) {
    const ChildAnswer there = run_child({"espeak-ng", "-q"}, "a\n", {.time = 20s});
    if (there.end == ChildAnswer::End::missing) GTEST_SKIP() << "espeak-ng is not installed";
    const fs::path sound = folder_ / "sound.wav";
    const char* before = std::getenv("PATH");
    const std::string real = std::string("PATH='") + (before == nullptr ? "/usr/bin:/bin" : before) + "' exec espeak-ng \"$@\"";
    const Setting path("PATH", path_with("espeak-ng", real + " -w " + sound.string() + "\n"));
    const OpenedVoice opened = open_voice({"espeak-ng", "en", 200});
    ASSERT_EQ(opened.voice->name(), "espeak-ng") << opened.note.english();
    fs::remove(sound);
    opened.voice->say("time 2.5 s, speed 12 m/s");
    // At 200 words a minute some two seconds of 22,050 Hz and 16 bits.
    EXPECT_TRUE(comes_true([&] { return fs::exists(sound) && fs::file_size(sound) > 60'000; }));
    EXPECT_EQ(opened.voice->trouble().english(), "");
    EXPECT_EQ(open_voice({"espeak-ng", "xx-nowhere"}).voice->name(), "none");
}

// The real server on a socket of its own, with a module of its own that runs a command for each utterance: here one that writes
// down what it was given. Its sound goes nowhere.
TEST_F(VoiceTest, SpeechDispatcherSpeaks) {
    const auto in = [&](const char* name) { return (folder_ / name).string(); };
    fs::create_directories(folder_ / "modules");
    std::ofstream(folder_ / "speechd.conf") << "AudioOutputMethod \"alsa\"\nAudioALSADevice \"null\"\nDefaultLanguage \"en\"\n"
                                               "DefaultModule plain\nAddModule \"plain\" \"sd_generic\" \"plain.conf\"\n";
    std::ofstream(folder_ / "modules" / "plain.conf")
        << "GenericExecuteSynth \"echo \\\"$DATA\\\" >> " << in("spoken")
        << "\"\nAddVoice \"en\" \"MALE1\" \"en\"\nGenericLanguage \"en\" \"en\" \"utf-8\"\n";
    ChildBeside server({"speech-dispatcher", "-s", "-c", "unix_socket", "-S", in("socket"), "-P", in("pid"), "-C",
                        folder_.string(), "-L", folder_.string(), "-t", "0"},
                       "");
    comes_true([&] { return !server.runs() || fs::exists(folder_ / "socket"); });
    if (!server.runs()) GTEST_SKIP() << "speech-dispatcher is not installed, or has no module sd_generic or no ALSA";
    const Setting address("SPEECHD_ADDRESS", "unix_socket:" + in("socket"));
    OpenedVoice opened = open_voice({"speechd", "en", 250});
    if (opened.voice->name() == "none") GTEST_SKIP() << opened.note.english();
    EXPECT_EQ(opened.voice->name(), "speechd");
    opened.voice->say("time 2.5 s, speed 12 m/s");
    EXPECT_TRUE(comes_true([&] { return content_of(folder_ / "spoken").find("speed 12 m/s") != std::string::npos; }))
        << content_of(folder_ / "spoken");
    opened.voice->stop();
    opened.voice->say("end of the curve");
    EXPECT_TRUE(comes_true([&] { return content_of(folder_ / "spoken").find("end of the curve") != std::string::npos; }));
    EXPECT_EQ(opened.voice->trouble().english(), "");
    server.end();
    opened.voice->say("nobody hears");
    opened.voice->say("nobody hears");
    EXPECT_NE(opened.voice->trouble(), "");
}

}  // namespace
}  // namespace tactics::voice_test
