// SPDX-License-Identifier: Apache-2.0
#include "tactics/transport/lesser_rights.h"

#include <grp.h>
#include <pwd.h>
#include <unistd.h>

#include "tactics/error.h"

namespace tactics {

void take_lesser_rights() {
    if (geteuid() != 0) return;
    const auto fail = [] {
        throw Error(Fault::failed, "",
                    phrase("this was started by root and cannot become the user lp or nobody; have CUPS run its filters as lp "
                           "(User in cups-files.conf)"));
    };
    const passwd* user = getpwnam("lp");
    if (user == nullptr) user = getpwnam("nobody");
    if (user == nullptr || user->pw_uid == 0 || user->pw_gid == 0) fail();
    const uid_t id = user->pw_uid;
    const gid_t group = user->pw_gid;
    // The user last: none of this may be done any more after it.
    if (setgroups(1, &group) != 0 || setresgid(group, group, group) != 0 || setresuid(id, id, id) != 0) fail();
    uid_t real = 0, effective = 0, saved = 0;
    gid_t real_group = 0, effective_group = 0, saved_group = 0;
    const bool told = getresuid(&real, &effective, &saved) == 0 && getresgid(&real_group, &effective_group, &saved_group) == 0;
    const bool become = real == id && effective == id && saved == id && real_group == group && effective_group == group &&
                        saved_group == group && getgroups(0, nullptr) == 1;
    if (!told || !become || setuid(0) == 0) fail();
}

}  // namespace tactics
