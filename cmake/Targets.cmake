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
    # At addresses that are known, each of some thousand tests starts a fifth sooner.
    add_compile_options(-fno-pie)
    add_link_options(-no-pie)
endif()

# Our code is compiled without a warning; the packages' headers are theirs.
function(splineloft_own_code target)
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wconversion -Wshadow -Werror)
    # GCC 12 sees overlapping copies in "c" + std::to_string(i), where there are none (its bug 105651).
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
    target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR})
endfunction()

# The target's files are compiled several at a time, so that what all of them include is read once.
# A name in an unnamed namespace may then stand beside one of another file, which it must differ
# from, but not hide.
function(splineloft_in_batches target)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 16)
    target_compile_options(${target} PRIVATE -Wno-shadow
                           $<$<CXX_COMPILER_ID:GNU>:-Wshadow=local>)
endfunction()

# Libraries are compiled so for release and with sanitizers. The other builds, for a debugger and for
# fuzzing, show that each file includes what it needs.
function(splineloft_library_in_batches target)
    if(CMAKE_BUILD_TYPE STREQUAL "Release" OR (SPLINELOFT_SANITIZE AND NOT SPLINELOFT_FUZZ))
        splineloft_in_batches(${target})
    endif()
endfunction()

# Every .cpp file below this folder belongs to the target: a new file needs no line here.
function(splineloft_sources target)
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
    target_sources(${target} PRIVATE ${sources})
endfunction()
