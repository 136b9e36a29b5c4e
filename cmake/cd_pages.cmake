# What the built programs print about themselves, as files of the installation: manual pages, and the
# completion of cdctl in shells.

find_program(CD_GZIP gzip REQUIRED)
file(MAKE_DIRECTORY "${CMAKE_BINARY_DIR}/pages")

# cd_printed(FILE PROGRAM ARGUMENTS...): writes what PROGRAM prints with these arguments to pages/FILE of
# the build. Defaults that depend on a home folder are shown as ~.
function(cd_printed file program)
    set(output "${CMAKE_BINARY_DIR}/pages/${file}")
    add_custom_command(OUTPUT "${output}"
        COMMAND ${CMAKE_COMMAND} -E env --unset=XDG_STATE_HOME --unset=XDG_CACHE_HOME "HOME=~"
            $<TARGET_FILE:${program}> ${ARGN} > "${output}"
        DEPENDS ${program} VERBATIM)
    set_property(GLOBAL APPEND PROPERTY CD_PAGES "${output}")
endfunction()

# cd_compressed(FILE INPUT): compresses INPUT to pages/FILE of the build, the same bytes at any time.
function(cd_compressed file input)
    set(output "${CMAKE_BINARY_DIR}/pages/${file}")
    add_custom_command(OUTPUT "${output}" COMMAND ${CD_GZIP} -9nc "${input}" > "${output}"
        DEPENDS "${input}" VERBATIM)
    set_property(GLOBAL APPEND PROPERTY CD_PAGES "${output}")
endfunction()

function(cd_manual page section program)
    cd_printed(${page} ${program} --man)
    cd_compressed(${page}.gz "${CMAKE_BINARY_DIR}/pages/${page}")
    install(FILES "${CMAKE_BINARY_DIR}/pages/${page}.gz" DESTINATION share/man/man${section} COMPONENT programs)
endfunction()

function(cd_completion file folder shell)
    cd_printed(${file} cdctl completion ${shell})
    install(FILES "${CMAKE_BINARY_DIR}/pages/${file}" DESTINATION share/${folder} COMPONENT programs ${ARGN})
endfunction()

if(CMAKE_CROSSCOMPILING)
    return() # The programs do not run here.
endif()
cd_manual(cdctl.1 1 cdctl)
cd_manual(cdmaster.8 8 cdmaster)
cd_manual(cdworker.8 8 cdworker)
cd_completion(cdctl bash-completion/completions bash)
cd_completion(cdctl.fish fish/vendor_completions.d fish)
cd_completion(_cdctl zsh/vendor-completions zsh EXCLUDE_FROM_ALL)
# Debian's zsh looks for site-functions below /usr/local only.
install(FILES "${CMAKE_BINARY_DIR}/pages/_cdctl" DESTINATION share/zsh/site-functions COMPONENT local)
get_property(pages GLOBAL PROPERTY CD_PAGES)
add_custom_target(cd_pages ALL DEPENDS ${pages})
