// A display of 128x64 dots (SSD1306, I2C address 0x3c), and a painter that draws a world on it. The painter is what DebugDraw asks for: functions for
// polygons, circles, capsules and lines. Another display needs another show(); a larger one another width and height.
//
// Every machine draws the same dots: no sum of products is rounded in two ways, since the compiler of some boards fuses them.
#pragma once

#include <Wire.h>
#include <islet.hpp>

struct Display {
    static constexpr int width = 128, height = 64;
    static constexpr float scale = 10;  // dots a metre; the world's origin is the lower left corner

    uint8_t dots[width * height / 8];

    void begin() {
        static const uint8_t commands[] = {0xae, 0xd5, 0x80, 0xa8, 0x3f, 0xd3, 0x00, 0x40, 0x8d, 0x14, 0x20, 0x00, 0xa1,
                                           0xc8, 0xda, 0x12, 0x81, 0xcf, 0xd9, 0xf1, 0xdb, 0x40, 0xa4, 0xa6, 0xaf};
        send(0x00, commands, sizeof commands);
    }

    /// Sends the dots to the display.
    void show() {
        static const uint8_t window[] = {0x21, 0, width - 1, 0x22, 0, height / 8 - 1};
        send(0x00, window, sizeof window);
        for (unsigned i = 0; i < sizeof dots; i += 16) send(0x40, dots + i, 16);
    }

    void clear() { memset(dots, 0, sizeof dots); }

    void dot(int x, int y) {
        if (x >= 0 && x < width && y >= 0 && y < height) dots[y / 8 * width + x] |= uint8_t(1 << y % 8);
    }

    // Bresenham's line and circle.
    void line(int x0, int y0, int x1, int y1) {
        const int dx = abs(x1 - x0), dy = -abs(y1 - y0), sx = x0 < x1 ? 1 : -1, sy = y0 < y1 ? 1 : -1;
        for (int error = dx + dy;;) {
            dot(x0, y0);
            if (x0 == x1 && y0 == y1) return;
            const int twice = 2 * error;
            if (twice >= dy) error += dy, x0 += sx;
            if (twice <= dx) error += dx, y0 += sy;
        }
    }
    void circle(int x0, int y0, int radius) {
        for (int x = radius, y = 0, error = 1 - radius; y <= x;) {
            for (int side = 0; side < 4; ++side) {
                const int sx = side & 1 ? -1 : 1, sy = side & 2 ? -1 : 1;
                dot(x0 + sx * x, y0 + sy * y);
                dot(x0 + sx * y, y0 + sy * x);
            }
            ++y;
            if (error >= 0) --x;
            error += error < 0 ? 2 * y + 1 : 2 * (y - x) + 1;
        }
    }

    /// Metres as dots, from the left and from the top. What is far outside stays just outside.
    static int dots_of(float metres) {
        const float d = metres * scale;
        return d > 1000 ? 1000 : d < -1000 ? -1000 : int(d < 0 ? d - 0.5f : d + 0.5f);
    }
    static int x_of(islet::Vec2 p) { return dots_of(p.x); }
    static int y_of(islet::Vec2 p) { return height - 1 - dots_of(p.y); }
    void line(islet::Vec2 a, islet::Vec2 b) { line(x_of(a), y_of(a), x_of(b), y_of(b)); }

private:
    static void send(uint8_t kind, const uint8_t* bytes, unsigned count) {
        Wire.beginTransmission(0x3c);
        Wire.write(kind);
        for (unsigned i = 0; i < count; ++i) Wire.write(bytes[i]);
        Wire.endTransmission();
    }
};

/// What World::draw needs to draw on the display.
inline islet::DebugDraw painter(Display& display) {
    using namespace islet;
    static const auto display_of = [](void* context) -> Display& { return *static_cast<Display*>(context); };
    DebugDraw draw;
    draw.context = &display;
    draw.polygon = [](span<const Vec2> corners, float, const DrawStyle&, void* context) {
        for (size_t i = 0; i < corners.size(); ++i) display_of(context).line(corners[i], corners[i + 1 < corners.size() ? i + 1 : 0]);
    };
    draw.circle = [](Vec2 center, float radius, Vec2 axis, const DrawStyle&, void* context) {
        Display& d = display_of(context);
        const int x = d.x_of(center), y = d.y_of(center);
        d.circle(x, y, d.dots_of(radius));
        d.line(x, y, x + d.dots_of(radius * axis.x), y - d.dots_of(radius * axis.y));
    };
    draw.capsule = [](Vec2 point1, Vec2 point2, float radius, const DrawStyle&, void* context) {
        Display& d = display_of(context);
        const Vec2 along = point2 - point1;
        const float share = radius / length(along);
        const int x = d.dots_of(-along.y * share), y = -d.dots_of(along.x * share);  // from the axis to the side
        for (const Vec2 p : {point1, point2}) d.circle(d.x_of(p), d.y_of(p), d.dots_of(radius));
        for (const int side : {-1, 1}) d.line(d.x_of(point1) + side * x, d.y_of(point1) + side * y, d.x_of(point2) + side * x, d.y_of(point2) + side * y);
    };
    draw.segment = [](Vec2 point1, Vec2 point2, const DrawStyle&, void* context) { display_of(context).line(point1, point2); };
    return draw;
}
