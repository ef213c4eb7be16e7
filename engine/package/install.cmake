# What `cmake --install` puts where: the libraries, the headers, what find_package(Islet) reads, and what pkg-config reads.

include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

# islet_install(COMPONENT NAME PC_FILE DESCRIPTION [REQUIRED PC_FILE]): the library that the build calls islet::NAME, as a component for find_package
# and as PC_FILE.pc for pkg-config.
function(islet_install component name pc description)
    set(islet_cmake_folder ${CMAKE_INSTALL_LIBDIR}/cmake/Islet)
    get_target_property(target islet::${name} ALIASED_TARGET)
    set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} EXCLUDE_FROM_ALL OFF)
    install(
        TARGETS ${target} EXPORT Islet-${component}
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
        RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR}
    )
    install(EXPORT Islet-${component} NAMESPACE islet:: FILE Islet-${component}.cmake DESTINATION ${islet_cmake_folder})
    set(PC_NAME ${pc})
    set(PC_DESCRIPTION ${description})
    set(PC_LIBRARY ${target})
    set(PC_REQUIRES ${ARGN})
    set(PC_BEFORE "")
    if(pc STREQUAL islet AND ISLET_WITH_C)  # C programs ask for islet too
        set(PC_BEFORE "-lislet_c ")
    endif()
    # What programs must be compiled with too: the small profile.
    set(PC_DEFINITIONS "")
    get_target_property(definitions ${target} INTERFACE_COMPILE_DEFINITIONS)
    if(definitions)
        list(TRANSFORM definitions PREPEND " -D" OUTPUT_VARIABLE PC_DEFINITIONS)
        list(JOIN PC_DEFINITIONS "" PC_DEFINITIONS)
    endif()
    # The prefix is found from where the file is, so that the whole may be moved.
    file(RELATIVE_PATH PC_PREFIX /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
    string(REGEX REPLACE "/$" "" PC_PREFIX ${PC_PREFIX})
    configure_file(${CMAKE_CURRENT_FUNCTION_LIST_DIR}/islet.pc.in ${CMAKE_CURRENT_BINARY_DIR}/${pc}.pc @ONLY)
    install(FILES ${CMAKE_CURRENT_BINARY_DIR}/${pc}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endfunction()

islet_install(engine islet islet "2D rigid-body physics in one fixed block of memory")
islet_install(lcp lcp islet-lcp "Solvers of linear complementarity problems")
install(FILES ${CMAKE_CURRENT_LIST_DIR}/../../LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/islet-dev RENAME copyright)
install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/include/islet DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN *.hpp PATTERN *.h)

# While the first number is 0, another second one may need changes.
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/IsletConfigVersion.cmake VERSION ${ISLET_VERSION} COMPATIBILITY SameMinorVersion)
install(
    FILES ${CMAKE_CURRENT_LIST_DIR}/IsletConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/IsletConfigVersion.cmake DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Islet
)
