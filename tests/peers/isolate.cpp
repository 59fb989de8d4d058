// SPDX-License-Identifier: MIT
#include "tests/peers/isolate.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <set>

#include "raster/primitives.h"

namespace peers {

using namespace pipeline;

namespace {

std::set<std::int32_t> color_targets_read(const Pass& pass) {
    std::set<std::int32_t> read{pass.color.index};
    for (const Draw& draw : pass.draws) {
        if (const auto* copy = std::get_if<CopyRectangle>(&draw)) {
            read.insert(copy->source.index);
            continue;
        }
        for (const TextureBinding& binding : textures_of(draw)) read.insert(binding.target.index);
    }
    read.erase(-1);
    return read;
}

class Isolation {
  public:
    Isolation(const Frame& frame, const std::vector<TargetPictures>& before, const Nudge& nudge)
        : frame_(frame),
          before_(before),
          nudge_(nudge),
          pixel_edge_(static_cast<float>(frame.arithmetic.pixel_center - raster::kSubpixels / 2) / raster::kSubpixels) {
        out_.arithmetic      = frame.arithmetic;
        out_.targets         = frame.targets;
        out_.cameras         = frame.cameras;
        out_.textures        = frame.textures;
        out_.vertices        = frame.vertices;
        out_.window_vertices = frame.window_vertices;
        out_.indices         = frame.indices;
    }

    // With the passes that its depth comes from.
    Pass& add(std::size_t index) {
        const Pass& pass = frame_.passes[index];
        out_.output      = pass.color;
        if (pass.depth)
            for (std::size_t i = 0; i < index; ++i)
                if (frame_.passes[i].depth == pass.depth && changes_depth(frame_.passes[i])) add_alone(i);
        add_alone(index);
        return out_.passes.back();
    }

    // The same, but the colour target is all zeros before.
    Pass& add_to_black(std::size_t index) {
        Pass counted = add(index);
        counted.clear.color.reset();
        Pass black{.label  = "black",
                   .color  = counted.color,
                   .depth  = {},
                   .camera = {},
                   .clear  = {.color = Argb{0}, .depth = {}},
                   .state  = {},
                   .draws  = {}};
        out_.passes.back() = std::move(black);
        out_.passes.push_back(std::move(counted));
        return out_.passes.back();
    }

    SteppedFrame take_all() {
        SteppedFrame stepped;
        for (std::size_t i = 0; i < frame_.passes.size(); ++i) {
            add_alone(i);
            stepped.places.push_back(out_.passes.size() - 1);
        }
        out_.output   = frame_.output;
        stepped.frame = take();
        return stepped;
    }

    Frame take() { return std::move(out_); }

  private:
    static bool changes_depth(const Pass& pass) { return pass.clear.depth || pass.state.depth.write; }

    void add_alone(std::size_t index) {
        Pass pass = frame_.passes[index];
        for (const std::int32_t target : color_targets_read(pass)) put_back(index, target);
        for (Draw& draw : pass.draws)
            if (auto* rectangle = std::get_if<DrawRectangle>(&draw)) move(*rectangle);
        if (pass.camera) pass.camera = moved_camera(pass);
        AlphaTestState& test = pass.state.alpha_test;
        test.reference       = static_cast<std::uint8_t>(std::clamp(test.reference + nudge_.alpha_reference, 0, 255));
        out_.passes.push_back(std::move(pass));
    }

    void put_back(std::size_t index, std::int32_t target) {
        const ColorImage& picture = *before_[index][static_cast<std::size_t>(target)];
        Texture texture{.name   = {},
                        .format = TextureFormat::A8R8G8B8,
                        .width  = picture.width,
                        .height = picture.height,
                        .levels = 1,
                        .texels = {}};
        texture.texels.resize(4 * picture.pixels.size());
        std::memcpy(texture.texels.data(), picture.pixels.data(), texture.texels.size());
        out_.textures.push_back(std::move(texture));

        DrawRectangle blit;
        blit.x0 = blit.y0        = pixel_edge_;
        blit.x1                  = pixel_edge_ + static_cast<float>(picture.width);
        blit.y1                  = pixel_edge_ + static_cast<float>(picture.height);
        blit.textures[0].texture = {static_cast<std::int32_t>(out_.textures.size()) - 1};
        Pass pass{.label  = "put back",
                  .color  = {target},
                  .depth  = {},
                  .camera = {},
                  .clear  = {},
                  .state  = {},
                  .draws  = {blit}};
        TextureStage& stage = pass.state.stages[0];
        stage.color_op = stage.alpha_op = TextureOp::SelectArg1;
        stage.address_u = stage.address_v = TextureAddress::Clamp;
        out_.passes.push_back(std::move(pass));
    }

    glm::ivec2 size_of(const TextureBinding& binding) const {
        if (binding.texture) {
            const Texture& texture = frame_.textures[static_cast<std::size_t>(binding.texture.index)];
            return {texture.width, texture.height};
        }
        if (binding.target) {
            const Target& target = frame_.targets[static_cast<std::size_t>(binding.target.index)];
            return {target.width, target.height};
        }
        return {1, 1};
    }

    // Rectangles with corners between pixels are the same to every rule, and stay.
    void move(DrawRectangle& rectangle) const {
        for (std::size_t i = 0; i < kTextureStages; ++i) {
            const glm::vec2 step = glm::vec2(nudge_.u, nudge_.v) / glm::vec2(size_of(rectangle.textures[i]));
            rectangle.uv[i].u0 += step.x;
            rectangle.uv[i].u1 += step.x;
            rectangle.uv[i].v0 += step.y;
            rectangle.uv[i].v1 += step.y;
        }
        const auto is_whole = [&](float x) { return x - pixel_edge_ == std::floor(x - pixel_edge_); };
        if (is_whole(rectangle.x0) && is_whole(rectangle.x1) && is_whole(rectangle.y0) && is_whole(rectangle.y1))
            return;
        rectangle.x0 += nudge_.x;
        rectangle.x1 += nudge_.x;
        rectangle.y0 += nudge_.y;
        rectangle.y1 += nudge_.y;
    }

    // Of one pixel to the right and one up, in clip space at w = 1.
    glm::dvec2 pixel_in_clip_space(const Pass& pass) const {
        const Target& target  = frame_.targets[static_cast<std::size_t>((pass.color ? pass.color : pass.depth).index)];
        const PixelRect& part = pass.state.viewport;
        const bool is_whole   = part == PixelRect{};
        return {2.0 / (is_whole ? target.width : part.x1 - part.x0),
                2.0 / (is_whole ? target.height : part.y1 - part.y0)};
    }

    CameraId moved_camera(const Pass& pass) {
        if (nudge_.x == 0.0f && nudge_.y == 0.0f) return pass.camera;
        Camera camera          = camera_of(pass);
        const glm::dvec2 pixel = pixel_in_clip_space(pass);
        for (int column = 0; column < 4; ++column) {
            const double w = camera.projection[column][3];
            camera.projection[column][0] += static_cast<float>(nudge_.x * pixel.x * w);
            camera.projection[column][1] -= static_cast<float>(nudge_.y * pixel.y * w);
        }
        out_.cameras.push_back(camera);
        return {static_cast<std::int32_t>(out_.cameras.size()) - 1};
    }

    const Camera& camera_of(const Pass& pass) const {
        return frame_.cameras[static_cast<std::size_t>(pass.camera.index)];
    }

    const Frame& frame_;
    const std::vector<TargetPictures>& before_;
    Nudge nudge_;
    float pixel_edge_;  // half way between the sample points of pixel 0 and the one before it
    Frame out_;
};

}  // namespace

std::vector<TargetPictures> pictures_of(const Frame& frame) {
    TargetPictures now;
    for (const Target& target : frame.targets) {
        const auto pixels        = static_cast<std::size_t>(target.width) * static_cast<std::size_t>(target.height);
        const std::uint32_t zero = target.format == TargetFormat::X8R8G8B8 ? 0xff000000 : 0;
        now.push_back(is_depth(target.format) ? nullptr
                                              : std::make_shared<const ColorImage>(ColorImage{
                                                    target.width, target.height, std::vector(pixels, zero)}));
    }
    std::vector<TargetPictures> pictures{now};
    execute(frame, {}, [&](const FinishedPass& finished) {
        if (const TargetId color = finished.pass.color)
            now[static_cast<std::size_t>(color.index)] = std::make_shared<const ColorImage>(finished.read_color());
        pictures.push_back(now);
    });
    return pictures;
}

SteppedFrame step_by_step(const Frame& frame, const std::vector<TargetPictures>& before) {
    return Isolation(frame, before, {}).take_all();
}

Frame isolate_pass(const Frame& frame, std::size_t index, const std::vector<TargetPictures>& before,
                   const Nudge& nudge) {
    assert(frame.passes[index].color);
    Isolation isolation(frame, before, nudge);
    isolation.add(index);
    return isolation.take();
}

Frame count_layers(const Frame& frame, std::size_t index, const std::vector<TargetPictures>& before) {
    assert(frame.passes[index].color);
    Isolation isolation(frame, before, {});
    Pass& pass               = isolation.add_to_black(index);
    PipelineState& state     = pass.state;
    // Each fragment adds 1 to every channel of what starts at 0.
    state.blend              = {.source = BlendFactor::One, .dest = BlendFactor::One};
    state.color_mask         = {};
    state.alpha_test         = {};
    state.fog                = {};
    state.lighting           = {};
    state.texture_factor     = {0x01010101};
    state.stages             = {};
    state.stages[0].color_op = state.stages[0].alpha_op = TextureOp::SelectArg1;
    state.stages[0].color_arg1 = state.stages[0].alpha_arg1 = {.source = ArgSource::TFactor};
    return isolation.take();
}

}  // namespace peers
