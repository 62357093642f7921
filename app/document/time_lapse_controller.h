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

/// Exports the steps of the document as pictures, in the window's present view (File > Export Time-Lapse). Sculpting is
/// paused meanwhile. Thread: gui.
class TimeLapseController : public QObject
{
    Q_OBJECT

public:
    /// A child of the document. The document must outlive it; the window need not.
    TimeLapseController(ui::MainWindow& window, Document& document);

private:
    void ask();
    void write(const ui::TimeLapseSettings& settings, const QString& folder);
    void finish(const QString& folder, const TimeLapseOutcome& outcome);

    QPointer<ui::MainWindow> m_window;
    Document* m_document;
};
} // namespace app
