#include "ui/model/objects_bar.h"

#include "ui/settings/settings.h"

#include <QPushButton>

namespace ui
{
ObjectsBar::ObjectsBar(const QString& name, const FileObjects& objects, QMainWindow* window)
    : MessageBar("objectsBar", tr("Objects of the File"), window)
{
    const int count = static_cast<int>(objects.count);
    const QString sentence = objects.areParts ? tr("%1 has %Ln objects. Each is a part now.", nullptr, count)
                                              : tr("%1 has %Ln objects. They are one part now.", nullptr, count);
    setMessage("objectsText", sentence.arg(shortened(name)), name);
    QPushButton* other =
        objects.areParts
            ? addButton("asOnePart", tr("Open as &One Part"),
                        tr("Opens the file again and makes one part of all objects, also of files opened later."))
            : addButton("asParts", tr("Open as &Parts"),
                        tr("Opens the file again and makes a part of each object, also of files opened later."));
    other->setDefault(true);
    connect(other, &QPushButton::clicked, this, [this, areParts = objects.areParts] {
        Settings settings;
        auto preferences = settings.get<Preferences>();
        preferences.opensObjectsAsParts = !areParts;
        settings.set(preferences);
        Q_EMIT reopenRequested();
    });
    QPushButton* leave =
        addButton("leaveObjects", tr("&Keep as It Is"), tr("Leaves the model as it is, and hides this bar."));
    connect(leave, &QPushButton::clicked, this, &ObjectsBar::dismiss);
}
} // namespace ui
