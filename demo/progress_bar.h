// SPDX-License-Identifier: MIT
// A line on standard error that fills while many frames are drawn. Shown only on a terminal, and only for more than
// one step.
#pragma once

namespace demo {

class ProgressBar {
  public:
    explicit ProgressBar(int steps);

    void advance();  // one step is done; shows the bar
    void hide();     // until the next step: before something else is printed

  private:
    int steps_, done_ = 0;
    bool is_shown_;
};

}  // namespace demo
