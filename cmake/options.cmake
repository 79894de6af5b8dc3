# What every target of the project is compiled with, and how a folder becomes a library.
include(GNUInstallDirs)
add_library(pennon_options INTERFACE)
target_compile_features(pennon_options INTERFACE cxx_std_20)
target_compile_options(pennon_options INTERFACE "$<BUILD_INTERFACE:-Wall;-Wextra;-Wpedantic;-Wshadow>")
# Sums and products are rounded one by one, so that scalar and vector code and every machine give the
# same bits; square roots neither set errno nor trap, so that loops over them become vector code.
target_compile_options(pennon_options INTERFACE -ffp-contract=off -fno-math-errno -fno-trapping-math)
# Threads would share out Eigen's products by their number, and with it the rounding.
target_compile_definitions(pennon_options INTERFACE EIGEN_DONT_PARALLELIZE)
target_include_directories(pennon_options INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
                                                    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/pennon>)
if(CMAKE_UNITY_BUILD)
  # The compiler takes a source that a unity build includes for a header, and warns of classes in it
  # whose members have types of an anonymous namespace.
  target_compile_options(pennon_options INTERFACE $<BUILD_INTERFACE:-Wno-subobject-linkage>)
endif()
if(PENNON_SANITIZE)
  target_compile_options(pennon_options INTERFACE
    -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(pennon_options INTERFACE -fsanitize=address,undefined)
endif()

# pennon_library(SOURCES sources... LINK libraries...): the library of one folder, named after it:
# dns/grid becomes pennon::dns_grid. What a folder may include is what its library links: the global
# property PENNON_LAYERS lists that for tests/unit/layers.cpp.
# NAME: for the second library of a folder. Without sources a library is of headers alone.
function(pennon_library)
  cmake_parse_arguments(ARG "" "NAME" "SOURCES;LINK" ${ARGN})
  cmake_path(RELATIVE_PATH CMAKE_CURRENT_SOURCE_DIR BASE_DIRECTORY ${PROJECT_SOURCE_DIR}
             OUTPUT_VARIABLE folder)
  if(NOT ARG_NAME)
    string(REPLACE "/" "_" ARG_NAME ${folder})
  endif()
  set(library pennon_${ARG_NAME})
  if(ARG_SOURCES)
    add_library(${library} STATIC ${ARG_SOURCES})
    target_link_libraries(${library} PUBLIC pennon_options ${ARG_LINK})
  else()
    add_library(${library} INTERFACE)
    target_link_libraries(${library} INTERFACE pennon_options ${ARG_LINK})
  endif()
  add_library(pennon::${ARG_NAME} ALIAS ${library})
  set_target_properties(${library} PROPERTIES EXPORT_NAME ${ARG_NAME})
  set_property(GLOBAL APPEND PROPERTY PENNON_LIBRARIES ${library})
  set(links ${ARG_LINK})
  list(FILTER links INCLUDE REGEX "^pennon::")
  list(JOIN links " " links)
  set_property(GLOBAL APPEND PROPERTY PENNON_LAYERS "${folder} pennon::${ARG_NAME} ${links}")
endfunction()
