#include "ui/widgets/file_dialogs.h"

#include "ui/util/format_filters.h"
#include "ui/widgets/name_icons.h"
#include "ui/widgets/named.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QImageReader>
#include <QStringList>

#include <algorithm>

namespace ui
{
namespace
{
class FileDialogs
{
    Q_DECLARE_TR_FUNCTIONS(ui::FileDialogs)
};

/// Returns the filter of an extension: "STL (*.stl)".
QString filterOf(const QString& ending)
{
    return QStringLiteral("%1 (*.%2)").arg(ending.toUpper(), ending);
}

QFileDialog* makeDialog(QWidget* parent, const QString& title, QAnyStringView name, const QString& folder = {})
{
    static NameIcons icons; // static, because dialogs do not own their icon provider
    auto* dialog = named(new QFileDialog(parent, title, folder), name);
    dialog->setIconProvider(&icons);
    return dialog;
}

void show(QFileDialog* dialog, const PathCallback& callback)
{
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    QObject::connect(dialog, &QFileDialog::fileSelected, dialog, [callback](const QString& path) { callback(path); });
    dialog->open();
}

/// Asks for a file to write. The chosen filter gives the extension if the user types none.
void askForTarget(QWidget* parent, const QString& title, const QString& name, const QString& folder,
                  const QString& modelName, const QStringList& endings, const PathCallback& callback)
{
    QFileDialog* dialog = makeDialog(parent, title, name, folder);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    QStringList filters;
    for (const QString& ending : endings)
        filters << filterOf(ending);
    dialog->setNameFilters(filters);
    dialog->setDefaultSuffix(endings.constFirst());
    dialog->selectFile(QFileInfo(modelName).completeBaseName());
    QObject::connect(dialog, &QFileDialog::filterSelected, dialog, [dialog, endings](const QString& filter) {
        for (const QString& ending : endings)
            if (filter == filterOf(ending))
                dialog->setDefaultSuffix(ending);
    });
    show(dialog, callback);
}

void askForImage(QWidget* parent, const QString& title, const QString& name, const QString& folder,
                 const QStringList& endings, const PathCallback& callback)
{
    QFileDialog* dialog = makeDialog(parent, title, name, folder);
    dialog->setFileMode(QFileDialog::ExistingFile);
    QStringList patterns;
    for (const QString& ending : endings)
        patterns << QStringLiteral("*.") + ending;
    dialog->setNameFilters({FileDialogs::tr("Images (%1)").arg(patterns.join(u' ')), FileDialogs::tr("All files (*)")});
    show(dialog, callback);
}
} // namespace

void askForModel(QWidget* parent, ModelUse use, const QString& folder, PathCallback callback)
{
    const QString title = use == ModelUse::Insert  ? FileDialogs::tr("Insert a Model")
                          : use == ModelUse::Brush ? FileDialogs::tr("Choose the Brush's Shape")
                                                   : FileDialogs::tr("Open a Model");
    QFileDialog* dialog = makeDialog(parent, title, "openDialog", folder);
    dialog->setFileMode(QFileDialog::ExistingFile);
    dialog->setOption(QFileDialog::HideNameFilterDetails); // too many extensions to show
    const QString patterns = QStringLiteral("*.") + modelEndings().join(QStringLiteral(" *."));
    QStringList filters{FileDialogs::tr("Models (%1)").arg(patterns), FileDialogs::tr("All files (*)")};
    if (use == ModelUse::Open)
        filters.insert(1, FileDialogs::tr("Classes (%1)").arg(QStringLiteral("*.") + classEnding()));
    dialog->setNameFilters(filters);
    show(dialog, callback);
}

void askForSaving(QWidget* parent, const QString& folder, const QString& modelName, PathCallback callback)
{
    QStringList all = writtenEndings();
    std::ranges::stable_partition(all, [](const QString& ending) { return ending == QLatin1StringView("glb"); });
    askForTarget(parent, FileDialogs::tr("Save the Model"), QStringLiteral("saveDialog"), folder, modelName, all,
                 callback);
}

void askForExport(QWidget* parent, const QString& folder, const QString& modelName, const QStringList& endings,
                  PathCallback callback)
{
    askForTarget(parent, FileDialogs::tr("Export the Model"), QStringLiteral("exportDialog"), folder, modelName,
                 endings, callback);
}

void askForAlpha(QWidget* parent, const QString& folder, const QStringList& endings, PathCallback callback)
{
    askForImage(parent, FileDialogs::tr("Choose an Alpha"), QStringLiteral("alphaDialog"), folder, endings, callback);
}

void askForPreset(QWidget* parent, PathCallback callback)
{
    QFileDialog* dialog = makeDialog(parent, FileDialogs::tr("Import a Brush Preset"), "presetDialog");
    dialog->setFileMode(QFileDialog::ExistingFile);
    dialog->setNameFilter(FileDialogs::tr("Brush presets (%1)").arg(QStringLiteral("*.json")));
    show(dialog, callback);
}

void askForPresetTarget(QWidget* parent, const QString& presetName, PathCallback callback)
{
    askForTarget(parent, FileDialogs::tr("Export the Brush Preset"), QStringLiteral("presetTargetDialog"), {},
                 presetName, {QStringLiteral("json")}, callback);
}

void askForLesson(QWidget* parent, PathCallback callback)
{
    QFileDialog* dialog = makeDialog(parent, FileDialogs::tr("Open a Lesson"), "lessonDialog");
    dialog->setFileMode(QFileDialog::ExistingFile);
    dialog->setNameFilter(FileDialogs::tr("Lessons (%1)").arg(QStringLiteral("*.zip lesson.json")));
    show(dialog, callback);
}

void askForLessonTarget(QWidget* parent, const QString& title, PathCallback callback)
{
    const QString zip = QStringLiteral("zip"), file = FileDialogs::tr("One file (%1)").arg(QStringLiteral("*.zip")),
                  folder = FileDialogs::tr("A folder (*)");
    QFileDialog* dialog = makeDialog(parent, FileDialogs::tr("Save the Lesson"), "lessonTargetDialog");
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setNameFilters({file, folder});
    dialog->setDefaultSuffix(zip);
    dialog->selectFile(title);
    QObject::connect(dialog, &QFileDialog::filterSelected, dialog, [dialog, zip, file](const QString& filter) {
        dialog->setDefaultSuffix(filter == file ? zip : QString());
    });
    show(dialog, callback);
}

void askForHandout(QWidget* parent, const QString& title, PathCallback callback)
{
    const QString pdf = QStringLiteral("pdf");
    askForTarget(parent, FileDialogs::tr("Write the Handout"), QStringLiteral("handoutDialog"), {}, title + u'.' + pdf,
                 {pdf}, callback);
}

void askForPicture(QWidget* parent, const QString& folder, PathCallback callback)
{
    QStringList endings;
    for (const QByteArray& ending : QImageReader::supportedImageFormats())
        endings << QLatin1StringView(ending);
    askForImage(parent, FileDialogs::tr("Choose a Reference Image"), QStringLiteral("pictureDialog"), folder, endings,
                callback);
}

void askForFolder(QWidget* parent, const QString& folder, PathCallback callback)
{
    QFileDialog* dialog = makeDialog(parent, FileDialogs::tr("Choose a Folder"), "folderDialog", folder);
    dialog->setFileMode(QFileDialog::Directory);
    dialog->setOption(QFileDialog::ShowDirsOnly);
    show(dialog, callback);
}

void askForClass(QWidget* parent, const QString& folder, PathCallback callback)
{
    QFileDialog* dialog = makeDialog(parent, FileDialogs::tr("Open a Class"), "openClassDialog", folder);
    dialog->setFileMode(QFileDialog::ExistingFile);
    dialog->setNameFilters({FileDialogs::tr("Classes (%1)").arg(QStringLiteral("*.%1 *.ini").arg(classEnding())),
                            FileDialogs::tr("All files (*)")});
    show(dialog, callback);
}

void askForClassFile(QWidget* parent, const QString& folder, const QString& title, PathCallback callback)
{
    const QString name = QString(title).replace(u'/', u'-') + u'.' + classEnding();
    askForTarget(parent, FileDialogs::tr("Save the Class"), QStringLiteral("classDialog"), folder, name,
                 {classEnding()}, callback);
}

void askForDrawing(QWidget* parent, const QString& folder, const QString& modelName, const QStringList& endings,
                   PathCallback callback)
{
    askForTarget(parent, FileDialogs::tr("Export the Drawing"), QStringLiteral("drawingDialog"), folder, modelName,
                 endings, callback);
}

void askForReport(QWidget* parent, const QString& folder, const QStringList& endings, PathCallback callback)
{
    askForTarget(parent, FileDialogs::tr("Write the Class Report"), QStringLiteral("reportDialog"), folder,
                 FileDialogs::tr("Class report"), endings, callback);
}
} // namespace ui
