# All libraries that the rooms use, each with its lowest tested version (that of Debian 12). MuJoCo
# also has a highest version, because releases may change its structures. The installed CMake
# package uses this list, too.
set(mjforge_dependencies
  "yaml-cpp 0.7"
  "pugixml 1.13"
  "Eigen3 3.4 NO_MODULE"
  "mujoco 2.2...<4.1"
  "Boost 1.74"  # headers only: Math (quantiles), Container (small_vector), ...
  "fmt 9"
  "RapidJSON 1.1"
  "Gcrypt"  # SHA-256
  "LibArchive 3.6"
  "ZLIB 1.2"  # checksums of zip files
  "tinyobjloader"
  "PNG 1.6"
  "GIF 5.2"
  "WebP"
  "ccd 2"
  "Qhull 8 CONFIG"
  "Random123"
  "xxhash"
  "zstd 1.5 CONFIG"
  "ctemplate")  # HTML templates with automatic escaping
