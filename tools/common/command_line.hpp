// What the programs share that a person starts: their version, choices by name, and what is said of a command line that is wrong.
#pragma once

#include <algorithm>
#include <iostream>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include "islet/version.hpp"
#include "scene_files/near_names.hpp"
#include "scene_files/printable.hpp"

namespace islet::tools {

/// An option whose value is one of a few names. Help lists them, and so does what is said of another word.
template <class Target, class Enum>
CLI::Option* add_choice(CLI::App& app, const char* name, Target& target, const std::map<std::string, Enum>& choices,
                        const char* description) {
    std::vector<std::string> names;
    for (const auto& choice : choices) names.push_back(choice.first);
    return app
        .add_option_function<std::string>(
            name, [&target, choices](const std::string& chosen) { target = choices.at(chosen); }, description)
        ->check(CLI::IsMember(names));
}

/// A check of file names.
inline std::string not_empty(const std::string& name) { return name.empty() ? "needs the name of a file" : std::string(); }

/// What the words of a command line that are no command or option may have been meant for; empty if nothing is near.
inline std::string suggestion(const CLI::App& app, int argc, const char* const* argv) {
    const CLI::App* command = &app;
    std::vector<std::string> names;
    const auto look_up = [&](const char* what, const std::string& word) {
        const std::vector<std::string> near = samples::near_names(word, names);
        return near.empty() ? std::string()
                            : fmt::format("there is no {} '{}'; near names: {}", what, samples::printable(word), fmt::join(near, ", "));
    };
    int first = 1;
    const std::vector<const CLI::App*> commands = app.get_subcommands([](const CLI::App*) { return true; });
    if (!commands.empty() && argc > 1 && argv[1][0] != '-') {
        for (const CLI::App* other : commands) {
            names.push_back(other->get_name());
            if (other->get_name() == argv[1]) command = other;
        }
        if (command == &app) return look_up("command", argv[1]);
        first = 2;
    }
    names = {"--help"};
    if (command == &app) names.emplace_back("--version");
    for (const CLI::Option* option : command->get_options())
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (int i = first; i < argc; ++i) {
        const std::string word(argv[i]), name = word.substr(0, word.find('='));
        if (!name.starts_with("--") || std::find(names.begin(), names.end(), name) != names.end()) continue;
        if (const std::string found = look_up("option", name); !found.empty()) return found;
    }
    return {};
}

/// Takes the command line in. The exit status, after a message, if that is all there is to do: help or the version was asked for, or it is wrong.
inline std::optional<int> parse_or_explain(CLI::App& app, int argc, const char* const* argv, const char* program) {
    constexpr int wrong_usage = 2;
    app.set_version_flag("--version", fmt::format("{} {}", program, ISLET_VERSION_STRING), "print the version and exit");
    try {
        app.parse(argc, argv);
        return std::nullopt;
    } catch (const CLI::Success& asked) { return app.exit(asked); } catch (const CLI::ParseError& error) {
        const auto is = [&error](CLI::ExitCodes code) { return error.get_exit_code() == static_cast<int>(code); };
        const bool is_name = is(CLI::ExitCodes::ExtrasError) || is(CLI::ExitCodes::RequiredError);
        if (argc <= 1) std::cerr << app.help() << "\n";
        const std::string near = is_name ? suggestion(app, argc, argv) : std::string();
        std::cerr << fmt::format("{}: {}\nRun with --help for more information.\n", program, near.empty() ? samples::printable(error.what()) : near);
        return wrong_usage;
    }
}

}  // namespace islet::tools
