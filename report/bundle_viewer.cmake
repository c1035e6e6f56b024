# SPDX-License-Identifier: GPL-3.0-or-later
# Bundles the 3-D view into BUILT/viewer.bundle.js. Without npm, or when its packages cannot be had,
# the bundle is empty, and the build goes on unless the view is NEEDED.
#   PAGE folder of the sources   BUILT build folder   NPM, NODE programs   BUNDLED whether to try at all
#   NEEDED whether to fail without it   TESTS whether to get the packages of the page's test, too
set(BUNDLE "${BUILT}/viewer.bundle.js")

function(leave_out WHY)
  if(NEEDED)
    file(REMOVE "${BUNDLE}")
    message(FATAL_ERROR "The 3-D view of report.html cannot be built: ${WHY}")
  endif()
  message("The 3-D view of report.html is left out: ${WHY}")
  file(WRITE "${BUNDLE}" "")
endfunction()

if(NOT BUNDLED)
  leave_out("LATTICAST_VIEWER is OFF.")
  return()
endif()
if(NOT NPM OR NOT NODE)
  leave_out("there is no npm. Install npm, then configure again.")
  return()
endif()

# npm works in the build folder: the source tree stays as it is.
set(WORK "${BUILT}/npm")
file(MAKE_DIRECTORY "${WORK}")
file(COPY "${PAGE}/package.json" "${PAGE}/package-lock.json" DESTINATION "${WORK}")
file(GLOB VIEWER_SOURCES "${PAGE}/viewer*.js")
file(COPY ${VIEWER_SOURCES} DESTINATION "${WORK}")
set(OMIT --omit=dev)
if(TESTS)
  set(OMIT)
endif()
execute_process(
  COMMAND "${NPM}" ci ${OMIT} --ignore-scripts --no-audit --no-fund --prefer-offline --loglevel=error
          --fetch-retries=2 --fetch-retry-mintimeout=1000 --fetch-retry-maxtimeout=4000
  WORKING_DIRECTORY "${WORK}" TIMEOUT 300
  RESULT_VARIABLE STATUS OUTPUT_QUIET ERROR_VARIABLE ERRORS)
if(NOT STATUS EQUAL 0)
  string(REGEX MATCH "[^\n]*" FIRST_ERROR "${ERRORS}")
  leave_out("npm ci failed (${STATUS}: ${FIRST_ERROR}). Configure again to retry.")
  return()
endif()
# three.js names its licence in one line; the licence itself asks for all of its text.
file(READ "${WORK}/node_modules/three/LICENSE" LICENCE)
execute_process(
  COMMAND "${NODE}" node_modules/esbuild/bin/esbuild viewer.js --bundle --minify --format=iife
          --target=es2020 --charset=utf8 --legal-comments=inline --log-level=warning
          "--banner:js=/*! three.js\n\n${LICENCE}*/" "--outfile=${BUNDLE}"
  WORKING_DIRECTORY "${WORK}" TIMEOUT 100
  RESULT_VARIABLE STATUS ERROR_VARIABLE ERRORS)
if(NOT STATUS EQUAL 0)
  leave_out("esbuild failed (${STATUS}).\n${ERRORS}")
endif()
