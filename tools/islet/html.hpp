// A run as one HTML page that plays it back: no other file and no network needed.
#pragma once

#include <string>

#include "movie_maker.hpp"

namespace islet::tools {

/// The page: the player (player/) around the movie.
std::string player_page(const Run& run, const RunResult& result, const MovieMaker& movie);

/// Binary data as text, as in RFC 4648.
std::string base64(const std::string& bytes);

}  // namespace islet::tools
