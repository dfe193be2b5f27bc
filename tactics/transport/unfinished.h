// SPDX-License-Identifier: Apache-2.0
// Names of unfinished files.
//
// .tactics-BOOT-PID-START-NUMBER: of the machine since it was switched on and the processes that see each other there, of the
// process, and of the moment in which that began, so that a name tells whether anybody still writes to it, although numbers of
// processes come again.
#pragma once

#include <string>

namespace tactics {

/// A name that will be used for a while, in the folder. Removes the file of that name unless told that it got its final name. The
/// first in a folder removes what processes have left there that are dead: of this machine at once; of others, or of before it
/// was switched on, when it is a day old. Thread-safe.
class UnfinishedName {
public:
    explicit UnfinishedName(const std::string& folder);
    ~UnfinishedName();
    UnfinishedName(const UnfinishedName&) = delete;
    UnfinishedName& operator=(const UnfinishedName&) = delete;
    const char* text() const { return name_.c_str(); }
    void exists(bool yes) { exists_ = yes; }

private:
    std::string name_;
    bool exists_ = false;
};

}  // namespace tactics
