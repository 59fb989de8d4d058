// SPDX-License-Identifier: MIT
#include "demo/pass_pictures.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "demo/image_file.h"

namespace demo {
namespace {

namespace fs = std::filesystem;

pipeline::ColorImage alpha_as_grey(const pipeline::ColorImage& image) {
    pipeline::ColorImage grey = image;
    for (std::uint32_t& pixel : grey.pixels) pixel = 0xff000000 | (pixel >> 24) * 0x010101;
    return grey;
}

}  // namespace

std::string file_name_of(const std::string& label) {
    std::string name;
    for (const char c : label) {
        const bool stays = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
                           c == '_' || c == '-';
        if (stays || name.empty() || name.back() != '-') name += stays ? c : '-';
    }
    return name.substr(0, 100);
}

PassPictures::PassPictures(const std::string& directory, std::size_t passes)
    : directory_(directory), digits_(std::max<std::size_t>(2, std::to_string(passes > 0 ? passes - 1 : 0).size())) {
    std::error_code error;
    if (fs::exists(directory_, error) && !fs::is_directory(directory_, error)) {
        throw std::runtime_error("--passes " + directory_ + ": is not a directory");
    }
    fs::create_directory(directory_, error);
    if (error) throw std::runtime_error("--passes " + directory_ + ": " + error.message());
}

void PassPictures::add(const pipeline::FinishedPass& pass) {
    const std::string digits         = std::to_string(pass.index);
    const std::string number         = std::string(digits_ - std::min(digits_, digits.size()), '0') + digits;
    const pipeline::ColorImage color = pass.read_color();
    const pipeline::ColorImage alpha = alpha_as_grey(color);
    std::string label                = number + ' ' + pass.pass.label;
    if (color.width > 0) {
        const std::string stem = fs::path(directory_) / (number + '_' + file_name_of(pass.pass.label));
        write_image(stem + ".png", color, Channels::Rgb);
        write_image(stem + "_alpha.png", alpha, Channels::Rgb);
        label += ' ' + std::to_string(color.width) + 'x' + std::to_string(color.height);
    }
    sheet_.add(label, color, alpha);
}

void PassPictures::finish() {
    write_image(fs::path(directory_) / "contact_sheet.png", sheet_.draw(), Channels::Rgb);
}

}  // namespace demo
