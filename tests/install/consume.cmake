# Steps that both ways share; each ends the test if it fails.
function(run what)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE text ERROR_VARIABLE text)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${what} failed (${status}):\n${text}")
  endif()
  message(STATUS "${what}: done")
endfunction()

# Configures, builds and runs the consumer in the folder; further arguments go to the configuration.
function(consume folder)
  run("configure ${folder}" ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/consumer -B ${folder}
    -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${COMPILER} ${ARGN})
  run("build ${folder}" ${CMAKE_COMMAND} --build ${folder})
  run("run ${folder}" ${folder}/consumer)
endfunction()

function(expect_file path)
  if(NOT EXISTS ${path})
    message(FATAL_ERROR "not installed: ${path}")
  endif()
endfunction()
