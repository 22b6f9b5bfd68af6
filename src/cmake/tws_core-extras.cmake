# Settings of every package that finds tws_core.
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
add_compile_options(-Wall -Wextra -Wpedantic -Werror)
# Tests run in the environment as it is by then: catkin's own copy of it is made before there are any Python modules of messages.
set(CATKIN_ENV ${CATKIN_DEVEL_PREFIX}/env.sh)
