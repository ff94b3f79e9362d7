# The library as it was built, installed into an empty prefix and found there. What only the library's own sources
# include must not be asked of its users.
include(${CMAKE_CURRENT_LIST_DIR}/consume.cmake)
set(prefix ${SCRATCH}/prefix)
file(REMOVE_RECURSE ${SCRATCH})

run("install" ${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix})
expect_file(${prefix}/bin/cdfr)
expect_file(${prefix}/include/cdfr/field/field.h)
run("the installed command" ${prefix}/bin/cdfr --version)

foreach(package IN ITEMS Eigen3 nlohmann_json FastFloat CLI11 GTest benchmark)
  list(APPEND unneeded -DCMAKE_DISABLE_FIND_PACKAGE_${package}=ON)
endforeach()
consume(${SCRATCH}/build -DCMAKE_PREFIX_PATH=${prefix} ${unneeded})

# Until 1.0 a minor version may break: another one is not accepted.
file(WRITE ${SCRATCH}/newer/CMakeLists.txt
  "cmake_minimum_required(VERSION 3.25)\nproject(newer LANGUAGES CXX)\nfind_package(cdfr 0.2 REQUIRED)\n")
execute_process(COMMAND ${CMAKE_COMMAND} -S ${SCRATCH}/newer -B ${SCRATCH}/newer/build -G ${GENERATOR}
    -DCMAKE_PREFIX_PATH=${prefix} RESULT_VARIABLE status OUTPUT_QUIET ERROR_QUIET)
if(status EQUAL 0)
  message(FATAL_ERROR "version 0.1 was taken for 0.2")
endif()
