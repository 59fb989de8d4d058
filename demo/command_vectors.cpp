// SPDX-License-Identifier: MIT
#include "demo/command_vectors.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <type_traits>

#include "demo/embedded_texts.h"
#include "demo/new_file.h"
#include "demo/progress_bar.h"
#include "demo/standard_output.h"
#include "demo/vectors/npy_file.h"
#include "demo/vectors/sha256.h"
#include "demo/vectors/vector_frames.h"
#include "demo/vectors/vector_probe.h"
#include "demo/vectors/vector_tables.h"
#include "demo/version.h"
#include "pipeline/frame/frame_fields.h"

namespace demo {

using namespace pipeline;

namespace {

namespace fs = std::filesystem;
using Json   = nlohmann::ordered_json;

const std::string kFieldsFile = "frames/FIELDS.txt";
constexpr std::string_view kNotation =
    "Values are bytes, 0..255. Arrays are in C order: the last axis is the fastest. In formulas / is exact, >> is "
    "floor division by a power of two, floor() rounds down, clamp() is to 0..255; s is the fragment, d the pixel "
    "there before. A frame's comment says what it shows; an answer in it is this profile's, with colours as "
    "0xAARRGGBB and pixels as (x, y) from the top left; what a frame leaves out is as in frames/FIELDS.txt. Grades, the "
    "surest first: measured on the chip; fitted, a formula to captures of the chip; emulators, which agree; document, "
    "the maker's or of the time; chosen, for sources disagree or are silent, and open says how.";

std::string in(const std::string& directory, const std::string& name) {
    return (fs::path(directory) / name).string();
}

void make_directory(const std::string& path) {
    std::error_code error;
    if (path.empty()) throw std::runtime_error("output: the path is empty");
    if (fs::exists(path, error) && !fs::is_directory(path, error)) {
        throw std::runtime_error(path + ": is not a directory");
    }
    fs::create_directory(path, error);
    if (error) throw std::runtime_error(path + ": " + error.message());
}

Json to_json(const Evidence& evidence) {
    Json json;
    json["source"] = evidence.source;
    json["grade"]  = enum_name(evidence.grade);
    json["open"]   = evidence.open;
    return json;
}

// Two or more numbers, each one more than the one before it, as a range.
Axis shortened(const Axis& axis) {
    const auto* values         = std::get_if<std::vector<int>>(&axis.values);
    const auto does_not_follow = [](int one, int next) { return next != one + 1; };
    if (values == nullptr || values->size() < 2 ||
        std::adjacent_find(values->begin(), values->end(), does_not_follow) != values->end())
        return axis;
    return {axis.name, AxisRange{values->front(), values->back()}};
}

Json to_json(const Axis& long_axis) {
    const Axis axis = shortened(long_axis);
    Json json;
    json["name"] = axis.name;
    std::visit(
        [&](const auto& values) {
            if constexpr (std::is_same_v<std::remove_cvref_t<decltype(values)>, AxisRange>) {
                json["first"] = values.first;
                json["last"]  = values.last;
            } else {
                json["values"] = values;
            }
        },
        axis.values);
    return json;
}

Json arithmetic_json(const Arithmetic& arithmetic) {
    Json json;
    visit_fields(arithmetic, [&](std::string_view name, const auto& field) {
        if constexpr (NamedEnum<std::remove_cvref_t<decltype(field)>>) {
            json[std::string(name)] = enum_name(field);
        } else {
            json[std::string(name)] = field;
        }
    });
    return json;
}

class VectorWriter {
  public:
    explicit VectorWriter(const VectorsOptions& options)
        : profile_(*options.profile),
          directory_(options.directory),
          prober_(profile_.arithmetic),
          tables_(vector_tables(profile_, prober_)),
          frames_(vector_frames(profile_, embedded_frames())),
          progress_(static_cast<int>(tables_.size() + frames_.size())) {}

    void write() {
        make_directory(directory_);
        make_directory(in(directory_, "frames"));
        const std::string manifest = in(directory_, "manifest.json");
        check_output(manifest);
        // Whoever finds a manifest finds all that it lists, so it comes last and an older one goes first.
        std::error_code error;
        fs::remove(manifest, error);
        if (error) throw std::runtime_error(manifest + ": " + error.message());

        Json json        = head();
        json["arrays"]   = Json::array();
        json["frames"]   = Json::array();
        json["left_out"] = Json::array();
        for (const VectorTable& table : tables_) {
            json["arrays"].push_back(write(table));
            progress_.advance();
        }
        for (const VectorFrame& frame : frames_) {
            if (frame.why_not.empty()) {
                json["frames"].push_back(write(frame));
            } else {
                json["left_out"].push_back({{"name", frame.name}, {"why", frame.why_not}});
            }
            progress_.advance();
        }
        json["fields"]["file"]   = kFieldsFile;
        json["fields"]["sha256"] = write_bytes(kFieldsFile, pipeline::describe_fields());
        write_file(manifest, json.dump(1) + "\n");
        progress_.hide();
        print(manifest + "  " + std::to_string(json["arrays"].size()) + " arrays, " +
              std::to_string(json["frames"].size()) + " frames, " + std::to_string(bytes_ / 1000000) + " MB\n");
    }

  private:
    Json head() const {
        Json json;
        json["program"]    = "nimbus7";
        json["version"]    = kVersion;
        json["profile"]    = profile_.name;
        json["chip"]       = profile_.chip;
        json["notation"]   = kNotation;
        json["arithmetic"] = arithmetic_json(profile_.arithmetic);
        for (const Evidence& evidence : profile_.evidence)
            json["evidence"][std::string(evidence.topic)] = to_json(evidence);
        return json;
    }

    std::string write_bytes(const std::string& name, std::string_view bytes) {
        write_file(in(directory_, name), bytes);
        bytes_ += bytes.size();
        return sha256(bytes);
    }

    Json write(const VectorTable& table) {
        const auto evidence = std::find_if(profile_.evidence.begin(), profile_.evidence.end(),
                                           [&](const Evidence& entry) { return entry.topic == table.topic; });
        if (evidence == profile_.evidence.end()) throw std::logic_error("no evidence for " + table.topic);
        std::vector<std::size_t> shape;
        Json axes = Json::array();
        for (const Axis& axis : table.axes) {
            shape.push_back(axis_size(axis));
            axes.push_back(to_json(axis));
        }
        Json json;
        json["file"]    = table.name + ".npy";
        json["rule"]    = table.rule;
        json["what"]    = table.what;
        json["value"]   = table.expression;
        json["formula"] = table.formula;
        json["axes"]    = axes;
        json["shape"]   = shape;
        json["dtype"]   = "uint8";
        json.update(to_json(*evidence));
        json["sha256"] = write_bytes(table.name + ".npy", to_npy(shape, table.draw()));
        return json;
    }

    Json write(const VectorFrame& frame) {
        const std::string text = "frames/" + frame.name + ".frame", pixels = "frames/" + frame.name + ".npy";
        const Target& output = frame.frame.targets[static_cast<std::size_t>(frame.frame.output.index)];
        const std::vector<std::size_t> shape{static_cast<std::size_t>(output.height),
                                             static_cast<std::size_t>(output.width), 4};
        Bytes bytes;
        for (const std::uint32_t argb : executor_.execute(frame.frame).output.pixels)
            for (const int shift : {16, 8, 0, 24}) bytes.push_back(static_cast<std::uint8_t>(argb >> shift));
        Json json;
        json["frame"]        = text;
        json["frame_sha256"] = write_bytes(text, text_of(frame));
        json["file"]         = pixels;
        json["what"]         = frame.what;
        json["axes"]         = Json::array({"y, from the top", "x", "red, green, blue, alpha"});
        json["shape"]        = shape;
        json["dtype"]        = "uint8";
        json["sha256"]       = write_bytes(pixels, to_npy(shape, bytes));
        return json;
    }

    const Profile& profile_;
    std::string directory_;
    Prober prober_;
    Executor executor_;
    std::vector<VectorTable> tables_;
    std::vector<VectorFrame> frames_;
    ProgressBar progress_;
    std::size_t bytes_ = 0;
};

}  // namespace

void write_vectors(const VectorsOptions& options) {
    VectorWriter(options).write();
}

}  // namespace demo
