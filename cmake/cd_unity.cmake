# Unity builds compile several files as one, so that shared headers are compiled once. The presets
# `release`, `ci` and `bench` use them. Developers' presets do not: they recompile changed files alone.

set(CD_UNITY_BATCH 8 CACHE STRING "So many files at most are compiled as one in a unity build")

# cd_first_definition(TARGET): for a program that replaces files of a library. In a unity build the
# library's groups contain the replaced files too, so the linker must prefer the program's definitions.
function(cd_first_definition target)
    if(CMAKE_UNITY_BUILD)
        target_link_options(${target} PRIVATE -Wl,--allow-multiple-definition)
    endif()
endfunction()

# cd_names_of(OUT SOURCE): the names that SOURCE defines at the beginning of a line, including those in
# anonymous namespaces, which are not indented.
function(cd_names_of out source)
    file(READ "${source}" text)
    string(REGEX REPLACE "[][;\\]" " " text "\n${text}")
    string(REGEX MATCHALL "\n[A-Za-z][^\n]*" lines "${text}")
    set(names)
    foreach(line IN LISTS lines)
        if(line MATCHES "^\n(namespace|template|static_assert|extern|INSTANTIATE|using [^=]*$)")
            continue()
        elseif(line MATCHES "^\n(TEST|TEST_F|TEST_P)\\(([A-Za-z0-9_]+), *([A-Za-z0-9_]+)")
            list(APPEND names "${CMAKE_MATCH_2}_${CMAKE_MATCH_3}")
        elseif(line MATCHES "^\n(enum class|enum|struct|class|union|using) ([A-Za-z0-9_]+)[^A-Za-z0-9_]")
            list(APPEND names "${CMAKE_MATCH_2}")
        elseif(line MATCHES "^\n([^({=]*[ *&>])?([A-Za-z0-9_]+)(\\(|{| =|$)")
            list(APPEND names "${CMAKE_MATCH_2}")
        endif()
    endforeach()
    set(${out} "${names}" PARENT_SCOPE)
endfunction()

# cd_unity_groups(OUT SOURCES...): puts files that define no name twice into groups of at most
# CD_UNITY_BATCH. OUT is the number of groups; OUT_0, OUT_1, ... are their files. Highway kernels are in
# no group, since they include themselves once for each SIMD target.
function(cd_unity_groups out)
    set(groups 0)
    foreach(source IN LISTS ARGN)
        get_filename_component(path "${source}" ABSOLUTE)
        file(STRINGS "${path}" kernel REGEX "define HWY_TARGET_INCLUDE" LIMIT_COUNT 1)
        if(kernel)
            continue()
        endif()
        cd_names_of(names "${path}")
        set(group 0)
        while(group LESS groups)
            set(both ${names_${group}} ${names})
            list(LENGTH both length)
            list(REMOVE_DUPLICATES both)
            list(LENGTH both length_without)
            list(LENGTH files_${group} size)
            if(size LESS CD_UNITY_BATCH AND length EQUAL length_without)
                break()
            endif()
            math(EXPR group "${group} + 1")
        endwhile()
        if(group EQUAL groups)
            math(EXPR groups "${groups} + 1")
            set(files_${group})
            set(names_${group})
        endif()
        list(REMOVE_DUPLICATES names)
        list(APPEND names_${group} ${names})
        list(APPEND files_${group} "${source}")
        set(${out}_${group} "${files_${group}}" PARENT_SCOPE)
    endforeach()
    set(${out} ${groups} PARENT_SCOPE)
endfunction()

# cd_unity(TARGET): compiles files of the target together if they define no name twice. If a file's name
# clashes with one in a header of other files, the folder's CMakeLists.txt sets
# SKIP_UNITY_BUILD_INCLUSION for the file.
function(cd_unity target)
    if(NOT CMAKE_UNITY_BUILD)
        return()
    endif()
    set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
    get_target_property(sources ${target} SOURCES)
    cd_unity_groups(groups ${sources})
    foreach(number RANGE ${groups})
        foreach(source IN LISTS groups_${number})
            set_source_files_properties("${source}" PROPERTIES UNITY_GROUP "${target}_${number}")
        endforeach()
    endforeach()
endfunction()
