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

/// The strokes of a document: those at the desktop on their way to the worker, and what the worker reports of any.
/// Thread: gui.
class DocumentStrokes : public QObject
{
    Q_OBJECT

public:
    explicit DocumentStrokes(Document* document);

public Q_SLOTS:
    void beginStroke(const core::StrokeSettings& settings);
    void addSample(const core::StrokeSample& sample);
    void endStroke(core::StrokeEnd how = {});
    /// A step of its own: adds a ball, or a notice says why not.
    void addSphere(const core::StrokeSettings& settings, const core::StrokeSample& sample);

private:
    void onReport(const StrokeReport& report);
    void addStep(const StrokeReport& report);
    void reportShortfall(const StrokeReport& report);

    Document* m_document;
};
} // namespace app
