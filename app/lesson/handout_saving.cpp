#include "app/lesson/handout_saving.h"

#include "app/lesson/lesson_handout.h"
#include "app/lesson/lesson_model.h"

#include "core/util/atomic_file.h"
#include "ui/util/error_messages.h"
#include "ui/widgets/file_dialogs.h"
#include "ui/window/main_window.h"

#include <QFileInfo>
#include <QLocale>

namespace app
{
HandoutSaving::HandoutSaving(ui::MainWindow* window) : m_window(window) {}

void HandoutSaving::ask(const std::shared_ptr<const core::Lesson>& lesson)
{
    ui::askForHandout(m_window, fileNameOf(*lesson), [this, lesson](const QString& path) { write(lesson, path); });
}

void HandoutSaving::write(const std::shared_ptr<const core::Lesson>& lesson, const QString& path)
{
    const auto write = [lesson, path] {
        try {
            core::AtomicFile file(toPath(path)); // made first, so that nothing is drawn if the file cannot be written
            file.write(lessonHandout(*lesson, QLocale().name()).toStdString());
            file.commit();
        } catch (const core::FileError& error) {
            return ui::ErrorMessages::sentence(error);
        }
        return QString();
    };
    m_background.run(write, [this, path](const QString& problem) {
        if (!m_window)
            return;
        if (problem.isEmpty())
            m_window->showNotice(tr("Saved %1.").arg(QFileInfo(path).fileName()));
        else
            m_window->showProblem(problem);
    });
}
} // namespace app
