# `cmake --install`: the library with its headers, for find_package(splineloft) and for pkg-config,
# and the program where it was built.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(headers ${CMAKE_INSTALL_INCLUDEDIR}/splineloft)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/splineloft)

# What a user may include: what splineloft.h names, and what that needs. How families blend, how
# searches search and how JSON is written is our own affair.
set(private families|lanes|digits|arrangement|blending|live_pieces|json_tape|json_text|value_reader|handling_json)
string(APPEND private |scale|rounded|natural_slopes|arcs|arc_pairs)
string(APPEND private |corners|fit|knotted|proposers|change/shape|trial|length_chart)
string(APPEND private |svg_arc|svg_scanner|number_lines|excerpt|heal|reversal|tangents|tidy)
string(APPEND private |document/change)
string(APPEND private |length_walk|rational_speed|speed_along_piece|nearest_any|nearest_cubic|nearest_search|quadrature|speed|thick_chords)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/core DESTINATION ${headers}
        FILES_MATCHING PATTERN "*.h" REGEX "/(${private})(\\.h|$)" EXCLUDE)
install(FILES ${PROJECT_SOURCE_DIR}/core/splineloft.h DESTINATION ${headers})
install(TARGETS splineloft_core EXPORT splineloft ARCHIVE)
install(EXPORT splineloft NAMESPACE splineloft:: DESTINATION ${package})
if(SPLINELOFT_APP)
    install(TARGETS splineloft RUNTIME)
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/assets/examples
            DESTINATION ${CMAKE_INSTALL_DATADIR}/splineloft)
endif()

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/splineloft-config.cmake.in
                              ${PROJECT_BINARY_DIR}/splineloft-config.cmake
                              INSTALL_DESTINATION ${package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/splineloft-config-version.cmake
                                 COMPATIBILITY SameMinorVersion)
configure_file(${PROJECT_SOURCE_DIR}/cmake/splineloft.pc.in ${PROJECT_BINARY_DIR}/splineloft.pc
               @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/splineloft-config.cmake
              ${PROJECT_BINARY_DIR}/splineloft-config-version.cmake
        DESTINATION ${package})
install(FILES ${PROJECT_BINARY_DIR}/splineloft.pc
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
