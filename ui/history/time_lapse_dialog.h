#pragma once

#include <functional>

class QWidget;

namespace ui
{
struct TimeLapseSettings
{
    int width = 0, height = 0; ///< pixels
    int every = 1;             ///< steps from one picture to the next
};

/// Of a model that has so many steps. Returns at once; the callback is called when the person agreed, and never else.
void askForTimeLapse(QWidget* parent, int steps, const std::function<void(const TimeLapseSettings&)>& callback);
} // namespace ui
