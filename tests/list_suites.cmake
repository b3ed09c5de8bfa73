# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
#
# cmake -D PROGRAM=... -D OUTPUT=... -P list_suites.cmake
# Writes a file for ctest with one test for each suite of a GoogleTest program.

execute_process(COMMAND ${PROGRAM} --gtest_list_tests OUTPUT_VARIABLE LIST
                COMMAND_ERROR_IS_FATAL ANY)
# A suite begins a line and ends in a point; its cases are indented.
string(REGEX MATCHALL "\n[A-Za-z0-9_/]+\\." SUITES "\n${LIST}")
if(NOT SUITES)
  message(FATAL_ERROR "${PROGRAM} has no tests")
endif()

# What a program prints last if no case failed and one was skipped: ctest then says so.
set(SKIPPED [==[\[  PASSED  \] [0-9]+ tests?\.
\[  SKIPPED \] [0-9]+ tests?, listed below:
(\[  SKIPPED \] [^
]*
)+$]==])

get_filename_component(ROOM ${PROGRAM} NAME)
string(REGEX REPLACE "_test$" "" ROOM ${ROOM})
set(TEXT "")
foreach(SUITE IN LISTS SUITES)
  string(REGEX REPLACE "\n|\\." "" SUITE ${SUITE})
  set(NAME "${ROOM}.${SUITE}")
  string(APPEND TEXT "add_test([==[${NAME}]==] [==[${PROGRAM}]==] [==[--gtest_filter=${SUITE}.*]==])\n"
                     "set_tests_properties([==[${NAME}]==] PROPERTIES SKIP_REGULAR_EXPRESSION "
                     "[==[${SKIPPED}]==])\n")
endforeach()
file(WRITE ${OUTPUT} "${TEXT}")
