# Every dependency: the system's CMake package first, then pkg-config, then a pinned download.
include(FetchContent)
find_package(PkgConfig)
set(FETCHCONTENT_QUIET ON)

# splineloft_find(NAME target CMAKE package PKG module FETCH repository tag)
# leaves the imported target `splineloft_dep_NAME`.
function(splineloft_find name)
    cmake_parse_arguments(ARG "" "CMAKE;TARGET;PKG;FETCH;TAG" "" ${ARGN})
    add_library(splineloft_dep_${name} INTERFACE)
    if(ARG_CMAKE)
        find_package(${ARG_CMAKE} QUIET)
        if(TARGET ${ARG_TARGET})
            target_link_libraries(splineloft_dep_${name} INTERFACE ${ARG_TARGET})
            return()
        endif()
    endif()
    if(ARG_PKG AND PKG_CONFIG_FOUND)
        pkg_check_modules(PC_${name} QUIET IMPORTED_TARGET ${ARG_PKG})
        if(PC_${name}_FOUND)
            target_link_libraries(splineloft_dep_${name} INTERFACE PkgConfig::PC_${name})
            return()
        endif()
    endif()
    if(NOT ARG_FETCH)
        message(FATAL_ERROR "${name} was not found: install its development package (see run.sh)")
    endif()
    message(STATUS "${name}: not installed, fetching ${ARG_FETCH} ${ARG_TAG}")
    set(shallow ON) # of a tag, that is: a bare commit cannot be cloned shallowly
    if(ARG_TAG MATCHES "^[0-9a-f]+$")
        set(shallow OFF)
    endif()
    FetchContent_Declare(${name} GIT_REPOSITORY ${ARG_FETCH} GIT_TAG ${ARG_TAG}
                         GIT_SHALLOW ${shallow} SYSTEM)
    FetchContent_MakeAvailable(${name})
    if(TARGET ${ARG_TARGET})
        target_link_libraries(splineloft_dep_${name} INTERFACE ${ARG_TARGET})
    else()
        target_include_directories(splineloft_dep_${name} SYSTEM INTERFACE ${${name}_SOURCE_DIR})
    endif()
endfunction()

splineloft_find(glm CMAKE glm TARGET glm::glm PKG glm
                FETCH https://github.com/g-truc/glm.git TAG 0.9.9.8)
splineloft_find(nlohmann_json CMAKE nlohmann_json TARGET nlohmann_json::nlohmann_json
                PKG nlohmann_json FETCH https://github.com/nlohmann/json.git TAG v3.11.2)
splineloft_find(pugixml CMAKE pugixml TARGET pugixml::pugixml PKG pugixml
                FETCH https://github.com/zeux/pugixml.git TAG v1.13)
splineloft_find(CLI11 CMAKE CLI11 TARGET CLI11::CLI11 PKG CLI11
                FETCH https://github.com/CLIUtils/CLI11.git TAG v2.3.2)

# Vectors of whatever width the machine has. When we fetch it, we build the library alone.
foreach(part TESTS EXAMPLES CONTRIB INSTALL)
    set(HWY_ENABLE_${part} OFF CACHE BOOL "" FORCE)
endforeach()
splineloft_find(hwy CMAKE hwy TARGET hwy::hwy PKG libhwy
                FETCH https://github.com/google/highway.git TAG 1.0.3)
if(TARGET hwy AND NOT TARGET hwy::hwy)
    target_link_libraries(splineloft_dep_hwy INTERFACE hwy) # its name in its own sources
endif()
set(SPLINELOFT_PRIVATE_LIBRARIES "-lhwy -lpugixml") # what splineloft.pc adds to our own library

# Dear ImGui and stb are bare sources: when they had to be fetched, we compile what we use.
function(splineloft_build_imgui)
    FetchContent_GetProperties(imgui SOURCE_DIR dir POPULATED fetched)
    if(NOT fetched)
        return()
    endif()
    add_library(splineloft_imgui STATIC
        ${dir}/imgui.cpp ${dir}/imgui_draw.cpp ${dir}/imgui_tables.cpp ${dir}/imgui_widgets.cpp
        ${dir}/imgui_demo.cpp ${dir}/misc/cpp/imgui_stdlib.cpp
        ${dir}/backends/imgui_impl_opengl3.cpp)
    target_include_directories(splineloft_imgui SYSTEM PUBLIC ${dir} ${dir}/misc/cpp)
    target_link_libraries(splineloft_imgui PUBLIC ${CMAKE_DL_LIBS})
    target_link_libraries(splineloft_dep_imgui INTERFACE splineloft_imgui)
endfunction()

function(splineloft_build_stb)
    FetchContent_GetProperties(stb SOURCE_DIR dir POPULATED fetched)
    if(NOT fetched)
        return()
    endif()
    file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/stb_image_write.c CONTENT
         "#define STB_IMAGE_WRITE_IMPLEMENTATION\n#include <stb_image_write.h>\n")
    add_library(splineloft_stb STATIC ${PROJECT_BINARY_DIR}/stb_image_write.c)
    target_include_directories(splineloft_stb SYSTEM PUBLIC ${dir})
    target_link_libraries(splineloft_dep_stb INTERFACE splineloft_stb)
endfunction()

# glad writes the OpenGL loader while we build. Its script names the system's own Python, which is
# not always the first one on the PATH, so we call the two together.
function(splineloft_generate_glad)
    find_program(SPLINELOFT_GLAD glad PATHS /usr/bin NO_DEFAULT_PATH)
    find_program(SPLINELOFT_GLAD glad)
    if(NOT SPLINELOFT_GLAD)
        message(FATAL_ERROR "glad 2 was not found: install python3-glad (or pip install glad2)")
    endif()
    set(command ${SPLINELOFT_GLAD})
    if(SPLINELOFT_GLAD STREQUAL "/usr/bin/glad" AND EXISTS /usr/bin/python3)
        set(command /usr/bin/python3 /usr/bin/glad)
    endif()
    set(out ${PROJECT_BINARY_DIR}/glad)
    add_custom_command(
        OUTPUT ${out}/src/gl.c ${out}/include/glad/gl.h
        COMMAND ${command} --quiet --reproducible --api gl:core=3.3 --extensions=
                --out-path ${out} c
        COMMENT "Generating the OpenGL 3.3 loader" VERBATIM)
    add_library(splineloft_glad STATIC ${out}/src/gl.c ${out}/include/glad/gl.h)
    target_include_directories(splineloft_glad SYSTEM PUBLIC ${out}/include)
    target_link_libraries(splineloft_glad PUBLIC ${CMAKE_DL_LIBS})
endfunction()

if(SPLINELOFT_APP)
    splineloft_find(glfw CMAKE glfw3 TARGET glfw PKG glfw3
                    FETCH https://github.com/glfw/glfw.git TAG 3.3.8)
    splineloft_find(stb PKG stb FETCH https://github.com/nothings/stb.git
                    TAG 5736b15f7ea0ffb08dd38af21067c314d6a3aae9)
    splineloft_build_stb()
    splineloft_find(imgui PKG imgui FETCH https://github.com/ocornut/imgui.git TAG v1.86)
    splineloft_build_imgui()
    splineloft_find(fontconfig CMAKE Fontconfig TARGET Fontconfig::Fontconfig PKG fontconfig)
    # Optional: off-screen pictures on a machine without any display. (CMake's own OpenGL::EGL also
    # wants libOpenGL, which nothing here needs: glad finds the functions.)
    if(PKG_CONFIG_FOUND)
        pkg_check_modules(PC_egl QUIET IMPORTED_TARGET egl)
    endif()
    if(NOT PC_egl_FOUND)
        message(STATUS "EGL was not found: screenshots will need a display")
    endif()
    splineloft_generate_glad()
endif()
