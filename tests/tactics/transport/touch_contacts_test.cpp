// SPDX-License-Identifier: Apache-2.0
// Which contacts are on a touch device: the kernel's protocol B, as Documentation/input/multi-touch-protocol.rst has it.
#include "tactics/transport/touch_contacts.h"

#include <gtest/gtest.h>

#include <climits>

#include "tactics/transport/touch_device.h"
#include "tests/cli/tool.h"

namespace tactics::touch_contacts_test {
namespace {

TEST(TouchContacts, OfASlotOnlyWhatChangesIsTold) {
    TouchContacts contacts;
    EXPECT_TRUE(contacts.down().empty());
    contacts.tracking(45);
    contacts.x(10);
    contacts.y(20);
    contacts.slot(1);
    contacts.tracking(46);
    contacts.x(30);
    contacts.y(40);
    ASSERT_EQ(contacts.down().size(), 2u);
    contacts.slot(0);
    contacts.x(11);
    EXPECT_EQ(contacts.down()[0].x, 11);
    EXPECT_EQ(contacts.down()[0].y, 20);
    EXPECT_EQ(contacts.down()[1].x, 30);
    EXPECT_LT(contacts.down()[0].order, contacts.down()[1].order);
    contacts.tracking(-1);
    ASSERT_EQ(contacts.down().size(), 1u);
    EXPECT_EQ(contacts.down()[0].y, 40);
    // The next in the slot is at the place of the one before until something else is told.
    contacts.tracking(47);
    contacts.y(22);
    ASSERT_EQ(contacts.down().size(), 2u);
    EXPECT_EQ(contacts.down()[0].x, 11);
    EXPECT_EQ(contacts.down()[0].y, 22);
    EXPECT_GT(contacts.down()[0].order, contacts.down()[1].order);
}

TEST(TouchContacts, AnotherNumberIsAnotherContactAndTheSameIsNot) {
    TouchContacts contacts;
    contacts.tracking(65535);
    const auto first = contacts.down()[0].order;
    contacts.tracking(65535);
    EXPECT_EQ(contacts.down()[0].order, first);
    contacts.tracking(0);  // it runs over
    EXPECT_GT(contacts.down()[0].order, first);
}

TEST(TouchContacts, SlotsThatCannotBe) {
    TouchContacts contacts;
    for (const int slot : {-1, TouchContacts::kMost, INT_MAX, INT_MIN}) {
        contacts.slot(slot);
        contacts.tracking(1);
        contacts.x(1);
        contacts.y(1);
    }
    EXPECT_TRUE(contacts.down().empty());
    for (int slot = 0; slot < TouchContacts::kMost; ++slot) {
        contacts.slot(slot);
        contacts.tracking(slot);
    }
    EXPECT_EQ(contacts.down().size(), static_cast<std::size_t>(TouchContacts::kMost));
}

TEST(TouchPlaces, AreThoseThatAreTouchedWhereTheyShow) {
    const tests::Folder folder;
    const auto add = [&](const std::string& event, const std::string& name, const std::string& properties,
                         const std::string& axes) {
        const auto device = folder / ("sys/class/input/" + event + "/device");
        std::filesystem::create_directories(device / "capabilities");
        tests::write_bytes(device / "name", name + "\n");
        tests::write_bytes(device / "properties", properties + "\n");
        tests::write_bytes(device / "capabilities/abs", axes + "\n");
    };
    add("event0", "Keyboard", "0", "0");
    add("event1", "Touch pad", "5", "2e0800000000003");
    add("event12", "Infrared frame", "2", "260800000000003");
    add("mouse3", "Infrared frame", "2", "3");
    const auto places = touch_places(folder.path().string());
    ASSERT_EQ(places.size(), 1u);
    EXPECT_EQ(places[0].path, "/dev/input/event12");
    EXPECT_EQ(places[0].name, "Infrared frame");
}

}  // namespace
}  // namespace tactics::touch_contacts_test
