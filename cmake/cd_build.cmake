# Compiler settings of all our targets, and the functions that declare targets.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

if(NOT CMAKE_BUILD_TYPE)
    set(CMAKE_BUILD_TYPE Release)
endif()

include(cd_unity)

find_program(CD_CCACHE ccache)
if(CD_CCACHE)
    # One cache serves every checkout and build folder.
    set(CMAKE_CXX_COMPILER_LAUNCHER
        "${CMAKE_COMMAND};-E;env;CCACHE_BASEDIR=${CMAKE_SOURCE_DIR};CCACHE_NOHASHDIR=1;CCACHE_SLOPPINESS=pch_defines,time_macros;${CD_CCACHE}")
endif()
find_program(CD_MOLD mold)
if(CD_MOLD)
    add_link_options(-fuse-ld=mold)
endif()
if(CD_TIDY)
    find_program(CD_CLANG_TIDY NAMES clang-tidy-16 clang-tidy REQUIRED)
    set(CMAKE_CXX_CLANG_TIDY "${CD_CLANG_TIDY};--quiet;--extra-arg=-DBOOST_ASIO_HAS_CO_AWAIT=1;--extra-arg=-DBOOST_ASIO_HAS_STD_COROUTINE=1;--extra-arg=-Wno-unknown-warning-option")
endif()

add_library(cd_flags INTERFACE)
# No fused multiply-add, and by default no reassociation: results are bit-identical on every host.
target_compile_options(cd_flags INTERFACE -ffp-contract=off)
if(CMAKE_SYSTEM_PROCESSOR STREQUAL "aarch64")
    # Eigen's NEON code fuses in spite of -ffp-contract=off.
    target_compile_options(cd_flags INTERFACE -U__ARM_FEATURE_FMA)
endif()
# GCC 12.2's basic-block vectoriser drops the rounding of double(float(x)) on two neighbours. The
# canonical form of meshes and boxes needs this rounding (tests/common/core/rounding_test.cpp).
target_compile_options(cd_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>)
target_compile_options(cd_flags INTERFACE
    -Wall -Wextra -Wpedantic $<$<NOT:$<BOOL:${CMAKE_UNITY_BUILD}>>:-Wshadow> -Wnon-virtual-dtor -Wold-style-cast -Wcast-align
    -Woverloaded-virtual -Wimplicit-fallthrough $<$<BOOL:${CD_WERROR}>:-Werror>)
if(CMAKE_UNITY_BUILD)
    # GCC takes an included file for a header and warns of anonymous bases in it. -Wshadow is off
    # above, since a file may shadow names of an earlier one.
    target_compile_options(cd_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endif()
# GCC 12 reports these falsely for inlined library code; the last one for the frames of Asio's
# coroutines, which recycle memory.
target_compile_options(cd_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:
    -Wno-stringop-overflow -Wno-stringop-overread -Wno-array-bounds -Wno-maybe-uninitialized -Wno-restrict
    -Wno-mismatched-new-delete>)
# GCC's garbage collection takes 7 to 15 % of a compilation; memory suffices without it.
target_compile_options(cd_flags INTERFACE
    "$<$<CXX_COMPILER_ID:GNU>:SHELL:--param ggc-min-heapsize=1500000>")
target_include_directories(cd_flags INTERFACE "${CMAKE_SOURCE_DIR}")
target_link_libraries(cd_flags INTERFACE Threads::Threads)

# cd_quick_folder(): with CD_QUICK_TESTS, compiles the targets of the calling folder and its subfolders
# at -O1, which takes a third less time. It does not affect the programs' libraries.
macro(cd_quick_folder)
    if(CD_QUICK_TESTS)
        add_compile_options(-O1)
    endif()
endmacro()

# cd_messaging_folder(): compiles the targets of the calling folder at -O2. Code that passes messages is
# as fast as at -O3 (bench/cluster/rate), and compiles in a fifth less time.
macro(cd_messaging_folder)
    add_compile_options($<$<CONFIG:Release>:-O2>)
endmacro()

# cd_add_library(NAME [PUBLIC libs...] [PRIVATE libs...]): a library of all .cpp files of the calling
# folder and its subfolders, except main.cpp.
function(cd_add_library name)
    cmake_parse_arguments(arg "" "" "PUBLIC;PRIVATE" ${ARGN})
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/*.cpp")
    list(FILTER sources EXCLUDE REGEX "/main\\.cpp$")
    add_library(${name} STATIC ${sources})
    target_link_libraries(${name} PUBLIC cd_flags ${arg_PUBLIC} PRIVATE ${arg_PRIVATE})
    cd_unity(${name})
endfunction()

# cd_precompile(TARGET [FROM]): in unity builds, compiles the dear headers that most files of TARGET include
# once, or takes them from the target FROM, which must have the same options. Others compile each header
# where it is included, so that a missing #include is found.
function(cd_precompile target)
    if(NOT CMAKE_UNITY_BUILD)
        return()
    elseif(ARGC EQUAL 2)
        target_precompile_headers(${target} REUSE_FROM ${ARGV1})
    else()
        target_precompile_headers(${target} PRIVATE "${CMAKE_SOURCE_DIR}/proto/channel/asio.hpp"
            "${CMAKE_SOURCE_DIR}/common/geometry/types.hpp" <chrono> <filesystem> <functional> <map> <memory>
            <optional> <span> <string> <vector>)
    endif()
endfunction()

# cd_add_program(NAME LIBRARY): a program of main.cpp in the calling folder, built into bin/.
function(cd_add_program name library)
    add_executable(${name} main.cpp)
    target_link_libraries(${name} PRIVATE ${library})
    set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/bin")
    install(TARGETS ${name} RUNTIME COMPONENT programs)
endfunction()

# cd_add_test(NAME FOLDER LABEL [libs...]): a test program of all *_test.cpp in FOLDER and below.
function(cd_add_test name folder label)
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*_test.cpp")
    if(NOT sources)
        return()
    endif()
    add_executable(${name} ${sources})
    cd_unity(${name})
    target_link_libraries(${name} PRIVATE ${ARGN} cd_test_support GTest::gtest_main GTest::gmock)
    # Tests do not heed the configuration of the user who runs them.
    gtest_discover_tests(${name} PROPERTIES LABELS ${label} ENVIRONMENT CDCTL_CONFIG=none DISCOVERY_MODE PRE_TEST)
endfunction()
