# The install script: all PARTS in the order of sql/order.txt.  An object planted beforehand must make
# the install fail, so OR REPLACE is taken out.  A file that begins with a table of :"model" is a template,
# which psql runs too: it becomes rows of streetgen.template.  One that begins with --{ holds pieces of
# statements.  The hash of the script is the mark of the build, which it and the module (HEADER) both carry.
set(script "\\echo Use \"CREATE EXTENSION streetgen CASCADE\" to load this file. \\quit\n")
foreach(part IN LISTS PARTS)
  file(READ ${part} text)
  if(text MATCHES "^(--[^\n]*\n)+\nCREATE TABLE :\"model\"")
    string(REGEX MATCH "/sql/(subject/)?([a-z_]+)/([a-z_]+/)?([a-z_]+)\\.sql$" path ${part})
    set(text "SELECT streetgen._take_template('${CMAKE_MATCH_2}', '${CMAKE_MATCH_4}', $template$${text}$template$);\n")
  elseif(text MATCHES "^(--[^\n]*\n)+\n--{")
    set(text "SELECT streetgen._take_parts($template$${text}$template$);\n")
  endif()
  string(REPLACE "CREATE OR REPLACE FUNCTION streetgen." "CREATE FUNCTION streetgen." text "${text}")
  string(APPEND script "\n${text}")
endforeach()
string(SHA256 mark "${script}")
string(SUBSTRING ${mark} 0 16 mark)
string(REPLACE "{build_mark}" ${mark} script "${script}")
file(WRITE ${OUT} "${script}")
file(WRITE ${HEADER} "#define STREETGEN_BUILD_MARK \"${mark}\"\n")
