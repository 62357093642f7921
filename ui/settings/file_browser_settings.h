#pragma once

#include "ui/settings/view_appearance.h"

#include <QString>

namespace ui
{
enum class FileOrder { Name, Size, Date, Vertices };

inline constexpr std::array<Named<FileOrder>, 4> fileOrders{{{FileOrder::Name, "name"},
                                                             {FileOrder::Size, "size"},
                                                             {FileOrder::Date, "date"},
                                                             {FileOrder::Vertices, "vertices"}}};

/// Of a picture in the files panel, in logical pixels.
inline constexpr int minPicture = 64, maxPicture = 256, defaultPicture = 96;

/// What the files panel shows, and how.
struct FileBrowserSettings
{
    QString folder; ///< absolute
    FileOrder order = FileOrder::Name;
    bool descending = false;
    int picture = defaultPicture;
};
} // namespace ui
