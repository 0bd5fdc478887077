# Flags for our own code only; they are not exported.
add_library(mjforge_options INTERFACE)
target_compile_options(mjforge_options INTERFACE -Wall -Wextra -Wpedantic -Wconversion)
