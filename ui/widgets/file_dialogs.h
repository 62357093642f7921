#pragma once

#include <QStringList>

#include <functional>

class QWidget;

namespace ui
{
/// The dialogs for models. They return at once; `answer` is called with a path when one was chosen, and never else.
using PathAnswer = std::function<void(const QString& path)>;

enum class ModelUse { Open, Insert, Brush };
void askForModel(QWidget* parent, ModelUse use, const QString& folder, PathAnswer answer);

// They suggest the model's name. The filter gives the ending if none is typed.
/// First what holds all of the document.
void askForSaving(QWidget* parent, const QString& folder, const QString& modelName, PathAnswer answer);
/// `endings`: of the formats that are offered.
void askForExport(QWidget* parent, const QString& folder, const QString& modelName, const QStringList& endings,
                  PathAnswer answer);

/// `endings`, here and below: of the formats that are offered, the first one suggested.
void askForAlpha(QWidget* parent, const QString& folder, const QStringList& endings, PathAnswer answer);
/// A zip, or the lesson.json of a folder.
void askForLesson(QWidget* parent, PathAnswer answer);
/// Where one is to be written: a zip, or a folder that is not there yet.
void askForLessonTarget(QWidget* parent, const QString& title, PathAnswer answer);
void askForPicture(QWidget* parent, const QString& folder, PathAnswer answer);

/// One that is there.
void askForFolder(QWidget* parent, const QString& folder, PathAnswer answer);
/// Where a class is to be written.
void askForClassFile(QWidget* parent, const QString& folder, PathAnswer answer);

/// For the sheet of drawings.
void askForDrawing(QWidget* parent, const QString& folder, const QString& modelName, const QStringList& endings,
                   PathAnswer answer);

void askForReport(QWidget* parent, const QString& folder, const QStringList& endings, PathAnswer answer);
} // namespace ui
