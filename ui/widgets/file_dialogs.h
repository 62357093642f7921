#pragma once

#include <QStringList>

#include <functional>

class QWidget;

namespace ui
{
/// The dialogs for models. They return at once; `callback` is called with a path when one was chosen, and never else.
using PathCallback = std::function<void(const QString& path)>;

enum class ModelUse { Open, Insert, Brush };
void askForModel(QWidget* parent, ModelUse use, const QString& folder, PathCallback callback);

// They suggest the model's name. The filter gives the ending if none is typed.
/// First what holds all of the document.
void askForSaving(QWidget* parent, const QString& folder, const QString& modelName, PathCallback callback);
/// `endings`: of the formats that are offered.
void askForExport(QWidget* parent, const QString& folder, const QString& modelName, const QStringList& endings,
                  PathCallback callback);

/// `endings`, here and below: of the formats that are offered, the first one suggested.
void askForAlpha(QWidget* parent, const QString& folder, const QStringList& endings, PathCallback callback);
/// Asks for a preset of a brush.
void askForPreset(QWidget* parent, PathCallback callback);
/// Asks where a preset of that name is to be written.
void askForPresetTarget(QWidget* parent, const QString& presetName, PathCallback callback);
/// A zip, or the lesson.json of a folder.
void askForLesson(QWidget* parent, PathCallback callback);
/// Where one is to be written: a zip, or a folder that is not there yet.
void askForLessonTarget(QWidget* parent, const QString& title, PathCallback callback);
/// Asks where the handout of a lesson is to be written: a PDF. `title`: the name that is offered.
void askForHandout(QWidget* parent, const QString& title, PathCallback callback);
void askForPicture(QWidget* parent, const QString& folder, PathCallback callback);

/// One that is there.
void askForFolder(QWidget* parent, const QString& folder, PathCallback callback);
/// A class that is there.
void askForClass(QWidget* parent, const QString& folder, PathCallback callback);
/// Asks where a class is to be written. `title`: the name that is offered.
void askForClassFile(QWidget* parent, const QString& folder, const QString& title, PathCallback callback);

/// For the sheet of drawings.
void askForDrawing(QWidget* parent, const QString& folder, const QString& modelName, const QStringList& endings,
                   PathCallback callback);

void askForReport(QWidget* parent, const QString& folder, const QStringList& endings, PathCallback callback);
} // namespace ui
