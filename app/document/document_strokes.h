#pragma once

#include <QObject>

namespace core
{
struct StrokeSample;
struct StrokeSettings;
enum class StrokeEnd;
} // namespace core

namespace app
{
class Document;
struct StrokeReport;

/// Sends the strokes of the desktop to the worker, and processes the worker's reports of all strokes. Thread: gui.
class DocumentStrokes : public QObject
{
    Q_OBJECT

public:
    explicit DocumentStrokes(Document* document);

public Q_SLOTS:
    void beginStroke(const core::StrokeSettings& settings);
    void addSample(const core::StrokeSample& sample);
    void endStroke(core::StrokeEnd how = {});
    /// Adds a ball as a separate step. A message says why if that is not possible.
    void addSphere(const core::StrokeSettings& settings, const core::StrokeSample& sample);

private:
    void onReport(const StrokeReport& report);
    void addStep(const StrokeReport& report);
    void reportUneditable();
    void reportShortfall(const StrokeReport& report);

    Document* m_document;
};
} // namespace app
