#pragma once

#include "ui/widgets/message_bar.h"

#include <QDateTime>

namespace ui
{
/// What was not saved when the program ended, and may be had again.
struct UnsavedModel
{
    QString name;
    QDateTime changed;
    int steps = 0;
};

/// Offers a model that was not saved. Thread: gui.
class RecoveryBar : public MessageBar
{
    Q_OBJECT

public:
    RecoveryBar(const UnsavedModel& unsaved, QMainWindow* window);

Q_SIGNALS:
    void recoverRequested();
    /// After a question.
    void discardRequested();

private:
    void askToDiscard();

    QString m_name;
};
} // namespace ui
