# SPDX-License-Identifier: Apache-2.0
# `cpack -G DEB` in the build folder: a Debian package for each component. What they need of libraries is found by dpkg-shlibdeps
# (dpkg-dev). The readers of rare formats are a package of their own, as OpenImageIO brings 180 others.
set(CPACK_PACKAGE_NAME tactics)
# Who answers for the packages, as Debian's tools have it: DEBFULLNAME and DEBEMAIL when it is configured.
set(CPACK_PACKAGE_CONTACT "The TACTICS maintainers <maintainers@localhost>")
if(DEFINED ENV{DEBEMAIL})
  set(CPACK_PACKAGE_CONTACT "$ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>")
endif()
set(CPACK_RESOURCE_FILE_LICENSE ${CMAKE_SOURCE_DIR}/LICENSE)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL program formats cups library development)
if(PAPPL_FOUND)
  list(APPEND CPACK_COMPONENTS_ALL printer)
endif()
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_SOURCE_DIR}/debian_files.cmake)

set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(same "(= ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})")
set(does "From photographs, diagrams, maps, tables and models TACTICS makes pages
that can be read by touch: for microcapsule paper, thermoform, braille
embossers and height maps.")

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME tactics)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION graphics)
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "tactile graphics from pictures\n${does}")
# Without them print, or that in common fonts, stays in the lines, and PDF and rare formats are refused with a word on what to install.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "tactics-formats ${same}, tesseract-ocr, tesseract-ocr-eng, poppler-utils, fonts-dejavu-extra, fonts-lmodern, fonts-liberation2, fonts-urw-base35")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS
  "tactics-cups, speech-dispatcher | espeak-ng, libspeechd2, libbrlapi0.8, libasound2, cups-client")

set(CPACK_DEBIAN_FORMATS_PACKAGE_NAME tactics-formats)
set(CPACK_DEBIAN_FORMATS_PACKAGE_SECTION graphics)
set(CPACK_COMPONENT_FORMATS_DESCRIPTION "tactile graphics from pictures: rare formats
Reads HEIC, AVIF, GIF, BMP, WebP and other pictures through OpenImageIO,
and models as OBJ, PLY, glTF and COLLADA through Assimp, in programs that
shut themselves in.")
set(CPACK_DEBIAN_FORMATS_PACKAGE_DEPENDS "tactics ${same}")

set(CPACK_DEBIAN_CUPS_PACKAGE_NAME tactics-cups)
set(CPACK_DEBIAN_CUPS_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_CUPS_PACKAGE_SHLIBDEPS OFF)
set(CPACK_COMPONENT_CUPS_DESCRIPTION "tactile graphics from pictures: printing to braille embossers
Makes every embosser that TACTICS knows a model of CUPS, so that any
program prints tactile graphics on it.")
set(CPACK_DEBIAN_CUPS_PACKAGE_DEPENDS "tactics ${same}, cups-daemon")
set(CPACK_DEBIAN_CUPS_PACKAGE_RECOMMENDS "cups")

# It is enabled by who wants it: systemctl enable --now tactics-printer-app.
set(CPACK_DEBIAN_PRINTER_PACKAGE_NAME tactics-printer-app)
set(CPACK_DEBIAN_PRINTER_PACKAGE_SECTION graphics)
set(CPACK_COMPONENT_PRINTER_DESCRIPTION "tactile graphics from pictures: embossers as IPP printers
Makes every embosser that TACTICS knows an IPP Everywhere printer, which
any system prints to without a driver.")
set(CPACK_DEBIAN_PRINTER_PACKAGE_DEPENDS "tactics ${same}")
set(CPACK_DEBIAN_PRINTER_PACKAGE_RECOMMENDS "avahi-daemon, poppler-utils")

# It starts programs that come with the program.
set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libtactics${PROJECT_VERSION_MAJOR})
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
set(CPACK_COMPONENT_LIBRARY_DESCRIPTION "tactile graphics from pictures: library for C\n${does}")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS "tactics ${same}")
# For who links to it: dpkg-shlibdeps reads the first; the second has ldconfig run once, behind all packages.
set(name libtactics${PROJECT_VERSION_MAJOR})
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/shlibs "libtactics ${PROJECT_VERSION_MAJOR} ${name} (>= ${PROJECT_VERSION})\n")
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/triggers "activate-noawait ldconfig\n")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_BINARY_DIR}/shlibs ${CMAKE_CURRENT_BINARY_DIR}/triggers)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libtactics-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS OFF)
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "tactile graphics from pictures: libraries for C and C++\n${does}
.
Headers, the library for C++, and what CMake and pkg-config find them by.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libtactics${PROJECT_VERSION_MAJOR} ${same}, libopencv-imgproc-dev, libfreetype-dev, libfontconfig-dev,
 liblouis-dev, libjpeg62-turbo-dev | libjpeg-dev, libpng-dev, libtiff-dev, zlib1g-dev, libexpat1-dev, libusb-1.0-0-dev, libhidapi-dev, libevdev-dev")
string(REGEX REPLACE "[\n ]+" " " CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "${CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS}")

include(CPack)
