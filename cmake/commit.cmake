# Writes OUT, a source file with the commit of SOURCE, unless its content is unchanged.
execute_process(COMMAND git -C "${SOURCE}" describe --always --dirty --abbrev=12 --exclude=*
    OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT commit)
    set(commit "unknown")
endif()
set(text "#include \"common/core/build_info.hpp\"\n\nstd::string_view cd::build_commit() {\n    return \"${commit}\";\n}\n")
if(EXISTS "${OUT}")
    file(READ "${OUT}" before)
endif()
if(NOT "${before}" STREQUAL "${text}")
    file(WRITE "${OUT}" "${text}")
endif()
