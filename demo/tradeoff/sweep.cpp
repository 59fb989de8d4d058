// SPDX-License-Identifier: MIT
#include "demo/tradeoff/sweep.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <set>

#include "demo/precision.h"
#include "demo/progress_bar.h"
#include "demo/tradeoff/pareto.h"

namespace demo {
namespace {

double thread_ms() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}
double wall_ms() {
    using Clock = std::chrono::steady_clock;
    return std::chrono::duration<double, std::milli>(Clock::now().time_since_epoch()).count();
}

constexpr std::size_t kFewCombinations = 32;
constexpr int kMostBatches             = 4;  // of combinations

// Of sorted values; between two where it falls there.
double quantile(std::vector<double> values, double part) {
    std::sort(values.begin(), values.end());
    const double at         = part * static_cast<double>(values.size() - 1);
    const std::size_t below = static_cast<std::size_t>(at), above = std::min(below + 1, values.size() - 1);
    return values[below] + (at - static_cast<double>(below)) * (values[above] - values[below]);
}

// Each frame's times, run by run.
struct Times {
    std::vector<double> milliseconds, ratios;
};

class Timer {
  public:
    explicit Timer(const SweepOptions& options) : options_(options) {}

    // frames: the exact one first, whose ratios tell how well they are known. pictures: one for each.
    std::vector<Times> time(const std::vector<const pipeline::Frame*>& frames,
                            std::vector<pipeline::ColorImage>& pictures) {
        ProgressBar progress(static_cast<int>(frames.size()) * (options_.runs + 1));
        std::vector<Times> times(frames.size());
        pictures.resize(frames.size());
        for (int run = 0; run <= options_.runs; ++run)
            for (std::size_t i = 0; i < frames.size(); ++i) {
                // Right beside the exact frame, before it and after it by turns.
                const bool exact_first = run % 2 == 0;
                double exact           = exact_first ? draw(*frames[0]) : 0.0;
                const double now       = draw(*frames[i]);
                if (run == 0) pictures[i] = execution_.output;
                if (!exact_first) exact = draw(*frames[0]);
                if (run > 0) {
                    times[i].milliseconds.push_back(now);
                    times[i].ratios.push_back(now / exact);
                }
                progress.advance();
            }
        progress.hide();
        return times;
    }

  private:
    // Twice: the first finds memory and caches as another frame left them.
    double draw(const pipeline::Frame& frame) {
        executor_.execute(frame, execution_, {.threads = options_.threads});
        const auto now     = options_.threads == 1 ? &thread_ms : &wall_ms;
        const double start = now();
        executor_.execute(frame, execution_, {.threads = options_.threads});
        return now() - start;
    }

    const SweepOptions& options_;
    pipeline::Executor executor_;
    pipeline::Execution execution_;
};

class Sweeper {
  public:
    Sweeper(const Scene& scene, const SweepOptions& options, std::span<const Knob> knobs, const DrawTruth& draw_truth)
        : scene_(scene),
          knobs_(knobs),
          timer_(options),
          exact_(scene_frame(scene, options.size, options.frame)),
          result_{.options = options} {
        result_.truth = draw_truth(exact_);
    }

    Sweep run() && {
        std::vector<Choice> singles;
        for (std::size_t knob = 0; knob < knobs_.size(); ++knob)
            for (std::size_t setting = 1; setting <= knobs_[knob].settings.size(); ++setting) {
                singles.push_back(exact_choice(knobs_));
                singles.back()[knob] = setting;
            }
        measure(singles);
        for (int batch = 0; batch < kMostBatches; ++batch) {
            const std::vector<Choice> combinations = next_combinations(result_, knobs_);
            if (combinations.empty()) break;
            measure(combinations);
        }
        return std::move(result_);
    }

  private:
    void measure(const std::vector<Choice>& choices) {
        std::vector<Choice> kept;
        std::vector<pipeline::Frame> frames;
        for (const Choice& choice : choices) {
            pipeline::Frame frame =
                scene_frame(scene_, result_.options.size, result_.options.frame, options_of(choice, knobs_));
            if (frame == exact_) {
                result_.without_effect.push_back(name_of(choice, knobs_));
                continue;
            }
            kept.push_back(choice);
            frames.push_back(std::move(frame));
        }
        std::vector<const pipeline::Frame*> timed{&exact_};
        for (const pipeline::Frame& frame : frames) timed.push_back(&frame);
        std::vector<pipeline::ColorImage> pictures;
        const std::vector<Times> times = timer_.time(timed, pictures);

        const std::vector<double>& again = times.front().ratios;
        // The standard error of a median of normal values is 1.2533 sigma / sqrt(n), and sigma is 0.7413 quartile distances.
        const double distance            = quantile(again, 0.75) - quantile(again, 0.25);
        result_.noise = std::max(result_.noise, 2.0 * 1.2533 * 0.7413 * distance / std::sqrt(again.size()));
        if (result_.settings.empty()) {
            exact_picture_ = to_real(pictures.front());
            add(exact_choice(knobs_), times.front(), std::move(pictures.front()));
            result_.settings.front().ratio = 1.0;
        }
        for (std::size_t i = 0; i < kept.size(); ++i) add(kept[i], times[i + 1], std::move(pictures[i + 1]));
        mark_fronts(result_);
    }

    void add(const Choice& choice, const Times& times, pipeline::ColorImage picture) {
        const RealPicture real = to_real(picture);
        const bool is_fast =
            options_of(choice, knobs_).mega_particles == with_precision({.precision = Precision::Fast}).mega_particles;
        result_.settings.push_back({.choice       = choice,
                                    .name         = name_of(choice, knobs_) + (is_fast ? " (fast)" : ""),
                                    .milliseconds = quantile(times.milliseconds, 0.5),
                                    .ratio        = quantile(times.ratios, 0.5),
                                    .ratio_low    = quantile(times.ratios, 0.25),
                                    .ratio_high   = quantile(times.ratios, 0.75),
                                    .to_truth     = error_between(result_.truth, real),
                                    .to_exact     = error_between(exact_picture_, real),
                                    .picture      = std::move(picture)});
    }

    const Scene& scene_;
    std::span<const Knob> knobs_;
    Timer timer_;
    pipeline::Frame exact_;
    RealPicture exact_picture_;
    Sweep result_;
};

bool pays(const MeasuredSetting& setting, const Sweep& sweep) {
    return setting.ratio < 1.0 - sweep.noise;
}

std::size_t knobs_turned(const Choice& choice) {
    return choice.size() - static_cast<std::size_t>(std::count(choice.begin(), choice.end(), std::size_t{0}));
}

}  // namespace

Sweep sweep(const Scene& scene, const SweepOptions& options, std::span<const Knob> knobs, const DrawTruth& draw_truth) {
    return Sweeper(scene, options, knobs, draw_truth).run();
}

void mark_fronts(Sweep& sweep) {
    const auto mark = [&](PictureError MeasuredSetting::*error, bool MeasuredSetting::*is_on) {
        std::vector<MeasuredSetting*> candidates;
        std::vector<Cost> costs;
        for (std::size_t i = 0; i < sweep.settings.size(); ++i) {
            MeasuredSetting& setting = sweep.settings[i];
            setting.*is_on           = false;
            if (i > 0 && !pays(setting, sweep)) continue;
            candidates.push_back(&setting);
            costs.push_back({setting.ratio, (setting.*error).rms});
        }
        for (const std::size_t i : pareto_front(costs)) candidates[i]->*is_on = true;
    };
    mark(&MeasuredSetting::to_truth, &MeasuredSetting::on_truth_front);
    mark(&MeasuredSetting::to_exact, &MeasuredSetting::on_exact_front);
}

std::vector<Choice> next_combinations(const Sweep& sweep, std::span<const Knob> knobs) {
    std::vector<std::vector<std::size_t>> paying(knobs.size());
    std::set<Choice> known;
    for (const MeasuredSetting& setting : sweep.settings) {
        known.insert(setting.choice);
        if (knobs_turned(setting.choice) != 1 || !pays(setting, sweep)) continue;
        for (std::size_t knob = 0; knob < knobs.size(); ++knob)
            if (setting.choice[knob] > 0) paying[knob].push_back(setting.choice[knob]);
    }
    std::vector<Choice> found;
    const auto add = [&](const Choice& choice) {
        if (known.insert(choice).second) found.push_back(choice);
    };
    std::size_t product = 1;
    for (const auto& settings : paying) product = std::min(product * (settings.size() + 1), kFewCombinations + 1);
    if (product <= kFewCombinations) {
        std::vector<Choice> all{exact_choice(knobs)};
        for (std::size_t knob = 0; knob < knobs.size(); ++knob)
            for (std::size_t i = all.size(); i-- > 0;)
                for (const std::size_t setting : paying[knob]) {
                    all.push_back(all[i]);
                    all.back()[knob] = setting;
                }
        for (const Choice& choice : all) add(choice);
        return found;
    }
    for (const MeasuredSetting& setting : sweep.settings) {
        if (!setting.on_a_front()) continue;
        for (std::size_t knob = 0; knob < knobs.size(); ++knob) {
            if (setting.choice[knob] != 0) continue;
            for (const std::size_t other : paying[knob]) {
                Choice choice = setting.choice;
                choice[knob]  = other;
                add(choice);
            }
        }
    }
    return found;
}

}  // namespace demo
