// The scenes of the catalogue in a window: drag bodies, pause, step, and rewind.
//
//     window [SCENE]              starts with that scene
//     window --list               prints the scenes' names
//     window SCENE --frames N --picture FILE.bmp     shows N frames, writes the last one, and ends
//
// Every frame is one step.
#include <SDL.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <iomanip>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "harness/engine.hpp"
#include "painter.hpp"
#include "rollback/history.hpp"
#include "scenes/catalogue.hpp"

using namespace islet;
using namespace islet::samples;

namespace {

constexpr const char* keys =
    "left button drags, right button moves the camera, wheel zooms\n"
    "space: pause   right: one step   left: rewind   home: again   page up, page down: other scene   c: contacts   escape: end\n";
constexpr int frames_kept = 600;             // how far one can rewind
constexpr std::uint64_t drag_mark = 0xd7a6;  // user_data of the joint that drags
constexpr float drag_acceleration = 200;     // m/s^2, of a dragged body at most
constexpr Uint32 frame_milliseconds = 16;

struct Options {
    std::string scene = "pyramid";
    int frames = -1;  // -1: until the window is closed
    std::string picture;
};

/// A scene that runs, and the way back.
class Playground {
public:
    explicit Playground(const SceneInfo& info) : scene_(info.make()) {
        ++scene_.extra_joints;  // the one that drags
        engine_.load(scene_);
        // What a script remembers outside of the world does not go back with the world.
        if (!scene_.before_step) history_.emplace(capacity_of(scene_), frames_kept, rollback::Keep::deltas);
    }

    World& world() { return engine_.world(); }
    const Scene& scene() const { return scene_; }
    int steps() const { return step_; }
    bool has_script() const { return !history_; }

    void advance() {
        if (history_) history_->save(world(), step_);
        engine_.advance(scene_, step_, scene_.dt);
        ++step_;
    }

    void rewind() {
        if (step_ == 0 || !history_ || !history_->restore(world(), step_ - 1)) return;
        --step_;
        // The joint of a drag that ended since has come back too.
        for (std::uint32_t slot = 0; slot < world().capacity().joints; ++slot)
            if (const JointId joint = world().joint_at(slot); joint && world().user_data(joint) == drag_mark) world().destroy_joint(joint);
    }

    void grab(Vec2 point) {
        std::array<ShapeId, 16> found;
        const std::uint32_t count = std::min(world().overlap_point(point, found), std::uint32_t(found.size()));
        for (std::uint32_t i = 0; i < count; ++i) {
            const BodyId body = world().body(found[i]);
            if (world().type(body) != BodyType::dynamic) continue;
            drag_ =
                world().create_joint(MouseJointDef{.body = body, .target = point, .max_force = drag_acceleration * world().mass(body), .user_data = drag_mark});
            return;
        }
    }
    void drag_to(Vec2 point) {
        if (world().is_valid(drag_)) world().set_target(drag_, point);
    }
    void let_go() {
        if (world().is_valid(drag_)) world().destroy_joint(drag_);
        drag_ = {};
    }

private:
    Scene scene_;
    IsletEngine engine_;
    std::optional<rollback::History> history_;
    JointId drag_;
    int step_ = 0;
};

/// The window and what the keys and the mouse have set.
class Player {
public:
    explicit Player(const Options& options) : options_(options) {
        if (SDL_Init(SDL_INIT_VIDEO) != 0) throw std::runtime_error(SDL_GetError());
        window_ = SDL_CreateWindow("Islet", SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, 1280, 800, SDL_WINDOW_RESIZABLE);
        renderer_ = window_ != nullptr ? SDL_CreateRenderer(window_, -1, 0) : nullptr;
        if (renderer_ == nullptr) throw std::runtime_error(SDL_GetError());
        painter_.emplace(renderer_);
        for (std::size_t i = 0; i < catalogue().size(); ++i)
            if (catalogue()[i].name == options.scene) place_ = i;
        start();
    }
    ~Player() {
        SDL_DestroyRenderer(renderer_);
        SDL_DestroyWindow(window_);
        SDL_Quit();
    }
    Player(const Player&) = delete;
    Player& operator=(const Player&) = delete;

    void run() {
        for (int frame = 0; frame != options_.frames && !ended_; ++frame) {
            const Uint32 due = SDL_GetTicks() + frame_milliseconds;
            SDL_Event event;
            while (SDL_PollEvent(&event) != 0) handle(event);
            const bool rewinds = SDL_GetKeyboardState(nullptr)[SDL_SCANCODE_LEFT] != 0;
            if (rewinds)
                playground_->rewind();
            else if (!paused_ || single_step_)
                playground_->advance();
            single_step_ = false;
            draw();
            // Read before it is shown: what the renderer holds afterwards is not said.
            if (frame + 1 == options_.frames && !options_.picture.empty()) write_picture();
            SDL_RenderPresent(renderer_);
            if (const Uint32 now = SDL_GetTicks(); now < due) SDL_Delay(due - now);
        }
        std::cout << catalogue()[place_].name << ": " << playground_->steps() << " steps, hash " << std::hex << std::setw(16) << std::setfill('0')
                  << playground_->world().hash() << '\n';
    }

private:
    void start() {
        playground_ = std::make_unique<Playground>(catalogue()[place_]);
        fit_window();
        camera_.show(playground_->scene().view);
        std::cout << catalogue()[place_].name << ": " << catalogue()[place_].description << '\n';
    }

    void change_scene(int by) {
        const std::size_t count = catalogue().size();
        place_ = (place_ + count + std::size_t(by)) % count;
        start();
    }

    void fit_window() { SDL_GetRendererOutputSize(renderer_, &camera_.width, &camera_.height); }

    void handle(const SDL_Event& event) {
        switch (event.type) {
            case SDL_QUIT: ended_ = true; break;
            case SDL_KEYDOWN: handle_key(event.key.keysym.sym); break;
            case SDL_MOUSEBUTTONDOWN:
                if (event.button.button == SDL_BUTTON_LEFT) playground_->grab(camera_.to_world(float(event.button.x), float(event.button.y)));
                break;
            case SDL_MOUSEBUTTONUP:
                if (event.button.button == SDL_BUTTON_LEFT) playground_->let_go();
                break;
            case SDL_MOUSEMOTION:
                playground_->drag_to(camera_.to_world(float(event.motion.x), float(event.motion.y)));
                if ((event.motion.state & SDL_BUTTON_RMASK) != 0)
                    camera_.center = camera_.center + (1 / camera_.scale) * Vec2{-float(event.motion.xrel), float(event.motion.yrel)};
                break;
            case SDL_MOUSEWHEEL: {
                int x = 0, y = 0;
                SDL_GetMouseState(&x, &y);
                camera_.zoom(event.wheel.y > 0 ? 1.1f : 1 / 1.1f, float(x), float(y));
                break;
            }
            default: break;
        }
    }

    void handle_key(SDL_Keycode key) {
        switch (key) {
            case SDLK_SPACE: paused_ = !paused_; break;
            case SDLK_RIGHT: paused_ = single_step_ = true; break;
            case SDLK_HOME: change_scene(0); break;
            case SDLK_PAGEUP: change_scene(-1); break;
            case SDLK_PAGEDOWN: change_scene(1); break;
            case SDLK_c: shows_contacts_ = !shows_contacts_; break;
            case SDLK_ESCAPE: ended_ = true; break;
            default: break;
        }
    }

    void draw() {
        fit_window();
        SDL_SetRenderDrawColor(renderer_, 255, 255, 255, 255);
        SDL_RenderClear(renderer_);
        DebugDraw options = painter_->debug_draw(camera_);
        options.contacts = options.normals = shows_contacts_;
        playground_->world().draw(options);
        const std::string title = std::string(catalogue()[place_].name) + " - step " + std::to_string(playground_->steps()) + (paused_ ? ", paused" : "") +
                                  (playground_->has_script() ? ", has a script: no rewinding" : "");
        SDL_SetWindowTitle(window_, title.c_str());
    }

    void write_picture() {
        SDL_Surface* surface = SDL_CreateRGBSurfaceWithFormat(0, camera_.width, camera_.height, 32, SDL_PIXELFORMAT_ARGB8888);
        const bool written = surface != nullptr && SDL_RenderReadPixels(renderer_, nullptr, SDL_PIXELFORMAT_ARGB8888, surface->pixels, surface->pitch) == 0 &&
                             SDL_SaveBMP(surface, options_.picture.c_str()) == 0;
        SDL_FreeSurface(surface);
        if (!written) throw std::runtime_error(options_.picture + ": " + SDL_GetError());
    }

    Options options_;
    SDL_Window* window_ = nullptr;
    SDL_Renderer* renderer_ = nullptr;
    std::optional<Painter> painter_;
    Camera camera_;
    std::size_t place_ = 0;
    std::unique_ptr<Playground> playground_;
    bool paused_ = false, single_step_ = false, shows_contacts_ = false, ended_ = false;
};

int frames_of(const std::string& text) {
    int frames = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), frames);
    if (error != std::errc() || end != text.data() + text.size() || frames < 1) throw std::invalid_argument("--frames takes a number from 1 on, not " + text);
    return frames;
}

/// Throws std::invalid_argument with a sentence if the arguments are wrong.
Options options_of(int count, char** arguments) {
    Options options;
    for (int i = 1; i < count; ++i) {
        const std::string argument = arguments[i];
        const bool has_value = i + 1 < count;
        if (argument == "--frames" && has_value)
            options.frames = frames_of(arguments[++i]);
        else if (argument == "--picture" && has_value)
            options.picture = arguments[++i];
        else if (find_scene(argument) != nullptr)
            options.scene = argument;
        else
            throw std::invalid_argument(argument + " is no scene and no option; --list prints the scenes");
    }
    return options;
}

}  // namespace

int main(int count, char** arguments) {
    if (count == 2 && std::strcmp(arguments[1], "--list") == 0) {
        for (const SceneInfo& info : catalogue()) std::cout << info.name << ": " << info.description << '\n';
        return 0;
    }
    try {
        const Options options = options_of(count, arguments);
        std::cout << keys;
        Player(options).run();
    } catch (const std::exception& error) {
        std::cerr << "window: " << error.what() << '\n';
        return 2;
    }
    return 0;
}
