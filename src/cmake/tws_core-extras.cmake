# Settings of every package that finds tws_core, and the functions that its CMakeLists.txt is made of.
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
add_compile_options(-Wall -Wextra -Wpedantic -Werror)
# Tests run in the environment as it is by then: catkin's own copy of it is made before there are any Python modules of messages.
set(CATKIN_ENV ${CATKIN_DEVEL_PREFIX}/env.sh)

set(TWS_SANITIZE "" CACHE STRING "Sanitizers to build with: address,undefined or thread; .ci/sanitize does it")
if(TWS_SANITIZE)
  # GCC warns of more in what sanitizers make of the code, and means nothing in it.
  add_compile_options(-fsanitize=${TWS_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer -Wno-error)
  add_link_options(-fsanitize=${TWS_SANITIZE})
endif()

option(TWS_LTO "Optimise across files the libraries whose hot loops cross them" ON)

# Each target is named PACKAGE_NAME, for all packages share one name space of targets; its file is named NAME.
function(_tws_target variable name)
  if(name MATCHES "^${PROJECT_NAME}")
    set(${variable} ${name} PARENT_SCOPE)
  else()
    set(${variable} ${PROJECT_NAME}_${name} PARENT_SCOPE)
  endif()
endfunction()

# Code of tests, and of a program around its library, runs for moments and compiles for long: -O1 takes a quarter off a test, two fifths off
# what reads a command line or a YAML file. What they call is optimised in full.
function(_tws_light_optimisation target)
  if(CMAKE_BUILD_TYPE STREQUAL "Release")
    # At -O1 GCC mistakes a test's own operator delete for the wrong one.
    target_compile_options(${target} PRIVATE -O1 -Wno-mismatched-new-delete)
  endif()
endfunction()

# tws_library(SOURCE... [STATIC] [LTO] [LIGHT] [LINK LIBRARY...])
# The package's library, installed with the headers of include/PACKAGE; it links what catkin found, and LIBRARY... besides.
# LIGHT: it has nothing that must be fast.
function(tws_library)
  cmake_parse_arguments(PARSE_ARGV 0 arg "STATIC;LTO;LIGHT" "" "LINK")
  foreach(folder src include)
    if(IS_DIRECTORY ${PROJECT_SOURCE_DIR}/${folder})
      include_directories(${folder})
    endif()
  endforeach()
  if(IS_DIRECTORY ${PROJECT_SOURCE_DIR}/include/${PROJECT_NAME})
    install(DIRECTORY include/${PROJECT_NAME}/ DESTINATION ${CATKIN_PACKAGE_INCLUDE_DESTINATION})
  endif()
  include_directories(SYSTEM ${catkin_INCLUDE_DIRS} ${EIGEN3_INCLUDE_DIRS} ${Boost_INCLUDE_DIRS})
  if(arg_STATIC)
    add_library(${PROJECT_NAME} STATIC ${arg_UNPARSED_ARGUMENTS})
    set_target_properties(${PROJECT_NAME} PROPERTIES POSITION_INDEPENDENT_CODE ON) # Nodelets are shared libraries.
  else()
    add_library(${PROJECT_NAME} ${arg_UNPARSED_ARGUMENTS})
    install(TARGETS ${PROJECT_NAME}
      ARCHIVE DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION}
      LIBRARY DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION}
      RUNTIME DESTINATION ${CATKIN_GLOBAL_BIN_DESTINATION}
    )
  endif()
  if(catkin_EXPORTED_TARGETS)
    add_dependencies(${PROJECT_NAME} ${catkin_EXPORTED_TARGETS})
  endif()
  target_link_libraries(${PROJECT_NAME} ${catkin_LIBRARIES} ${arg_LINK})
  # Nobody puts a function of his own in the place of one of ours: calls within a library may be inlined and bound when it is linked.
  if(CMAKE_SYSTEM_NAME STREQUAL "Linux")
    target_compile_options(${PROJECT_NAME} PRIVATE -fno-semantic-interposition)
    set_property(TARGET ${PROJECT_NAME} APPEND_STRING PROPERTY LINK_FLAGS " -Wl,-Bsymbolic-functions")
  endif()
  if(arg_LIGHT)
    _tws_light_optimisation(${PROJECT_NAME})
  endif()
  # CMake's own switch for this uses an option that clang-tidy refuses.
  if(arg_LTO AND TWS_LTO AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_BUILD_TYPE STREQUAL "Release")
    target_compile_options(${PROJECT_NAME} PRIVATE -flto)
    target_link_options(${PROJECT_NAME} PRIVATE -flto=auto)
  endif()
endfunction()

# tws_program(NAME SOURCE... [LINK LIBRARY...])
# A program that rosrun finds.
function(tws_program name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "LINK")
  _tws_target(target ${name})
  add_executable(${target} ${arg_UNPARSED_ARGUMENTS})
  set_target_properties(${target} PROPERTIES OUTPUT_NAME ${name})
  target_link_libraries(${target} ${PROJECT_NAME} ${arg_LINK})
  _tws_light_optimisation(${target})
  install(TARGETS ${target} RUNTIME DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
endfunction()

# tws_node(NAME SOURCE)
# A node of the package's library, by TWS_NODE (tws_runtime/node_main.h) in SOURCE: the program NAME, and the nodelet class
# PACKAGE/NAMElet in the library PACKAGE_nodelets. nodelet_plugins.xml must have an entry for it.
function(tws_node name source)
  # What includes ROS's headers is compiled with the rest of the library, which has read them already.
  target_sources(${PROJECT_NAME} PRIVATE ${PROJECT_SOURCE_DIR}/${source})
  set(main ${CMAKE_CURRENT_BINARY_DIR}/${name}_main.cpp)
  file(CONFIGURE OUTPUT ${main} CONTENT "namespace ${PROJECT_NAME} {
int ${name}Main(int argc, char** argv);
}
int main(int argc, char** argv) { return ${PROJECT_NAME}::${name}Main(argc, argv); }
")
  tws_program(${name} ${main})
  file(STRINGS ${PROJECT_SOURCE_DIR}/nodelet_plugins.xml entry REGEX "name=\"${PROJECT_NAME}/${name}let\"")
  if(NOT entry)
    message(FATAL_ERROR "nodelet_plugins.xml of ${PROJECT_NAME} lacks the class ${PROJECT_NAME}/${name}let")
  endif()
  set(nodelets ${PROJECT_NAME}_nodelets)
  if(TARGET ${nodelets})
    target_sources(${nodelets} PRIVATE ${PROJECT_SOURCE_DIR}/${source})
    return()
  endif()
  add_library(${nodelets} ${PROJECT_SOURCE_DIR}/${source})
  target_compile_definitions(${nodelets} PRIVATE TWS_NODELET)
  target_link_libraries(${nodelets} ${PROJECT_NAME})
  install(TARGETS ${nodelets} LIBRARY DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION})
  install(FILES nodelet_plugins.xml DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
endfunction()

# tws_share(PATH...)
# Installs files and folders that a launch file names.
function(tws_share)
  foreach(path ${ARGN})
    if(IS_DIRECTORY ${PROJECT_SOURCE_DIR}/${path})
      install(DIRECTORY ${path} DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
    else()
      install(FILES ${path} DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
    endif()
  endforeach()
endfunction()

# tws_launch_folder([IGNORE_UNSET_ARGS])
# Installs launch/, in which each node of the package has a launch file, and has roslaunch check these. IGNORE_UNSET_ARGS: some
# of them must be told something.
function(tws_launch_folder)
  install(DIRECTORY launch DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
  if(CATKIN_ENABLE_TESTING)
    find_package(roslaunch REQUIRED)
    roslaunch_add_file_check(launch ${ARGN})
  endif()
endfunction()

# tws_tests(SOURCE... [DEFINE MACRO="TEXT"...] [LINK LIBRARY...])
# The package's GoogleTests, as one program.
function(tws_tests)
  if(NOT CATKIN_ENABLE_TESTING)
    return()
  endif()
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "" "DEFINE;LINK")
  catkin_add_gtest(${PROJECT_NAME}_test ${arg_UNPARSED_ARGUMENTS})
  target_compile_definitions(${PROJECT_NAME}_test PRIVATE ${arg_DEFINE})
  target_link_libraries(${PROJECT_NAME}_test ${PROJECT_NAME} ${arg_LINK} gtest_main)
  _tws_light_optimisation(${PROJECT_NAME}_test)
endfunction()

# tws_test_program(NAME SOURCE...)
# A program that a test runs; it is not installed.
function(tws_test_program name)
  if(CATKIN_ENABLE_TESTING)
    add_executable(${PROJECT_NAME}_${name} ${ARGN})
    target_link_libraries(${PROJECT_NAME}_${name} ${PROJECT_NAME})
  endif()
endfunction()

# tws_python_test(NAME SCRIPT [IN_WORKSPACE] [SECONDS N] [ARGUMENTS ARGUMENT...])
# A test in Python. IN_WORKSPACE: it needs the Python modules of the messages, or has packages found. SECONDS: about how long it takes, if it is
# long; ctest starts such tests first.
function(tws_python_test name script)
  if(NOT CATKIN_ENABLE_TESTING)
    return()
  endif()
  cmake_parse_arguments(PARSE_ARGV 2 arg "IN_WORKSPACE" "SECONDS" "ARGUMENTS")
  find_package(Python3 REQUIRED COMPONENTS Interpreter)
  set(environment "")
  if(arg_IN_WORKSPACE)
    set(environment ${CATKIN_ENV})
  endif()
  add_test(NAME _ctest_${PROJECT_NAME}_${name}
    COMMAND ${environment} ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/${script} ${arg_ARGUMENTS})
  if(arg_SECONDS)
    set_tests_properties(_ctest_${PROJECT_NAME}_${name} PROPERTIES COST ${arg_SECONDS})
  endif()
endfunction()

# tws_fuzzer(NAME SOURCE... CORPUS FOLDER [SEEDS FOLDER] [LINK LIBRARY...])
# A fuzz target, built by clang with sanitizers when its test runs, see fuzz/run. The first SOURCE has fuzzing::fuzz(); the others are what it
# tests: with more of the package's sources it finds more, and compiles longer. SEEDS: more of them, a folder of TWS_SHARED/data/reported_inputs.
set(_tws_fuzz_folder ${CMAKE_CURRENT_LIST_DIR}/fuzz)
function(tws_fuzzer name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "CORPUS;SEEDS" "LINK")
  # Libraries that GCC instrumented cannot be linked with what clang does.
  if(NOT CATKIN_ENABLE_TESTING OR (TWS_SANITIZE AND arg_LINK MATCHES "tws_|${PROJECT_NAME}"))
    return()
  endif()
  set(includes $<TARGET_PROPERTY:${PROJECT_NAME},INCLUDE_DIRECTORIES>)
  set(words "-I$<JOIN:$<REMOVE_DUPLICATES:${includes}>,$<SEMICOLON>-I>")
  foreach(library ${arg_LINK})
    if(TARGET ${library})
      list(APPEND words $<TARGET_LINKER_FILE:${library}> -Wl,-rpath,$<TARGET_LINKER_FILE_DIR:${library}>)
    elseif(IS_ABSOLUTE ${library})
      get_filename_component(folder ${library} DIRECTORY)
      list(APPEND words ${library} -Wl,-rpath,${folder})
    elseif(library MATCHES "^-")
      list(APPEND words ${library})
    else()
      list(APPEND words -l${library})
    endif()
  endforeach()
  list(TRANSFORM arg_UNPARSED_ARGUMENTS PREPEND ${PROJECT_SOURCE_DIR}/)
  set(test _ctest_${PROJECT_NAME}_fuzz_${name})
  add_test(NAME ${test} COMMAND ${_tws_fuzz_folder}/run ${name} ${PROJECT_SOURCE_DIR}/${arg_CORPUS} ${arg_UNPARSED_ARGUMENTS} -- ${words}
    COMMAND_EXPAND_LISTS)
  set(environment "FUZZING_SEEDS=${arg_SEEDS}")
  if(TWS_UNITY)
    list(APPEND environment "FUZZING_UNITS=${CMAKE_SOURCE_DIR}/.ci/unity.py")
  endif()
  set_tests_properties(${test} PROPERTIES SKIP_RETURN_CODE 77 TIMEOUT 7200 COST 20 ENVIRONMENT "${environment}")
endfunction()

# tws_rostest(LAUNCH_FILE [NAME SOURCE...] [NODES NODE...] [LINK LIBRARY...] [ALONE])
# A test among live nodes; its GoogleTests, if it has any, are SOURCE... and make the program NAME. ALONE: it keeps the machine busy, and others
# beside it from their time.
function(tws_rostest launch_file)
  if(NOT CATKIN_ENABLE_TESTING)
    return()
  endif()
  cmake_parse_arguments(PARSE_ARGV 1 arg "ALONE" "" "NODES;LINK")
  find_package(rostest REQUIRED)
  set(nodes "")
  foreach(node ${arg_NODES})
    _tws_target(target ${node})
    list(APPEND nodes ${target})
  endforeach()
  if(arg_UNPARSED_ARGUMENTS)
    list(POP_FRONT arg_UNPARSED_ARGUMENTS name)
    set(target ${PROJECT_NAME}_${name})
    add_rostest_gtest(${target} ${launch_file} ${arg_UNPARSED_ARGUMENTS})
    add_dependencies(${target} ${nodes} ${catkin_EXPORTED_TARGETS})
    target_link_libraries(${target} ${arg_LINK} ${catkin_LIBRARIES})
    _tws_light_optimisation(${target})
  else()
    add_rostest(${launch_file} DEPENDENCIES ${nodes})
  endif()
  _tws_live_test(${launch_file} ${arg_ALONE})
endfunction()

# A live test has a master of its own, and a processor: as many run at a time as there are. ctest starts first what may take longest.
function(_tws_live_test launch_file alone)
  string(REPLACE "/" "_" name ${launch_file})
  file(STRINGS ${PROJECT_SOURCE_DIR}/${launch_file} limit REGEX "time-limit=" LIMIT_COUNT 1)
  string(REGEX REPLACE ".*time-limit=\"([0-9]+).*" "\\1" seconds "${limit}")
  set_tests_properties(_ctest_${PROJECT_NAME}_rostest_${name} PROPERTIES COST "${seconds}" RUN_SERIAL ${alone})
endfunction()

# tws_benchmark(SOURCE... [LINK LIBRARY...])
# The package's benchmarks, where Google Benchmark is installed; made by the target `benchmarks`, not by `all`.
function(tws_benchmark)
  if(NOT TARGET benchmarks)
    add_custom_target(benchmarks)
  endif()
  find_package(benchmark QUIET)
  if(NOT benchmark_FOUND)
    return()
  endif()
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "" "LINK")
  add_executable(${PROJECT_NAME}_benchmark EXCLUDE_FROM_ALL ${arg_UNPARSED_ARGUMENTS})
  target_link_libraries(${PROJECT_NAME}_benchmark ${PROJECT_NAME} ${arg_LINK} benchmark::benchmark)
  add_dependencies(benchmarks ${PROJECT_NAME}_benchmark)
endfunction()
