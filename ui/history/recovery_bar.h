#pragma once

#include "ui/widgets/message_bar.h"

#include <QDateTime>

namespace ui
{
/// A model with changes that were not saved when the program ended.
struct UnsavedModel
{
    QString name;
    QDateTime changed;
    int steps = 0;
};

/// A bar that offers to recover the changes of an unsaved model. Thread: gui.
class RecoveryBar : public MessageBar
{
    Q_OBJECT

public:
    RecoveryBar(const UnsavedModel& unsaved, QMainWindow* window);

Q_SIGNALS:
    void recoverRequested();
    /// The user has confirmed that the changes are to be deleted.
    void discardRequested();

private:
    void askToDiscard();

    QString m_name;
};
} // namespace ui
