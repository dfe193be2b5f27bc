# SPDX-License-Identifier: Apache-2.0
# What a Debian package has besides (Debian Policy 12): for each component copyright and changelog, and man pages packed. Run by CPack
# on the files of each before it packs them.
set(packages "program=tactics;formats=tactics-formats;cups=tactics-cups;printer=tactics-printer-app;library=libtactics0;development=libtactics-dev")
foreach(pair IN LISTS packages)
  string(REPLACE "=" ";" pair "${pair}")
  list(GET pair 0 component)
  list(GET pair 1 package)
  set(root ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/${component}/usr)
  if(NOT EXISTS ${root})
    continue()
  endif()
  get_filename_component(top ${CPACK_RESOURCE_FILE_LICENSE} DIRECTORY)
  file(READ ${top}/filters/net/weights/bsds500.NOTICE notice)
  string(REGEX REPLACE "\n\n" "\n.\n" notice "${notice}")
  string(REGEX REPLACE "\n" "\n " notice "${notice}")
  file(WRITE ${root}/share/doc/${package}/copyright
"Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: TACTICS

Files: *
Copyright: 2026 the TACTICS authors
License: Apache-2.0
Comment: On the weights of the contour net, which package tactics has:
 ${notice}

License: Apache-2.0
 On Debian systems the text of the Apache License, version 2.0, is in
 /usr/share/common-licenses/Apache-2.0.
")
  # No date: the same bytes from the same tree.
  file(WRITE ${root}/share/doc/${package}/changelog.Debian
"tactics (${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) unstable; urgency=medium

  * What changed is in changelog.gz of package tactics.

 -- ${CPACK_PACKAGE_CONTACT}  Thu, 01 Jan 1970 00:00:00 +0000
")
  if(component STREQUAL "program")  # under the names that Debian has for them
    file(RENAME ${root}/share/doc/tactics/CHANGELOG.md ${root}/share/doc/tactics/changelog)
    file(REMOVE ${root}/share/doc/tactics/LICENSE)
  endif()
  file(GLOB pages ${root}/share/man/man1/*.1 ${root}/share/doc/tactics/changelog)
  execute_process(COMMAND gzip -9nf ${pages} ${root}/share/doc/${package}/changelog.Debian COMMAND_ERROR_IS_FATAL ANY)
endforeach()
