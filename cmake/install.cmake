# cmake --install build --prefix PREFIX: the programs side by side in bin, their manual page and
# completion, and a CMake package, so that another project finds the libraries and their headers:
#
#   find_package(pennon REQUIRED)                        # languages C and CXX
#   target_link_libraries(its_program PRIVATE pennon::lsa)
#
# and `#include "lsa/dispersion.hpp"`. A library is named after its folder: dns/grid is
# pennon::dns_grid. The commands of app/ are no library for others.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/pennon)

install(TARGETS pennon pennon-global RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(FILES ${PROJECT_BINARY_DIR}/app/pennon.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${PROJECT_BINARY_DIR}/app/pennon.bash RENAME pennon
        DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

get_property(libraries GLOBAL PROPERTY PENNON_LIBRARIES)
list(FILTER libraries EXCLUDE REGEX "^pennon_app")
set_target_properties(pennon_options PROPERTIES EXPORT_NAME options)
install(TARGETS pennon_options ${libraries} EXPORT pennon
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}/pennon)
install(DIRECTORY common lsa dns modes analysis DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/pennon
        FILES_MATCHING PATTERN "*.hpp")

install(EXPORT pennon NAMESPACE pennon:: FILE pennonTargets.cmake DESTINATION ${package_dir})
configure_package_config_file(cmake/pennonConfig.cmake.in ${PROJECT_BINARY_DIR}/pennonConfig.cmake
                              INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/pennonConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/pennonConfig.cmake ${PROJECT_BINARY_DIR}/pennonConfigVersion.cmake
              cmake/dependencies.cmake
        DESTINATION ${package_dir})
