#pragma once

#include "ui/settings/model_info.h"
#include "ui/widgets/message_bar.h"

namespace ui
{
/// A bar that tells what became of the objects of a file, and offers the other way to open it. The choice is stored as
/// a preference, so that it also holds for files that are opened later. Thread: gui.
class ObjectsBar : public MessageBar
{
    Q_OBJECT

public:
    /// `name`: name of the file.
    ObjectsBar(const QString& name, const FileObjects& objects, QMainWindow* window);

Q_SIGNALS:
    /// The file is to be opened again, by the new preference.
    void reopenRequested();
};
} // namespace ui
