// SPDX-License-Identifier: Apache-2.0
// `tactics help mouse` against what the program does: who builds a mouse has nothing but this text.
#include <gtest/gtest.h>

#include <functional>
#include <initializer_list>
#include <sstream>

#include "cli/help/describe.h"
#include "tactics/error.h"
#include "tactics/haptics/simulated/lever_file.h"
#include "tactics/transport/hid_displays.h"
#include "tactics/units.h"
#include "tests/cli/tool.h"
#include "tests/haptics/firmware.h"
#include "tests/patterns.h"

namespace tactics::mouse_topic_test {
namespace {

using namespace tests;

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

// The lines that stand indented behind the one that begins so.
std::vector<std::string> part(const std::string& begin) {
    std::vector<std::string> found;
    bool inside = false;
    for (const std::string& line : lines_of(describe_topic("mouse"))) {
        if (inside && !line.starts_with("  ")) break;
        if (inside) found.push_back(line.substr(2));
        if (line.starts_with(begin)) inside = true;
    }
    EXPECT_FALSE(found.empty()) << begin;
    return found;
}

struct Told {
    std::size_t first = 0, last = 0;
    std::string what;
};

// Each byte of a report once, in their order.
std::vector<Told> layout(const std::string& begin) {
    std::vector<Told> all;
    std::size_t next = 0;
    for (const std::string& line : part(begin)) {
        const tests::Fit found = tests::whole_fit(line, "bytes? ([0-9]+)(?: to ([0-9]+))?: (.+)");
        if (found.empty()) {
            ADD_FAILURE() << line;
            continue;
        }
        Told told{std::stoul(found[1]), 0, found[3]};
        told.last = !found[2].empty() ? std::stoul(found[2]) : told.first;
        EXPECT_EQ(told.first, next) << line;
        EXPECT_LE(told.first, told.last) << line;
        next = told.last + 1;
        all.push_back(told);
    }
    EXPECT_EQ(next, 64u);
    return all;
}

// One field is set as far as it goes: all bytes that this changes stand in one line, and no others, with that word in it.
void expect_field(const std::vector<Told>& told, const ReportBytes& bytes, const ReportBytes& empty, const std::string& word) {
    std::vector<std::size_t> changed;
    for (std::size_t i = 0; i < 62; ++i)
        if (bytes[i] != empty[i]) changed.push_back(i);
    ASSERT_FALSE(changed.empty()) << word;
    for (const Told& one : told) {
        if (one.first > changed[0] || one.last < changed[0]) continue;
        EXPECT_EQ(one.first, changed[0]) << word;
        EXPECT_EQ(one.last, changed.back()) << word;
        EXPECT_EQ(changed.size(), one.last - one.first + 1) << word;
        EXPECT_TRUE(holds(one.what, word)) << one.what;
        if (word.starts_with("bit ")) {
            EXPECT_EQ(bytes[changed[0]], 1u << (word[4] - '0')) << word;
        }
    }
}

// What no field sets is as the line says: the two letters at the front, the version, and nothing.
void expect_rest(const std::vector<Told>& told, const ReportBytes& full, const std::string& kind) {
    ASSERT_GE(told.size(), 4u);
    EXPECT_EQ(told[0].what, kind);
    EXPECT_TRUE(told[1].what.starts_with("1,"));
    EXPECT_EQ(full[0], std::stoul(kind, nullptr, 16));
    EXPECT_EQ(full[1], 1);
    const Told &zero = told[told.size() - 2], &sum = told.back();
    EXPECT_EQ(zero.what, "0");
    for (std::size_t i = zero.first; i <= zero.last; ++i) EXPECT_EQ(full[i], 0) << i;
    EXPECT_EQ(sum.first, 62u);
    EXPECT_TRUE(sum.what.starts_with("CRC-16 of bytes 0 to 61"));
}

TEST(MouseTopic, HasEveryByteOfTheReportToTheComputer) {
    const auto told = layout("Report to the computer");
    MouseReport full;
    const auto expect = [&](const std::string& word, const std::function<void(MouseReport&)>& set) {
        MouseReport one;
        set(one);
        set(full);
        expect_field(told, bytes_of(one), bytes_of(MouseReport{}), word);
    };
    expect("bit 0 stop key", [](MouseReport& report) { report.stop_key = true; });
    expect("bit 1 motor on", [](MouseReport& report) { report.motor_on = true; });
    expect("bit 2 fault", [](MouseReport& report) { report.fault = true; });
    expect("number", [](MouseReport& report) { report.number = 0xFF; });
    expect("clock", [](MouseReport& report) { report.microseconds = 0xFFFFFFFF; });
    expect("encoder", [](MouseReport& report) { report.encoder = -1; });
    expect("first optical sensor, x", [](MouseReport& report) { report.first_x = -1; });
    expect("first optical sensor, y", [](MouseReport& report) { report.first_y = -1; });
    expect("second optical sensor, x", [](MouseReport& report) { report.second_x = -1; });
    expect("second optical sensor, y", [](MouseReport& report) { report.second_y = -1; });
    expect_rest(told, bytes_of(full), "54h");
}

TEST(MouseTopic, HasEveryByteOfTheReportFromTheComputer) {
    const auto told = layout("Report from the computer");
    ForceReport full;
    const auto expect = [&](const std::string& word, const std::function<void(ForceReport&)>& set) {
        ForceReport one;
        set(one);
        set(full);
        expect_field(told, bytes_of(one), bytes_of(ForceReport{}), word);
    };
    expect("bit 0 motor on", [](ForceReport& report) { report.motor_on = true; });
    expect("number", [](ForceReport& report) { report.number = 0xFF; });
    expect("force, mN", [](ForceReport& report) { report.force = -0.001; });
    expect("how long it holds, ms", [](ForceReport& report) { report.hold_ms = 0xFFFF; });
    expect_rest(told, bytes_of(full), "46h");
}

// A firmware that shares no code with the program obeys the example.
TEST(MouseTopic, ItsExampleAndItsSumAreThoseOfAMouse) {
    std::vector<unsigned char> bytes;
    for (const std::string& line : part("For example a force of 1.5 N for 3 ms")) {
        const tests::Fit range = tests::whole_fit(line, "bytes ([0-9]+) to ([0-9]+): (.*)");
        ASSERT_FALSE(range.empty()) << line;
        std::istringstream all(range[3]);
        all >> std::hex;
        unsigned byte = 0;
        while (all >> byte) bytes.push_back(static_cast<unsigned char>(byte));
        bytes.resize(std::stoul(range[2]) + 1);
    }
    const auto word = force_word(bytes);
    ASSERT_TRUE(word);
    EXPECT_TRUE(word->motor_on);
    EXPECT_EQ(word->force, 1.5);
    EXPECT_EQ(word->hold, 3);
    const std::string text = "123456789", topic = describe_topic("mouse");
    char sum[8];
    std::snprintf(sum, sizeof sum, "%04Xh", sum_of({reinterpret_cast<const unsigned char*>(text.data()), text.size()}));
    EXPECT_TRUE(holds(topic, "123456789 gives " + std::string(sum))) << sum;
    EXPECT_TRUE(holds(topic, "of which tactics play gives 3 ms."));
}

TEST(MouseTopic, HasTheReportDescriptor) {
    std::vector<unsigned> bytes;
    for (const std::string& line : part("The report descriptor, 27 bytes")) {
        EXPECT_FALSE(holds(line, "another item")) << line;
        std::istringstream all(line.substr(0, line.find(':')));
        all >> std::hex;
        unsigned byte = 0;
        while (all >> byte) bytes.push_back(byte);
    }
    EXPECT_EQ(bytes, std::vector<unsigned>(kMouseDescriptor.begin(), kMouseDescriptor.end()));
}

TEST(MouseTopic, HasTheRuleThatTheProgramTellsTo) {
    std::string rule;
    const auto lines = part("/etc/udev/rules.d/70-tactics-mouse.rules");
    for (std::string line : lines) {
        line.erase(0, line.find_first_not_of(' '));  // as udev does
        rule += line.substr(0, line.find('\\'));
    }
    EXPECT_EQ(rule, "KERNEL==\"hidraw*\", ATTRS{idVendor}==\"1209\", ATTRS{idProduct}==\"0005\", TAG+=\"uaccess\"");
    const Folder folder;
    const auto device = folder / "sys/class/hidraw/hidraw0/device";
    std::filesystem::create_directories(device);
    write_bytes(device / "uevent", "HID_ID=0003:00001209:00000005\n");
    const std::string told = how_to_be_permitted("/dev/hidraw0", folder.path().string()).english();
    EXPECT_TRUE(holds(told, "/etc/udev/rules.d/70-tactics-mouse.rules: " + rule)) << told;
    EXPECT_TRUE(holds(told, part("Until it is unplugged").at(0))) << told;
}

// Its lines are a file that can be given; what is in it is what there is if nothing is named, and the ranges are those that are
// kept.
TEST(MouseTopic, TellsTheFileForLever) {
    const auto lines = part("All others with their defaults");
    std::string file;
    for (const std::string& line : lines) file += line + "\n";
    EXPECT_EQ(read_mouse(file, "help"), MouseSettings{});
    const auto message = [](const std::string& text) -> std::string {
        try {
            read_mouse(text, "help");
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    };
    for (const std::string& line : lines) {
        const tests::Fit found =
            tests::whole_fit(line, "([a-z.-]+) = [-0-9.]+ ([^ ].*?)  # ([-0-9.]+) to ([-0-9.]+) ([^;]+); .+");
        ASSERT_FALSE(found.empty()) << line;
        EXPECT_EQ(found[2], found[5]) << line;
        const double least = parse_number(found[3]).value_or(-9e9), most = parse_number(found[4]).value_or(-9e9);
        const auto given = [&](double value) { return message(found[1] + " = " + to_text(value) + " " + found[2]); };
        for (const double value : {least, most}) EXPECT_FALSE(holds(given(value), "out of range")) << line;
        for (const double value : {least - 0.001, most + 0.001}) EXPECT_TRUE(holds(given(value), "out of range")) << line;
    }
    EXPECT_EQ(part("first:"), (std::vector<std::string>{"lever = light or heavy", "finger = soft, nominal or stiff"}));
    for (const char* one : {"lever = light", "lever = heavy", "finger = soft", "finger = nominal", "finger = stiff"})
        EXPECT_EQ(message(one), "");
    EXPECT_EQ(kLevers.size() + kFingers.size(), 5u);
}

TEST(MouseTopic, IsPlainTextInShortLines) {
    const std::string text = describe_topic("mouse");
    for (const std::string& line : lines_of(text)) {
        EXPECT_LE(line.size(), 80u) << line;
        EXPECT_FALSE(line.ends_with(" ")) << line;
        for (const char c : line) EXPECT_TRUE(c >= ' ' && c <= '~') << line;
    }
    const Folder folder;
    EXPECT_EQ(run_tactics(folder, {"help", "mouse"}).out, text);
    EXPECT_TRUE(holds(run_tactics(folder, {"help", "play"}).out, "tactics help mouse"));
    EXPECT_TRUE(holds(run_tactics(folder, {"completion", "bash"}).out, " mouse"));
    if (!has_tool("groff")) GTEST_SKIP() << "groff is missing";
    const std::string manual =
        run_tool(folder, {"groff", "-man", "-Tascii", "-P-cbou", "-rLL=100n"}, run_tactics(folder, {"help", "--man"}).out).out;
    // Behind the first line, its heading.
    for (const std::string& line : lines_of(text.substr(text.find('\n') + 1))) EXPECT_TRUE(holds(manual, line)) << line;
}

}  // namespace
}  // namespace tactics::mouse_topic_test
