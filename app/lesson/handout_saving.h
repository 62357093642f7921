#pragma once

#include "core/lesson/lesson.h"
#include "ui/util/background_thread.h"

#include <QObject>
#include <QPointer>

#include <memory>

namespace ui
{
class MainWindow;
}

namespace app
{
/// Writes the handout of a lesson to a file that the user chooses. Thread: gui; the file is written on a background
/// thread.
class HandoutSaving : public QObject
{
    Q_OBJECT

public:
    explicit HandoutSaving(ui::MainWindow* window);

    void ask(const std::shared_ptr<const core::Lesson>& lesson);

private:
    void write(const std::shared_ptr<const core::Lesson>& lesson, const QString& path);

    QPointer<ui::MainWindow> m_window;
    ui::BackgroundThread m_background; ///< last member: its destructor waits for jobs that use the other members
};
} // namespace app
