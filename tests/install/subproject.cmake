# The source as a subproject, as a shared library (which shows that all that is public is exported), then that
# library installed and found. Unoptimised: this is about linking.
include(${CMAKE_CURRENT_LIST_DIR}/consume.cmake)
set(prefix ${SCRATCH}/prefix)
file(REMOVE_RECURSE ${SCRATCH}/installed ${prefix})

set(debug -DCMAKE_BUILD_TYPE=Debug)
consume(${SCRATCH}/build ${debug} -DCDFR_SOURCE=${SOURCE} -DBUILD_SHARED_LIBS=ON -DCDFR_INSTALL=ON
  "-DCMAKE_CXX_FLAGS_DEBUG=-O0")
run("install" ${CMAKE_COMMAND} --install ${SCRATCH}/build --prefix ${prefix})

foreach(package IN ITEMS Eigen3 nlohmann_json FastFloat TBB HWY PNG PkgConfig)
  list(APPEND unneeded -DCMAKE_DISABLE_FIND_PACKAGE_${package}=ON)
endforeach()
consume(${SCRATCH}/installed ${debug} -DCMAKE_PREFIX_PATH=${prefix} ${unneeded})
