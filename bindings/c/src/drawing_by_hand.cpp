// Drawing: functions of C in place of those of C++.
#include "glue.hpp"

namespace islet::c {

namespace {

const IsletDrawStyle* c_style(const DrawStyle& style) { return cast<const IsletDrawStyle>(&style); }
const DebugDraw& user(void* context) { return *static_cast<const DebugDraw*>(context); }

void draw_polygon(span<const Vec2> corners, float radius, const DrawStyle& style, void* context) {
    using Function = void (*)(const IsletVec2*, std::size_t, float, const IsletDrawStyle*, void*);
    function<Function>(user(context).polygon)(cast<const IsletVec2>(corners.data()), corners.size(), radius, c_style(style), user(context).context);
}
void draw_circle(Vec2 center, float radius, Vec2 axis, const DrawStyle& style, void* context) {
    using Function = void (*)(IsletVec2, float, IsletVec2, const IsletDrawStyle*, void*);
    function<Function>(user(context).circle)(out(center), radius, out(axis), c_style(style), user(context).context);
}
void draw_capsule(Vec2 point1, Vec2 point2, float radius, const DrawStyle& style, void* context) {
    using Function = void (*)(IsletVec2, IsletVec2, float, const IsletDrawStyle*, void*);
    function<Function>(user(context).capsule)(out(point1), out(point2), radius, c_style(style), user(context).context);
}
void draw_segment(Vec2 point1, Vec2 point2, const DrawStyle& style, void* context) {
    using Function = void (*)(IsletVec2, IsletVec2, const IsletDrawStyle*, void*);
    function<Function>(user(context).segment)(out(point1), out(point2), c_style(style), user(context).context);
}
void draw_point(Vec2 point, const DrawStyle& style, void* context) {
    using Function = void (*)(IsletVec2, const IsletDrawStyle*, void*);
    function<Function>(user(context).point)(out(point), c_style(style), user(context).context);
}
void draw_text(Vec2 point, const char* text, const DrawStyle& style, void* context) {
    using Function = void (*)(IsletVec2, const char*, const IsletDrawStyle*, void*);
    function<Function>(user(context).text)(out(point), text, c_style(style), user(context).context);
}

}  // namespace

Drawing::Drawing(const DebugDraw& of_c) : given(of_c), functions(of_c) {
    functions.context = &given;
    if (given.polygon != nullptr) functions.polygon = draw_polygon;
    if (given.circle != nullptr) functions.circle = draw_circle;
    if (given.capsule != nullptr) functions.capsule = draw_capsule;
    if (given.segment != nullptr) functions.segment = draw_segment;
    if (given.point != nullptr) functions.point = draw_point;
    if (given.text != nullptr) functions.text = draw_text;
}

}  // namespace islet::c
