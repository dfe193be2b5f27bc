// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/voice/keyed_scene.h"

#include <gtest/gtest.h>

#include <cctype>
#include <memory>
#include <mutex>
#include <set>
#include <vector>

#include "tactics/haptics/voice/plot_words.h"

namespace tactics::keyed_scene_test {
namespace {

constexpr double kTick = 0.001, kResolution = 0.05;

// Keeps what it is told.
class Kept : public Voice {
public:
    explicit Kept(std::shared_ptr<std::vector<std::string>> said) : said_(std::move(said)) {}
    std::string_view name() const override { return "kept"; }
    bool takes_turns() const override { return true; }
    void say(const std::string& text) override { said_->push_back(text); }
    void stop() override {}

private:
    std::shared_ptr<std::vector<std::string>> said_;
};

class Nothing final : public Scene {
public:
    Felt feel(const Touch&, double) noexcept override { return {}; }
    void begin_again() noexcept override {}
};

Plot drive() {
    Plot plot;
    plot.x.name = "time (s)";
    plot.y.name = "speed (m/s)";
    plot.curves = {{"car", {{0, 10}, {2, 30}, {10, 0}}}, {"bus", {{0, 20}, {10, 20}}}};
    return plot;
}

class KeyedPlot : public testing::Test {
protected:
    explicit KeyedPlot(Plot plot = drive()) : plot_(std::move(plot)) {
        frame_.x = {0, 10, false, {}};
        frame_.y = {0, 40, false, {}};
        felt_ = felt_lines(plot_, frame_, kResolution);
        guidance_.emplace(nothing_, GuidedLines(plot_, frame_, felt_, kResolution), frame_, GuidanceSettings{});
        const PlotWords words(std::make_shared<Plot>(plot_), {{0, 10, 100}, {0, 40, 80}});
        speaking_.emplace(std::make_unique<Kept>(said_), [words](const Announcement& one) { return words.of(one).english(); });
        scene_.emplace(*guidance_, KeyedParts{&*speaking_, &typed_, nullptr, &track_}, frame_, felt_);
    }
    void press(unsigned key) {
        scene_->feel({finger_, {}, 0, 1u << (key - 1)}, kTick);
        scene_->feel({finger_, {}, 0, 1u << (key - 1)}, kTick);  // it is held down
        scene_->feel({finger_, {}}, kTick);
    }
    void type(PlotAction action) {
        typed_.press(static_cast<std::size_t>(&key_of(action) - plot_keys().data()));
        scene_->feel({finger_, {}}, kTick);
    }
    // What has been said so far, at the end of all.
    std::vector<std::string> said() {
        speaking_->finish();
        return *said_;
    }
    using Words = std::vector<std::string>;

    Plot plot_;
    PlotFrame frame_;
    FeltLines felt_;
    Nothing nothing_;
    std::optional<Guidance> guidance_;
    std::shared_ptr<std::vector<std::string>> said_ = std::make_shared<std::vector<std::string>>();
    std::optional<Speaking> speaking_;
    TypedKeys typed_;
    ToneTrack track_{10};
    std::optional<KeyedScene> scene_;
    Point3 finger_{50, 40, 0};
};

TEST(PlotKeys, EachIsNamedOnceAndDoesOneThing) {
    std::set<std::string_view> names;
    std::set<char> letters;
    std::set<PlotAction> actions;
    for (const PlotKey& key : plot_keys()) {
        EXPECT_TRUE(names.insert(key.name.text).second) << key.name.text;
        EXPECT_TRUE(actions.insert(key.action).second) << key.name.text;
        EXPECT_FALSE(key.what.empty());
        EXPECT_EQ(&key_of(key.action), &key);
        EXPECT_TRUE(key.letter == 0 || (std::islower(key.letter) != 0 && letters.insert(key.letter).second)) << key.name.text;
    }
    EXPECT_LE(kNumberedKeys, 8u);  // Touch::keys of the arms that have the most
    EXPECT_GE(plot_keys().size(), kNumberedKeys);
}

// With the two keys of every device: the second chooses any other action and the first carries it out, or releases the finger.
TEST(PlotKeys, TwoReachAll) {
    const std::set<PlotAction> chosen(chosen_actions().begin(), chosen_actions().end());
    EXPECT_EQ(chosen.size(), chosen_actions().size());
    for (const PlotKey& key : plot_keys().subspan(2))
        EXPECT_TRUE(chosen.contains(key.action) || key.action == PlotAction::let_go) << key.name.text;
    EXPECT_EQ(plot_keys()[0].action, PlotAction::chosen);
    EXPECT_EQ(plot_keys()[1].action, PlotAction::choose);
}

TEST_F(KeyedPlot, TheSecondKeyChoosesAndTheFirstDoesIt) {
    press(1);
    press(2);
    press(1);
    for (int i = 0; i < 6; ++i) press(2);
    press(1);
    EXPECT_EQ(said(), (Words{"time 5 s, speed 20 m/s", "nearest",
                             "nearest: point 2 of 3 of car, time 2 s, speed 30 m/s, 36 mm away above, to the left", "under",
                             "start", "follow", "extremum", "compare", "position", "time 5 s, speed 20 m/s"}));
}

TEST_F(KeyedPlot, WhileAFingerIsLedTheSecondKeyLetsItGo) {
    press(5);
    EXPECT_TRUE(guidance_->is_leading());
    press(2);
    EXPECT_FALSE(guidance_->is_leading());
    press(1);  // nothing else was chosen
    EXPECT_EQ(said(), (Words{"let go", "time 5 s, speed 20 m/s"}));
}

TEST_F(KeyedPlot, AKeyOfItsOwnAndALetterAreTheSame) {
    const PlotAction actions[] = {PlotAction::under,  PlotAction::nearest,  PlotAction::start,
                                  PlotAction::follow, PlotAction::extremum, PlotAction::compare};
    for (unsigned key = 3; key <= kNumberedKeys; ++key) {
        EXPECT_EQ(plot_keys()[key - 1].action, actions[key - 3]);
        guidance_->let_go();
        press(key);
        const bool leads = guidance_->is_leading();
        guidance_->let_go();
        type(actions[key - 3]);
        EXPECT_EQ(guidance_->is_leading(), leads);
        EXPECT_EQ(leads, key >= 5 && key != 7) << key;  // this curve has no turn
    }
    type(PlotAction::let_go);
    EXPECT_FALSE(guidance_->is_leading());
    const Words words = said();
    ASSERT_GE(words.size(), 4u);
    EXPECT_EQ(words[0], words[1]);
    EXPECT_EQ(words[2], words[3]);
    EXPECT_EQ(words.back(), "let go");
}

TEST_F(KeyedPlot, WhatIsTypedAtOnceIsDoneInItsOrder) {
    for (const std::size_t entry : {std::size_t{1}, std::size_t{1}, std::size_t{0}, std::size_t{2}}) typed_.press(entry);
    scene_->feel({finger_, {}}, kTick);
    EXPECT_EQ(said(), (Words{"nearest", "under", "curve bus", "curve bus"}));
    for (int i = 0; i < 40; ++i) typed_.press(9);
    int count = 0;
    for (std::uint64_t word = typed_.take(); word != 0; word >>= TypedKeys::kBits) ++count;
    EXPECT_EQ(count, 16);
    EXPECT_EQ(typed_.take(), 0u);
}

// A finger that gives way to what leads it.
TEST_F(KeyedPlot, TellsWhereItWasLedAndWhyNot) {
    const auto led = [&] {
        for (int i = 0; i < 20'000 && guidance_->is_leading(); ++i)
            finger_ = finger_ + 0.2 * scene_->feel({finger_, {}}, kTick).force;
        EXPECT_FALSE(guidance_->is_leading());
    };
    press(5);
    led();
    press(5);
    led();
    press(6);
    led();
    press(7);
    led();
    press(7);
    led();
    press(8);
    led();
    press(7);
    press(7);
    EXPECT_EQ(said(), (Words{"beginning of the curve bus, time 0 s, speed 20 m/s",
                             "beginning of the curve car, time 0 s, speed 10 m/s", "end of the curve car, time 10 s, speed 0 m/s",
                             "no further maximum or minimum this way; once more goes back",
                             "maximum of car, time 2 s, speed 30 m/s", "at time 2 s: car 30 m/s, bus 20 m/s, car 10 m/s higher",
                             "this curve has no maximum or minimum", "this curve has no maximum or minimum"}));
}

TEST_F(KeyedPlot, WithoutAVoiceItLeadsAllTheSame) {
    KeyedScene silent(*guidance_, {}, frame_, felt_);
    EXPECT_EQ(silent.feel({finger_, {}}, kTick).force, Point3{});
    silent.feel({finger_, {}, 0, ~0u}, kTick);
    EXPECT_TRUE(guidance_->is_leading());
    silent.feel({finger_, {}}, kTick);
    silent.feel({finger_, {}, 0, 2}, kTick);
    EXPECT_FALSE(guidance_->is_leading());
    EXPECT_TRUE(said().empty());
}

TEST_F(KeyedPlot, OnACurveItsHeightIsATone) {
    scene_->feel({{50, 41, -1}, {}}, 0.01);  // bus
    scene_->feel({{50, 60, 0}, {}}, 0.01);   // between the curves
    scene_->feel({{20, 20.5, 0}, {}}, 0.01);
    scene_->feel({{20, 20.5, 30}, {}}, 0.01);  // far above
    const auto& tones = track_.tones();
    ASSERT_EQ(tones.size(), 4u);
    EXPECT_TRUE(tones[0].sounds && tones[2].sounds);
    EXPECT_FALSE(tones[1].sounds || tones[3].sounds);
    EXPECT_NEAR(tones[0].value, 0.5, 1e-9);
    EXPECT_NEAR(tones[0].side, 0.5, 1e-9);
    EXPECT_EQ(tones[0].series, 1);
    EXPECT_NEAR(tones[2].value, 0.75, 0.01);
    EXPECT_NEAR(tones[2].side, 0.2, 0.01);
    EXPECT_EQ(tones[2].series, 0);
}

}  // namespace
}  // namespace tactics::keyed_scene_test
