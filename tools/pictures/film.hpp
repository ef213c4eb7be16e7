// A picture in SVG that moves: what the bodies of a world do, as key frames of a style sheet. No script; readers who want no motion see the first moment.
#pragma once

#include <string>
#include <vector>

#include "sketch.hpp"

namespace islet::pictures {

class Film {
public:
    /// Shows `seconds` of the world in a loop, which fades in and out.
    Film(const World& world, const Camera& camera, int width, int height, float seconds);

    /// Remembers where the bodies are. Call it once before the first step and after each step.
    void shoot(const World& world);
    std::string svg() const;

private:
    struct Pose {
        float x, y;   // px
        float angle;  // rad, clockwise, without jumps
    };
    struct Body {
        std::string outline;
        bool moves;
        std::vector<Pose> poses;  // by frame
    };

    std::string key_frames(const Body& body) const;
    std::vector<std::size_t> kept(const Body& body) const;

    Camera camera_;
    int width_, height_;
    float seconds_;
    std::vector<Body> bodies_;  // by slot
};

/// The film that README.md opens with: a car crosses a bridge and jumps into a pyramid, which a ball on a chain hits too.
std::string opening_film();

}  // namespace islet::pictures
