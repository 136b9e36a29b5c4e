# Debian packages, by CPack (docs/packages.md). What the packages hold are install components; their
# scripts, changelog and copyright are in deploy/debian.

set(cd_debian "${CMAKE_SOURCE_DIR}/deploy/debian")

# Only the packages write into /etc, since `cmake --install` may have any prefix.
install(FILES deploy/systemd/cdmaster.toml deploy/systemd/cdworker.toml
    DESTINATION /etc/cdcluster COMPONENT programs EXCLUDE_FROM_ALL)

file(STRINGS "${cd_debian}/changelog" newest LIMIT_COUNT 1)
if(NOT newest MATCHES "^cdcluster \\(${PROJECT_VERSION}-([0-9]+)\\)")
    message(FATAL_ERROR "deploy/debian/changelog begins with another version than ${PROJECT_VERSION}-N: ${newest}")
endif()
set(CPACK_DEBIAN_PACKAGE_RELEASE "${CMAKE_MATCH_1}")
set(cd_deb_version "${PROJECT_VERSION}-${CMAKE_MATCH_1}")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${cd_debian}/changelog")
execute_process(COMMAND ${CD_GZIP} -9nc "${cd_debian}/changelog"
    OUTPUT_FILE "${CMAKE_BINARY_DIR}/changelog.Debian.gz" COMMAND_ERROR_IS_FATAL ANY)

# cd_package(NAME COMPONENT SECTION DESCRIPTION [DEPENDS text] [SUGGESTS text]): a package of what has the
# install component. The description's first line is its synopsis.
macro(cd_package name component section description)
    cmake_parse_arguments(arg "" "DEPENDS;SUGGESTS" "" ${ARGN})
    string(TOUPPER ${component} upper)
    list(APPEND CPACK_COMPONENTS_ALL ${component})
    set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${name})
    set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${section})
    set(CPACK_DEBIAN_${upper}_DESCRIPTION "${description}")
    set(CPACK_DEBIAN_${upper}_PACKAGE_DEPENDS "${arg_DEPENDS}")
    set(CPACK_DEBIAN_${upper}_PACKAGE_SUGGESTS "${arg_SUGGESTS}")
    file(GLOB CPACK_DEBIAN_${upper}_PACKAGE_CONTROL_EXTRA CONFIGURE_DEPENDS "${cd_debian}/${name}/*")
    install(FILES "${cd_debian}/copyright" "${CMAKE_BINARY_DIR}/changelog.Debian.gz"
        DESTINATION share/doc/${name} COMPONENT ${component} EXCLUDE_FROM_ALL)
endmacro()

cd_package(cdcluster programs science
"exact contacts between triangle meshes, on a cluster
Finds every contact between two triangle meshes, triangle by triangle, for
thousands to millions of rigid poses, on one machine or on a cluster of unlike
machines. Nothing is approximated, and every machine gives the same answer.

This package has cdctl for users, and the services cdmaster and cdworker of a
cluster. They are installed, but not started."
    DEPENDS "systemd | systemd-standalone-sysusers" SUGGESTS "openfoam-examples, sumo-tools")
cd_package(libcdcluster0 library libs
"exact contacts between triangle meshes (shared library)
Finds every contact between two triangle meshes, triangle by triangle, for
thousands to millions of rigid poses.

This package has the shared library.")
cd_package(libcdcluster-dev development libdevel
"exact contacts between triangle meshes (development files)
Finds every contact between two triangle meshes, triangle by triangle, for
thousands to millions of rigid poses.

This package has the header, and files for CMake and pkg-config."
    DEPENDS "libcdcluster0 (= ${cd_deb_version})")
if(CD_PYTHON)
    cd_package(python3-cdcluster python python
"exact contacts between triangle meshes (Python 3)
Finds every contact between two triangle meshes, triangle by triangle, for
thousands to millions of rigid poses, with NumPy arrays.

This package has the module cdcluster for Python 3."
        DEPENDS "${CD_PYTHON_DEPENDS}" SUGGESTS "python3-pandas")
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "cdcluster developers <cdcluster@example.org>" CACHE STRING "Maintainer of the packages")
set(CPACK_INSTALL_PREFIX /usr)
set(CPACK_SET_DESTDIR ON) # Files in /etc do not begin with the prefix.
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY ">=")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
include(CPack)
