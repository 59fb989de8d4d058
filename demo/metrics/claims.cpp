// SPDX-License-Identifier: MIT
#include "demo/metrics/claims.h"

#include <array>
#include <vector>

#include "demo/metrics/scene_metrics.h"

namespace demo {
namespace {

// key: of the metric that tells; "" for a claim that no figure tells about.
struct Claim {
    const char *claim, *key;
};
constexpr std::array kClaims{
    Claim{"Mega-particles are lit; sprites mostly are not", "M10.tone"},
    Claim{"", "M10.shadow_saturation"},
    Claim{"They hide the scene and are hidden by it, accurately", "M2.error"},
    Claim{"No sharp cut-outs where they meet the scene", "M1.cut_share"},
    Claim{"", "M1.edge_width"},
    Claim{"", "M1.hard_steps"},
    Claim{"The camera may enter the cloud", "M0.inside"},
    Claim{"Controls are direct: spheres, colours, one blur", ""},
    Claim{"Particles burn fill rate; here two full-screen blends at most", "M8.layers"},
    Claim{"", "M8.layers_full"},
    Claim{"", "M8.megabytes"},
    Claim{"The cost hardly changes with the view", "M8.cost_variation"},
    Claim{"", "M8.sphere_slope"},
    Claim{"Few things move, so the CPU has little to do", "M8.moved"},
    Claim{"The depth test rejects pixels early", "M8.early_z"},
    Claim{"Spheres drawn front to back save overdraw", "M8.front_to_back"},
    Claim{"Only the part that the cloud covers needs the blur", "M8.blur_scissored"},
    Claim{"In an orbit the detail stays on the cloud", "M6.orbit"},
    Claim{"The cloud can be seen from any angle", "M5.orbit_jump"},
};

}  // namespace

std::string claims_table(const Scene& scene, StudioOptions options) {
    std::vector<MetricsReport> reports;
    for (const Technique technique : {Technique::MegaParticles, Technique::Sprites, Technique::Slices}) {
        options.technique = technique;
        reports.push_back(scene_metrics(scene, options));
    }
    std::string table = "| claim | measure | mega-particles | sprites | slices |\n| --- | --- | ---: | ---: | ---: |\n";
    for (const Claim& claim : kClaims) {
        const std::string key = claim.key;
        table += std::string("| ") + claim.claim + " | ";
        if (key.empty()) {
            table += "not measured | | | |\n";
            continue;
        }
        table += find_metric(reports.front().metrics, key).what + " (" + key + ")";
        for (const MetricsReport& report : reports) table += " | " + value_text(find_metric(report.metrics, key));
        table += " |\n";
    }
    return table;
}

}  // namespace demo
