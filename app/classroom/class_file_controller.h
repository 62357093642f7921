#pragma once

#include "ui/classroom/classroom.h"
#include "ui/util/background_thread.h"

#include <QObject>
#include <QPointer>

namespace ui
{
class ClassroomDialog;
struct ClassroomDraft;
class MainWindow;
} // namespace ui

namespace app
{
class Document;

/// The file of a class in the teacher's window: made, opened, changed, and begun; and the works of classes that wait on
/// this computer, for a teacher to move. A class has a program of its own, which begins when this one has ended: no
/// window with the teacher's files is left beside it. Thread: gui.
class ClassFileController : public QObject
{
    Q_OBJECT

public:
    /// A child of the window. The document must outlive this.
    ClassFileController(ui::MainWindow& window, Document& document);

    /// Asks whether the class in that file is to begin, or to be changed; or says why it is none.
    void offer(const QString& path);
    /// The file of the class that is to begin when the program has ended; empty: none.
    const QString& next() const { return m_next; }

private:
    void edit();
    void edit(const ui::Classroom& classroom, const QString& path);
    void load(const QString& path);
    void write(const ui::ClassroomDraft& draft);
    void askToBegin(const ui::Classroom& classroom, const QString& path, const QString& how);
    void begin(const QString& path);
    void showWaiting(const QString& outcome = {});
    void moveWaiting(const QString& folder);

    ui::MainWindow& m_window;
    QPointer<ui::ClassroomDialog> m_dialog;
    QString m_next;
    ui::BackgroundThread m_background; ///< last
};
} // namespace app
