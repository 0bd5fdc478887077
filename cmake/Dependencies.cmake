# Every outside library the rooms use, with the lowest version that is known to
# work: those of Debian 12. Of MuJoCo also the highest, since each release may change its
# structures. Installed with the package, which looks for the same.
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
  "tinyobjloader"
  "PNG 1.6"
  "ZLIB 1.2"
  "GIF 5.2"
  "WebP"
  "ccd 2"
  "Qhull 8 CONFIG"
  "Random123"
  "xxhash"
  "ctemplate")  # HTML that escapes by itself
