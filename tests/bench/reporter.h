// SPDX-License-Identifier: MIT
// Reports of a run: lines as it goes, and Google Benchmark's JSON of all of it. Names are given without what Google
// Benchmark adds to them to say which clock was read.
#pragma once

#include <benchmark/benchmark.h>

#include <sstream>

namespace bench {

class Reporter : public benchmark::BenchmarkReporter {
  public:
    explicit Reporter(std::ostream& lines) {
        console_.SetOutputStream(&lines);
        console_.SetErrorStream(&lines);
        json_.SetOutputStream(&text_);
        json_.SetErrorStream(&text_);
    }

    bool ReportContext(const Context& context) override {
        return console_.ReportContext(context) && json_.ReportContext(context);
    }
    void ReportRuns(const std::vector<Run>& report) override {
        std::vector<Run> runs = report;
        for (Run& run : runs) run.run_name.time_type.clear();
        console_.ReportRuns(runs);
        json_.ReportRuns(runs);
    }
    void Finalize() override { json_.Finalize(); }

    std::string json() const { return text_.str(); }

  private:
    benchmark::ConsoleReporter console_{benchmark::ConsoleReporter::OO_Tabular};
    benchmark::JSONReporter json_;
    std::ostringstream text_;
};

}  // namespace bench
