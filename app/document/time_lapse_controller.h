#pragma once

#include "app/document/time_lapse.h"

#include <QObject>
#include <QPointer>

namespace ui
{
class MainWindow;
struct TimeLapseSettings;
} // namespace ui

namespace app
{
class Document;

/// File > Export Time-Lapse: the steps of the document as pictures, seen as the window sees the model. Nobody sculpts
/// meanwhile. Thread: gui.
class TimeLapseController : public QObject
{
    Q_OBJECT

public:
    /// All must outlive it but for the window: a child of the document.
    TimeLapseController(ui::MainWindow& window, Document& document);

private:
    void ask();
    void write(const ui::TimeLapseSettings& settings, const QString& folder);
    void finish(const QString& folder, const TimeLapseOutcome& outcome);

    QPointer<ui::MainWindow> m_window;
    Document* m_document;
};
} // namespace app
