# What the built programs print about themselves, as files of the installation: manual pages, and the
# completion of cdctl in shells.

# cd_generated(FILE FOLDER PROGRAM ARGUMENTS...): installs what PROGRAM prints with these arguments as
# FILE in FOLDER. Defaults that depend on a home folder are shown as ~.
function(cd_generated file folder program)
    set(output "${CMAKE_BINARY_DIR}/pages/${file}")
    add_custom_command(OUTPUT "${output}"
        COMMAND ${CMAKE_COMMAND} -E env --unset=XDG_STATE_HOME --unset=XDG_CACHE_HOME "HOME=~"
            $<TARGET_FILE:${program}> ${ARGN} > "${output}"
        DEPENDS ${program} VERBATIM)
    set_property(GLOBAL APPEND PROPERTY CD_PAGES "${output}")
    install(FILES "${output}" DESTINATION share/${folder})
endfunction()

if(CMAKE_CROSSCOMPILING)
    return() # The programs do not run here.
endif()
file(MAKE_DIRECTORY "${CMAKE_BINARY_DIR}/pages")
cd_generated(cdctl.1 man/man1 cdctl --man)
cd_generated(cdmaster.8 man/man8 cdmaster --man)
cd_generated(cdworker.8 man/man8 cdworker --man)
cd_generated(cdctl bash-completion/completions cdctl completion bash)
cd_generated(_cdctl zsh/site-functions cdctl completion zsh)
cd_generated(cdctl.fish fish/vendor_completions.d cdctl completion fish)
get_property(pages GLOBAL PROPERTY CD_PAGES)
add_custom_target(cd_pages ALL DEPENDS ${pages})
