#pragma once

#include <functional>

class QWidget;

namespace ui
{
struct TimeLapseSettings
{
    int width = 0, height = 0; ///< pixels
    int every = 1;             ///< steps of the history between two pictures
};

/// Asks for the size and the number of pictures. `steps`: steps of the model's history. Returns at once; `callback` is
/// called only if the user accepts.
void askForTimeLapse(QWidget* parent, int steps, const std::function<void(const TimeLapseSettings&)>& callback);
} // namespace ui
