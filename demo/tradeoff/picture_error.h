// SPDX-License-Identifier: MIT
// How far two pictures of one size are apart. Pictures are real numbers here, so that one that was never rounded to bytes
// can be compared.
#pragma once

#include <array>
#include <vector>

#include "pipeline/execute/execute.h"

namespace demo {

// Red, green, blue in 0..255, row by row from the top. Alpha is not shown and not compared.
struct RealPicture {
    int width = 0, height = 0;
    std::vector<std::array<double, 3>> pixels;
};
RealPicture to_real(const pipeline::ColorImage& image);

// The window of SSIM: pictures are at least as large.
inline constexpr int kSsimWindow = 11;

// Over all pixels and channels: the greatest difference and the root of the mean square, of 255; PSNR in dB, infinite
// for equal pictures. ssim: the mean structural similarity of the luma 0.299 R + 0.587 G + 0.114 B (Wang, Bovik, Sheikh and
// Simoncelli, "Image Quality Assessment: From Error Visibility to Structural Similarity", 2004): windows of 11x11 wholly
// within the picture, weighted by a Gaussian of 1.5 pixels, K1 0.01, K2 0.03. 1 for equal pictures.
struct PictureError {
    double max = 0.0, rms = 0.0, psnr_db = 0.0, ssim = 1.0;
};
PictureError error_between(const RealPicture& a, const RealPicture& b);

}  // namespace demo
