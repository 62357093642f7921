#pragma once

#include <QStringList>

#include <functional>

class QWidget;

namespace ui
{
/// Called with the path that the user chose. Not called if the dialog is cancelled. The functions below return at once.
using PathCallback = std::function<void(const QString& path)>;

enum class ModelUse { Open, Insert, Brush };
void askForModel(QWidget* parent, ModelUse use, const QString& folder, PathCallback callback);

// The next two functions suggest the model's name. The chosen filter gives the extension if the user types none.
/// Asks where to save the model. The first format suggested is the one that can store the whole document (GLB).
void askForSaving(QWidget* parent, const QString& folder, const QString& modelName, PathCallback callback);
/// Asks where to export the model. `endings`: extensions of the formats offered.
void askForExport(QWidget* parent, const QString& folder, const QString& modelName, const QStringList& endings,
                  PathCallback callback);

/// Asks for an image file. `endings`, here and below: extensions of the formats offered, the suggested one first.
void askForAlpha(QWidget* parent, const QString& folder, const QStringList& endings, PathCallback callback);
/// Asks for a file with a brush preset.
void askForPreset(QWidget* parent, PathCallback callback);
/// Asks where to write a brush preset. `presetName`: suggested name.
void askForPresetTarget(QWidget* parent, const QString& presetName, PathCallback callback);
/// Asks for a lesson: a zip file, or the lesson.json of a folder.
void askForLesson(QWidget* parent, PathCallback callback);
/// Asks where to write a lesson: a zip file, or a new folder. `title`: suggested name.
void askForLessonTarget(QWidget* parent, const QString& title, PathCallback callback);
/// Asks where to write the handout of a lesson, a PDF. `title`: suggested name.
void askForHandout(QWidget* parent, const QString& title, PathCallback callback);
void askForPicture(QWidget* parent, const QString& folder, PathCallback callback);

/// Asks for an existing folder.
void askForFolder(QWidget* parent, const QString& folder, PathCallback callback);
/// Asks for an existing class file.
void askForClass(QWidget* parent, const QString& folder, PathCallback callback);
/// Asks where to write a class file. `title`: suggested name.
void askForClassFile(QWidget* parent, const QString& folder, const QString& title, PathCallback callback);

/// Asks where to write the sheet of drawings.
void askForDrawing(QWidget* parent, const QString& folder, const QString& modelName, const QStringList& endings,
                   PathCallback callback);

void askForReport(QWidget* parent, const QString& folder, const QStringList& endings, PathCallback callback);
} // namespace ui
