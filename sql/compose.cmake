# The install script: all once-files, all again-files folder by folder, and the end.  An object
# planted beforehand must make the install fail, so OR REPLACE is taken out.
set(script "\\echo Use \"CREATE EXTENSION streetgen CASCADE\" to load this file. \\quit\n")
foreach(part IN LISTS ONCE AGAIN)
  file(READ ${part} text)
  string(REPLACE "CREATE OR REPLACE FUNCTION streetgen." "CREATE FUNCTION streetgen." text "${text}")
  string(APPEND script "\n${text}")
endforeach()
file(WRITE ${OUT} "${script}")
