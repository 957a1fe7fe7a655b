# What all our targets share.
find_program(SPLINELOFT_CCACHE ccache)
if(SPLINELOFT_CCACHE)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${SPLINELOFT_CCACHE})
    set(CMAKE_C_COMPILER_LAUNCHER ${SPLINELOFT_CCACHE})
endif()

if(SPLINELOFT_FUZZ)
    add_compile_options(-fsanitize=fuzzer-no-link)
endif()
if(SPLINELOFT_SANITIZE)
    add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
    add_link_options(-fsanitize=address,undefined)
endif()

# In the build with sanitizers, which is the slowest, libraries take what most of their files read
# precompiled; every other build shows that each file includes what it needs.
function(splineloft_read_once target)
    if(SPLINELOFT_SANITIZE AND NOT SPLINELOFT_FUZZ)
        target_precompile_headers(${target} PRIVATE ${ARGN})
    endif()
endfunction()

# Our code is compiled without a warning; the packages' headers are theirs.
function(splineloft_own_code target)
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wconversion -Wshadow -Werror)
    # GCC 12 sees overlapping copies in "c" + std::to_string(i), where there are none (its bug 105651).
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
    target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR})
endfunction()

# Every .cpp file below this folder belongs to the target: a new file needs no line here.
function(splineloft_sources target)
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
    target_sources(${target} PRIVATE ${sources})
endfunction()
