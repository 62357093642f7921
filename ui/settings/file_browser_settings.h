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

/// Width and height of a picture in the files panel, logical pixels.
inline constexpr int minPictureSize = 64, maxPictureSize = 256, defaultPictureSize = 96;

/// The folder that the files panel shows, and its view.
struct FileBrowserSettings
{
    QString folder; ///< absolute path
    FileOrder order = FileOrder::Name;
    bool descending = false;
    int pictureSize = defaultPictureSize; ///< logical pixels
};
} // namespace ui
