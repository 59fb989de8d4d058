// SPDX-License-Identifier: MIT
#include "pipeline/legalize/unused.h"

#include <algorithm>

#include "pipeline/check/chip_findings.h"
#include "pipeline/check/target_use.h"

namespace pipeline {

Frame drop_unused(Frame frame, const Profile& profile, RewriteNotes& notes) {
    if (profile.limits.memory == 0) return frame;
    std::vector<bool> used(frame.textures.size());
    for (const Pass& pass : frame.passes)
        for_each_texture(pass, [&](std::size_t, std::size_t, const TextureBinding& binding) {
            if (binding.texture) used[static_cast<std::size_t>(binding.texture.index)] = true;
        });
    std::vector<TextureId> places(frame.textures.size());
    std::vector<Texture> kept;
    for (std::size_t i = 0; i < frame.textures.size(); ++i) {
        if (used[i]) {
            places[i] = {static_cast<std::int32_t>(kept.size())};
            kept.push_back(std::move(frame.textures[i]));
        } else {
            notes.push_back({"unused", Place("texture", i, frame.textures[i].name).text(), "no pass reads it",
                             "it is not in memory"});
        }
    }
    frame.textures = std::move(kept);
    for (Pass& pass : frame.passes)
        for (Draw& draw : pass.draws)
            if (TextureBindings* bindings = bindings_of(draw))
                for (TextureBinding& binding : *bindings)
                    if (binding.texture) binding.texture = places[static_cast<std::size_t>(binding.texture.index)];
    return frame;
}

}  // namespace pipeline
