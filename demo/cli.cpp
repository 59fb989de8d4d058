// SPDX-License-Identifier: MIT
#include "demo/cli.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "demo/argument_names.h"
#include "demo/arguments.h"
#include "demo/chip_table.h"
#include "demo/command_bench.h"
#include "demo/command_dump.h"
#include "demo/command_emit.h"
#include "demo/command_metrics.h"
#include "demo/command_plan.h"
#include "demo/command_profiles.h"
#include "demo/command_render.h"
#include "demo/command_requires.h"
#include "demo/command_scenes.h"
#include "demo/command_tradeoff.h"
#include "demo/command_vectors.h"
#include "demo/standard_output.h"
#include "pipeline/frame/frame_fields.h"

namespace demo {
namespace {

// The arguments as they are written; they are read only once the command line as a whole is known to be well formed.
struct Arguments {
    std::string scene, output, size, frames, frame, passes, threads, simd, statistics, profile, technique, mode, format,
        limit, runs, precision;
};

template <class Read>
auto optional_value(const std::string& text, bool is_given, Read&& read) {
    return is_given ? std::optional(read(text)) : std::nullopt;
}

std::string as_it_is(const std::string& text) {
    return text;
}

// CLI11 gives a flag its value only after '='; "--stats json" is to work as well.
std::vector<std::string> joined_statistics(int argc, const char* const* argv) {
    std::vector<std::string> arguments;
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        const bool is_format       = argument == "json" || argument == "text";
        if (is_format && !arguments.empty() && arguments.back() == "--stats") {
            arguments.back() += "=" + argument;
        } else {
            arguments.push_back(argument);
        }
    }
    return arguments;
}

CLI::App* add_render(CLI::App& app, Arguments& arguments) {
    CLI::App* command = app.add_subcommand("render", "Draw a scene and write it as an image file");
    command->add_option("SCENE", arguments.scene, "A built-in scene, a .toml file or a dumped frame")->required();
    command->add_option("-o,--output", arguments.output, "The image file; #### stands for the frame's number");
    command->add_option("--size", arguments.size, "WIDTHxHEIGHT in pixels");
    command->add_option("--frames", arguments.frames, "FIRST-LAST frame of the animation");
    command->add_option("--passes", arguments.passes, "A directory for pictures of each pass; #### as for -o");
    command->add_option("--threads", arguments.threads, "How many threads draw; 0 is all cores");
    command->add_option("--limit", arguments.limit, "Draw what takes up to N times the memory and filling allowed");
    command->add_option("--simd", arguments.simd, "The instruction set to draw with");
    command->add_flag("--stats{text}", arguments.statistics, "Print what each pass did: text or json");
    command->add_option("--profile", arguments.profile, "The chip to draw as: ideal, dx7, ps2, gamecube or xbox");
    command->add_flag("--fit")->description("Reduce picture and textures until they fit the chip");
    command->add_option("--technique", arguments.technique, "What draws the clouds: mega, sprites or slices");
    command->add_option("--mode", arguments.mode, "The clouds' rim: skirt, article, premultiplied or black");
    command->add_flag("--order-free")->description("Draw all else before the clouds");
    command->add_option("--precision", arguments.precision, "exact, or fast: less exact clouds in less time");
    command->callback([command, &arguments] {
        const auto is_given = [&](const char* name) { return command->count(name) > 0; };
        RenderOptions options;
        if (is_given("--profile")) {
            const pipeline::Profile& profile = parse_profile(arguments.profile);
            if (profile.name != "ideal") options.profile = &profile;
        }
        options.reduce = is_given("--fit");
        if (options.reduce && options.profile == nullptr)
            throw std::runtime_error("--fit: needs --profile with a chip to fit");
        options.scene            = arguments.scene;
        options.output           = optional_value(arguments.output, is_given("--output"), &as_it_is);
        options.size             = optional_value(arguments.size, is_given("--size"), &parse_size);
        options.frames           = optional_value(arguments.frames, is_given("--frames"), &parse_frames);
        options.passes_directory = optional_value(arguments.passes, is_given("--passes"), &as_it_is);
        options.simd_target      = arguments.simd;
        if (is_given("--limit")) options.limit = parse_number("--limit", arguments.limit, 1, kMaxLimit);
        if (is_given("--threads")) options.threads = parse_number("--threads", arguments.threads, 0, kMaxThreads);
        if (is_given("--stats")) options.statistics = parse_statistics(arguments.statistics);
        if (is_given("--technique")) options.changes.technique = parse_technique(arguments.technique);
        if (is_given("--mode")) options.changes.mode = parse_mode(arguments.mode);
        if (is_given("--order-free")) options.changes.order = cloud::Order::OrderFree;
        if (is_given("--precision")) options.changes.precision = parse_precision(arguments.precision);
        render(options);
    });
    return command;
}

CLI::App* add_dump(CLI::App& app, Arguments& arguments) {
    CLI::App* command = app.add_subcommand("dump", "Print one frame of a scene as text, which render takes back");
    command->add_option("SCENE", arguments.scene, "A built-in scene, a .toml file or a dumped frame")->required();
    command->add_option("-o,--output", arguments.output, "The file; standard output without");
    command->add_option("--size", arguments.size, "WIDTHxHEIGHT in pixels");
    command->add_option("--frame", arguments.frame, "Which frame of the animation");
    command->add_option("--precision", arguments.precision, "exact, or fast: less exact clouds in less time");
    command->callback([command, &arguments] {
        const auto is_given = [&](const char* name) { return command->count(name) > 0; };
        DumpOptions options;
        options.scene  = arguments.scene;
        options.output = optional_value(arguments.output, is_given("--output"), &as_it_is);
        options.size   = optional_value(arguments.size, is_given("--size"), &parse_size);
        if (is_given("--frame")) options.frame = parse_number("--frame", arguments.frame, 0, kMaxFrameNumber);
        if (is_given("--precision")) options.changes.precision = parse_precision(arguments.precision);
        dump(options);
    });
    return command;
}

void add_metrics(CLI::App& app, Arguments& arguments) {
    CLI::App* command = app.add_subcommand("metrics", "Measure a scene's clouds: edges, blur, halo, fill, look");
    command->add_option("SCENE", arguments.scene, "A built-in scene or a .toml file")->required();
    command->add_option("--size", arguments.size, "WIDTHxHEIGHT in pixels; 480x270 without");
    command->add_option("--frame", arguments.frame, "Which frame of the animation");
    command->add_option("--technique", arguments.technique, "What draws the clouds: mega, sprites or slices");
    CLI::Option* json   = command->add_flag("--json")->description("Print JSON in place of a table");
    CLI::Option* claims = command->add_flag("--claims")->description("Compare all techniques, as Markdown");
    claims->excludes(json)->excludes(command->get_option("--technique"));
    command->add_option("--precision", arguments.precision, "exact, or fast: less exact clouds in less time");
    command->callback([command, &arguments] {
        const auto is_given = [&](const char* name) { return command->count(name) > 0; };
        MetricsOptions options{.scene = arguments.scene};
        if (is_given("--size")) options.size = parse_size(arguments.size);
        if (is_given("--frame")) options.frame = parse_number("--frame", arguments.frame, 0, kMaxFrameNumber);
        if (is_given("--precision")) options.precision = parse_precision(arguments.precision);
        if (is_given("--technique")) options.technique = parse_technique(arguments.technique);
        if (is_given("--json")) options.format = MetricsFormat::Json;
        if (is_given("--claims")) options.format = MetricsFormat::Claims;
        report_metrics(options);
    });
}

void add_tradeoff(CLI::App& app, Arguments& arguments) {
    CLI::App* command = app.add_subcommand("tradeoff", "Measure what drawing a scene less exactly saves and errs");
    command->add_option("SCENE", arguments.scene, "A built-in scene or a .toml file")->required();
    command->add_option("-o,--output", arguments.output, "The directory for table, chart and page");
    command->add_flag("--table")->description("Print what is on the front, as Markdown");
    command->add_option("--size", arguments.size, "WIDTHxHEIGHT in pixels; 640x360 without");
    command->add_option("--frame", arguments.frame, "Which frame of the animation");
    command->add_option("--runs", arguments.runs, "How often each setting is timed; 7 without");
    command->add_option("--threads", arguments.threads, "How many threads draw; 1 without, 0 is all cores");
    command->callback([command, &arguments] {
        const auto is_given = [&](const char* name) { return command->count(name) > 0; };
        TradeoffOptions options{.scene = arguments.scene};
        options.directory    = optional_value(arguments.output, is_given("--output"), &as_it_is);
        options.prints_table = is_given("--table");
        SweepOptions& sweep  = options.sweep;
        if (is_given("--size")) sweep.size = parse_size(arguments.size);
        if (is_given("--frame")) sweep.frame = parse_number("--frame", arguments.frame, 0, kMaxFrameNumber);
        if (is_given("--runs")) sweep.runs = parse_number("--runs", arguments.runs, 1, kMaxRuns);
        if (is_given("--threads")) sweep.threads = parse_number("--threads", arguments.threads, 0, kMaxThreads);
        report_tradeoff(options);
    });
}

void add_plan(CLI::App& app, Arguments& arguments) {
    CLI::App* command = app.add_subcommand(
        "plan", "Say what a chip lacks for a frame, where it would lie in memory, what it would cost");
    command->add_option("SCENE", arguments.scene, "A built-in scene, a .toml file or a dumped frame")->required();
    command
        ->add_option("--profile", arguments.profile, "The chip: dx7, ps2, gamecube or xbox; all: a table of the four")
        ->required();
    command->add_option("--size", arguments.size, "WIDTHxHEIGHT in pixels");
    command->add_option("--frame", arguments.frame, "Which frame of the animation");
    command->add_option("--format", arguments.format, "text or json");
    command->add_flag("--fit")->description("Reduce picture and textures until they fit the chip");
    command->add_flag("--words")->description("Also the passes in the chip's own words, without vertices");
    command->add_option("--precision", arguments.precision, "exact, or fast: less exact clouds in less time");
    command->callback([command, &arguments] {
        const auto is_given = [&](const char* name) { return command->count(name) > 0; };
        PlanOptions options;
        if (is_given("--precision")) options.changes.precision = parse_precision(arguments.precision);
        const bool is_table = arguments.profile == "all";
        options.reduce      = is_given("--fit");
        options.scene       = arguments.scene;
        options.size        = optional_value(arguments.size, is_given("--size"), &parse_size);
        if (is_given("--frame")) options.frame = parse_number("--frame", arguments.frame, 0, kMaxFrameNumber);
        if (is_table) {
            if (is_given("--format")) throw std::runtime_error("--format: the table of all chips is Markdown");
            return print(chip_table(options));
        }
        options.profile    = &parse_profile(arguments.profile);
        options.with_words = is_given("--words");
        if (is_given("--format")) options.format = parse_plan_format(arguments.format);
        if (options.with_words && options.format != PlanFormat::Text)
            throw std::runtime_error("--words: stand in the text alone");
        report_plan(options);
    });
}

void add_requires(CLI::App& app, Arguments& arguments) {
    CLI::App* command = app.add_subcommand("requires", "List what a scene needs: states, formats, kernels, memory");
    command->add_option("SCENE", arguments.scene, "A built-in scene, a .toml file or a dumped frame")->required();
    command->add_option("--profile", arguments.profile,
                        "For a chip: dx7, ps2, gamecube or xbox; all: ideal and the four");
    command->add_option("--size", arguments.size, "WIDTHxHEIGHT in pixels");
    CLI::Option* frame = command->add_option("--frame", arguments.frame, "Which frame of the animation");
    command->add_option("--frames", arguments.frames, "FIRST-LAST frame of the animation, taken together")
        ->excludes(frame);
    command->add_option("--format", arguments.format, "text or json");
    command->callback([command, &arguments] {
        const auto is_given = [&](const char* name) { return command->count(name) > 0; };
        RequiresOptions options{.scene = arguments.scene};
        options.profiles = parse_profiles(is_given("--profile") ? arguments.profile : "ideal");
        options.size     = optional_value(arguments.size, is_given("--size"), &parse_size);
        if (is_given("--frames")) options.frames = parse_frames(arguments.frames);
        if (is_given("--frame"))
            options.frames.first = options.frames.last = parse_number("--frame", arguments.frame, 0, kMaxFrameNumber);
        if (is_given("--format") && parse_plan_format(arguments.format) == PlanFormat::Json)
            options.format = RequiresFormat::Json;
        report_requirements(options);
    });
}

CLI::App* add_emit(CLI::App& app, Arguments& arguments) {
    CLI::App* command = app.add_subcommand(
        "emit", "Write a frame in a chip's own words: registers, methods, or a program of API calls");
    command->add_option("SCENE", arguments.scene, "A built-in scene, a .toml file or a dumped frame")->required();
    command->add_option("--profile", arguments.profile, "The chip: dx7, ps2, gamecube or xbox")->required();
    command->add_option("-o,--output", arguments.output, "The file; data goes beside it, with .bin for its ending");
    command->add_option("--size", arguments.size, "WIDTHxHEIGHT in pixels");
    command->add_option("--frame", arguments.frame, "Which frame of the animation");
    command->add_flag("--fit")->description("Reduce picture and textures until they fit the chip");
    command->add_flag("--text")->description("ps2: registers and their meaning to read, not a dump to replay");
    command->add_option("--precision", arguments.precision, "exact, or fast: less exact clouds in less time");
    command->callback([command, &arguments] {
        const auto is_given = [&](const char* name) { return command->count(name) > 0; };
        EmitOptions options;
        options.scene   = arguments.scene;
        options.profile = &parse_profile(arguments.profile);
        options.output  = optional_value(arguments.output, is_given("--output"), &as_it_is);
        options.size    = optional_value(arguments.size, is_given("--size"), &parse_size);
        options.reduce  = is_given("--fit");
        options.as_text = is_given("--text");
        if (is_given("--frame")) options.frame = parse_number("--frame", arguments.frame, 0, kMaxFrameNumber);
        if (is_given("--precision")) options.changes.precision = parse_precision(arguments.precision);
        emit(options);
    });
    return command;
}

CLI::App* add_vectors(CLI::App& app, Arguments& arguments) {
    CLI::App* command = app.add_subcommand("vectors", "Write a chip's golden vectors, for the tests of other programs");
    command->add_option("--profile", arguments.profile, "The chip: ideal, dx7, ps2, gamecube or xbox")->required();
    command->add_option("-o,--output", arguments.output, "The directory; it is made if it is not there")->required();
    command->callback(
        [&arguments] { write_vectors({.profile = &parse_profile(arguments.profile), .directory = arguments.output}); });
    return command;
}

void add_profiles(CLI::App& app, Arguments& arguments) {
    CLI::App* command =
        app.add_subcommand("profiles", "List the chips, or say how one computes and where that is known from");
    command->add_option("PROFILE", arguments.profile, "The chip: ideal, dx7, ps2, gamecube or xbox");
    command->add_flag("--open")->description("Print what is not known, of PROFILE or of all of them");
    command->callback([command, &arguments] {
        const pipeline::Profile* profile = command->count("PROFILE") > 0 ? &parse_profile(arguments.profile) : nullptr;
        if (command->count("--open") > 0)
            print(open_questions(profile));
        else
            print(profile != nullptr ? description(*profile) : list_of_profiles());
    });
}

// All words after the command are the other program's, --help too.
void add_bench(CLI::App& app) {
    CLI::App* command = app.add_subcommand("bench", "Time it, beside Mesa's llvmpipe and others");
    command->prefix_command()->set_help_flag();
    command->callback([command] { run_bench(command->remaining()); });
}

void add_scenes(CLI::App& app, Arguments& arguments) {
    CLI::App* command = app.add_subcommand("scenes", "List the built-in scenes");
    command->add_option("--sheet", arguments.output, "Draw all of them on one picture instead, this file");
    command->callback([command, &arguments] {
        if (command->count("--sheet") > 0)
            draw_scene_sheet(arguments.output);
        else
            list_scenes();
    });
}

std::string first_line(const std::string& text) {
    return text.substr(0, text.find('\n'));
}

}  // namespace

void run_command_line(int argc, const char* const* argv) {
    CLI::App app("Volumetric clouds on a software model of the fixed-function graphics chips of 1999-2001", "nimbus7");
    Arguments arguments;
    app.require_subcommand(1);
    add_render(app, arguments);
    add_dump(app, arguments);
    add_metrics(app, arguments);
    add_requires(app, arguments);
    add_tradeoff(app, arguments);
    add_plan(app, arguments);
    add_emit(app, arguments);
    add_vectors(app, arguments);
    add_profiles(app, arguments);
    add_bench(app);
    add_scenes(app, arguments);
    app.add_subcommand("fields", "List all that a frame's text may say, with defaults")->callback([] {
        print(pipeline::describe_fields());
    });

    std::vector<std::string> words = joined_statistics(argc, argv);
    std::reverse(words.begin(), words.end());  // as CLI11 wants them
    const auto is_named = [&](const CLI::App* command) { return command->get_name() == words.back(); };
    if (!words.empty() && !words.back().starts_with('-') && app.get_subcommands(is_named).empty()) {
        throw std::runtime_error(words.back() + ": no such command (see nimbus7 --help)");
    }
    try {
        app.parse(words);
    } catch (const CLI::CallForHelp&) {
        print(app.help());
    } catch (const CLI::ParseError& error) {
        const std::vector<CLI::App*> commands = app.get_subcommands();
        const std::string command             = commands.empty() ? "" : commands.front()->get_name() + " ";
        throw std::runtime_error(first_line(error.what()) + " (see nimbus7 " + command + "--help)");
    }
}

}  // namespace demo
