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

/// Lets the teacher make, open, change and start class files, and move undelivered works that are still on this
/// computer. A class runs in a program of its own, which starts when this one has ended, so no window with the
/// teacher's files stays open beside it. Thread: gui.
class ClassFileController : public QObject
{
    Q_OBJECT

public:
    /// A child of the window. The document must outlive it.
    ClassFileController(ui::MainWindow& window, Document& document);

    /// Asks whether to begin or change the class of the given file. Shows an error if it is not a class file.
    void offer(const QString& path);
    /// Returns the file of the class to begin when the program has ended; empty: none.
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
    ui::BackgroundThread m_background; ///< last member: its destructor waits for jobs that use the other members
};
} // namespace app
