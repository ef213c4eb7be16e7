# Makes one C++ file that holds the player's page: cmake -D FOLDER=... -D OUTPUT=... -P embed_player.cmake
#
# In player.html the style sheet's link and the script's tag are replaced by what they name. The script becomes one module: the modules are
# joined in the order below, each after those it imports from, and lose their import lines and the word export; and, since every page holds
# them, their indents and the lines that are comments. So an import or export must fit on a line, must not rename, and no two modules may
# have a name at their top level in common.
cmake_minimum_required(VERSION 3.25)

set(modules movie camera outline painter numbers timeline clock pointer player)

file(READ ${FOLDER}/player.html page)
file(READ ${FOLDER}/player.css style)
set(script "")
foreach(module IN LISTS modules)
    file(READ ${FOLDER}/${module}.js text)
    string(REGEX REPLACE "(^|\n)import [^\n]*" "\\1" text "${text}")
    string(REGEX REPLACE "(^|\n)export " "\\1" text "${text}")
    string(REGEX REPLACE "(^|\n) *//[^\n]*" "\\1" text "${text}")
    string(REGEX REPLACE "\n[\n ]+" "\n" text "${text}")
    string(APPEND script "${text}\n")
endforeach()
string(REPLACE "<link rel=\"stylesheet\" href=\"player.css\">" "<style>\n${style}</style>" page "${page}")
string(REPLACE "<script type=\"module\" src=\"player.js\"></script>" "<script type=\"module\">\n${script}</script>" page "${page}")
if(page MATCHES "player\\.(css|js)\"")
    message(FATAL_ERROR "player.html names its style sheet or its script in another way than embed_player.cmake looks for")
endif()

file(WRITE ${OUTPUT} "// Made by embed_player.cmake from tools/islet/player/.
namespace islet::tools {
extern const char player_source[];
const char player_source[] = R\"page(${page})page\";
}  // namespace islet::tools
")
