# SPDX-License-Identifier: GPL-3.0-or-later
# Writes POLICY: the hashes by which the page's Content-Security-Policy knows its own scripts.
#   PAGE page.html   SCRIPT, VIEWER what its places are filled with   POLICY where to write

# What a browser hashes is the text between the tags; hexadecimal digits become base64, six bits a sign.
function(hash_of TEXT RESULT)
  set(SIGNS "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/")
  string(SHA256 HEX "${TEXT}")
  set(BASE64 "")
  foreach(AT RANGE 0 60 6)
    string(SUBSTRING "${HEX}00" ${AT} 6 GROUP)
    foreach(SHIFT 18 12 6 0)
      math(EXPR INDEX "(0x${GROUP} >> ${SHIFT}) & 63")
      string(SUBSTRING "${SIGNS}" ${INDEX} 1 SIGN)
      string(APPEND BASE64 "${SIGN}")
    endforeach()
  endforeach()
  # 256 bits end four bits into the last but one of 44 signs.
  string(SUBSTRING "${BASE64}" 0 43 BASE64)
  set(${RESULT} "'sha256-${BASE64}='" PARENT_SCOPE)
endfunction()

file(READ "${PAGE}" HTML)
file(READ "${SCRIPT}" SCRIPT_TEXT)
file(READ "${VIEWER}" VIEWER_TEXT)
set(HASHES "")
while(HTML MATCHES "<script>([^<]*)</script>")
  set(TEXT "${CMAKE_MATCH_1}")
  string(FIND "${HTML}" "<script>${TEXT}</script>" AT)
  string(LENGTH "<script>${TEXT}</script>" LENGTH)
  math(EXPR AT "${AT} + ${LENGTH}")
  string(SUBSTRING "${HTML}" ${AT} -1 HTML)
  string(REPLACE "{{script}}" "${SCRIPT_TEXT}" TEXT "${TEXT}")
  string(REPLACE "{{viewer}}" "${VIEWER_TEXT}" TEXT "${TEXT}")
  hash_of("${TEXT}" HASH)
  list(APPEND HASHES "${HASH}")
endwhile()
list(JOIN HASHES " " HASHES)
file(WRITE "${POLICY}" "${HASHES}")
