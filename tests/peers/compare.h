// SPDX-License-Identifier: MIT
// Two pictures of the same pass. They agree at a pixel if every channel is as near as the roundings allow
// (rounding.h), with what perspective changes there (pass_geometry.h). The others must be *edge pixels*, of which
// there are two kinds:
// - Our own picture changes there when the drawing is moved by a subpixel, and the peer's value lies within that.
//   Channel by channel, least - allowed <= peer <= greatest + allowed, over our pictures with all geometry moved by
//   up to 1/16 pixel along each axis, in steps of 1/32, and the alpha test's reference by as much as alpha may
//   differ. Why that is enough: our vertices are moved by snapping at most 1/32 pixel along each axis, OpenGL's by
//   1/512, so the surface is displaced by no more than that at any point of a triangle; what may have passed over the
//   centre of the pixel (an edge, the line where two surfaces meet, a texel) does pass over it under one of the
//   nudges. Two of ours do not show at an edge: a fragment of almost no alpha, and what a thin triangle's colour changes by
//   within a subpixel, as corners are moved by whole ones. There the peer's value must be as near as roundings and that
//   change allow. An edge that a nudge brings over the centre is up to a whole nudge past it, and the peer's anywhere between:
//   by what colours change by within that, the peer's value may be beyond least and greatest.
// - What is known of the triangles there excuses it (pass_geometry.h): one is thinner than what snapping moves its
//   vertices by, so that it may be seen in one picture only, or two are as near in depth, and nudges of the whole do not
//   show it.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "pipeline/execute/execute.h"

namespace peers {

// Channel by channel over several pictures.
class Envelope {
  public:
    explicit Envelope(const pipeline::ColorImage& picture) : least_(picture.pixels), greatest_(picture.pixels) {}
    void include(const pipeline::ColorImage& picture);

    bool changes(std::size_t pixel) const { return least_[pixel] != greatest_[pixel]; }
    bool contains(std::size_t pixel, std::uint32_t value, int tolerance) const;

  private:
    std::vector<std::uint32_t> least_, greatest_;  // 0xAARRGGBB
};

// What a comparison asks for, if pixels differ. In units of 255.
struct Limits {
    std::function<std::vector<int>()> by_rounding;      // for each pixel
    std::function<int(int x, int y)> with_perspective;  // at least by_rounding
    std::function<Envelope()> envelope;
    std::function<int(int x, int y)> of_nudged;         // beyond the envelope; at least with_perspective
    std::function<int(int x, int y)> at_edge;           // 0 where no edge is near
    std::function<bool(int x, int y)> is_excused;
};

struct Difference {
    int x = 0, y = 0;
    std::uint32_t ours = 0, peers = 0;
    int units = 0;  // of the channel that differs most
};

struct Comparison {
    std::uint64_t pixels    = 0;
    std::uint64_t differing = 0;
    std::uint64_t edge      = 0;  // beyond what is allowed, but an edge pixel
    std::uint64_t failed    = 0;  // beyond what is allowed, and no edge pixel
    Difference worst;             // of the pixels that are no edge pixels, failed ones first
    double sum = 0.0;             // of peer - ours over all channels but those of edge pixels
    double explained_mean = 0.0;  // how far known causes may move the mean, to either side

    double mean() const;  // of peer - ours, in units
    void add(const Comparison& other);
};

// A rule that is broken everywhere by less than a pixel shows: in a picture large enough to tell, differences lean to one
// side by more than is explained (roundings of both kinds leave a mean of 0.03 at most, a floor in place of the nearest
// 0.06 and more), or too many pixels are excused as edges: more than one in 500, and what chance adds to that in a small
// picture, where the canyon's passes have up to one in 1000.
bool leans(const Comparison& comparison);
bool is_suspect(const Comparison& comparison);

// Of two pictures of the same size.
Comparison compare(const pipeline::ColorImage& ours, const pipeline::ColorImage& peers, const Limits& limits);

}  // namespace peers
