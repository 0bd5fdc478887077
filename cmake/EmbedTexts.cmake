# cmake -D OUTPUT=x.cc -D NAMESPACE=a::b -D FILES="page.html;page.css" -P EmbedTexts.cmake
#
# Writes a C++ file that contains the texts of files as constants: kPageHtml, kPageCss.
set(text "#include <string_view>\n\nnamespace ${NAMESPACE} {\n\n")
foreach(file IN LISTS FILES)
  cmake_path(GET file FILENAME name)
  string(REPLACE "." ";" words "${name}")
  set(constant k)
  foreach(word IN LISTS words)
    string(SUBSTRING "${word}" 0 1 first)
    string(SUBSTRING "${word}" 1 -1 rest)
    string(TOUPPER "${first}" first)
    string(APPEND constant "${first}${rest}")
  endforeach()
  file(READ "${file}" content)
  string(APPEND text "extern const std::string_view ${constant};\n"
    "const std::string_view ${constant} = R\"embedded(${content})embedded\";\n\n")
endforeach()
string(APPEND text "}  // namespace ${NAMESPACE}\n")
file(WRITE "${OUTPUT}" "${text}")
