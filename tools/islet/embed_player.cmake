# Makes one C++ file that holds the player's page: cmake -D FOLDER=... -D BUNDLE=... -D OUTPUT=... -P embed_player.cmake
#
# In player.html the style sheet's link and the script's tag are replaced by what esbuild made of these and of what they import: BUNDLE.css and BUNDLE.js.
cmake_minimum_required(VERSION 3.25)

file(READ ${FOLDER}/player.html page)
file(READ ${BUNDLE}.css style)
file(READ ${BUNDLE}.js script)
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
