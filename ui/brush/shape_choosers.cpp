#include "ui/brush/shape_choosers.h"

#include "ui/brush/brush_files.h"
#include "ui/brush/brush_shapes.h"
#include "ui/widgets/file_dialogs.h"
#include "ui/widgets/named.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QFileInfo>
#include <QImage>
#include <QPixmap>
#include <QSignalBlocker>

#include <algorithm>
#include <functional>

namespace ui
{
namespace
{
struct ShapeChoosers
{
    Q_DECLARE_TR_FUNCTIONS(ui::ShapeChoosers)
};

constexpr int picturePixels = 22;
/// Data of the entry "load a file"; cannot be a source or a path.
const QString loadEntry = QStringLiteral("\n");
/// Data of the entry "the document's model"
const QString ownModelEntry = QStringLiteral("\nown");

QString nameOf(std::string_view builtIn)
{
    const std::pair<std::string_view, QString> names[] = {
        {"pores", ShapeChoosers::tr("Pores")},     {"scales", ShapeChoosers::tr("Scales")},
        {"cracks", ShapeChoosers::tr("Cracks")},   {"weave", ShapeChoosers::tr("Weave")},
        {"stripes", ShapeChoosers::tr("Stripes")}, {"noise", ShapeChoosers::tr("Noise")},
        {"ring", ShapeChoosers::tr("Ring")},       {"star", ShapeChoosers::tr("Star")}};
    const auto found = std::ranges::find(names, builtIn, [](const auto& row) { return row.first; });
    return found != std::end(names) ? found->second
                                    : QString::fromUtf8(builtIn.data(), static_cast<qsizetype>(builtIn.size()));
}

QIcon pictureOf(const std::shared_ptr<const core::Alpha>& alpha)
{
    if (!alpha)
        return {};
    const QImage image(alpha->pixels().data(), alpha->width(), alpha->height(), alpha->width(),
                       QImage::Format_Grayscale8);
    return QPixmap::fromImage(
        image.scaled(2 * picturePixels, 2 * picturePixels, Qt::KeepAspectRatio, Qt::SmoothTransformation));
}

QString alphaOf(const BrushSettings& brush)
{
    return brush.stroke().alpha ? QString::fromStdString(brush.stroke().alpha->source()) : QString();
}

QString modelOf(const BrushSettings& brush)
{
    return brush.stroke().model ? QString::fromStdString(brush.stroke().model->source()) : QString();
}

/// Adds an entry for each file, named by its file name. Adds the chosen file too if it is missing.
void addFiles(QComboBox* box, const QStringList& files, const QString& chosen,
              const std::function<QIcon(const QString&)>& pictureOf)
{
    const bool isNew = !chosen.isEmpty() && !files.contains(chosen) && box->findData(chosen) < 0;
    for (const QString& file : isNew ? files + QStringList(chosen) : files) {
        box->addItem(pictureOf(file), QFileInfo(file).fileName(), file);
        box->setItemData(box->count() - 1, file, Qt::ToolTipRole);
    }
}

QComboBox* chooser(const QString& name, const QString& text, const QString& tip)
{
    auto* box = named(new QComboBox, name, tip, text);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(8);
    return box;
}
} // namespace

QComboBox* alphaChooser(BrushSettings* brush, BrushShapes* shapes)
{
    QComboBox* box = chooser(QStringLiteral("alpha"), ShapeChoosers::tr("Alpha"),
                             ShapeChoosers::tr("An image that weights the brush: white is full strength, black is "
                                               "none. A spacing of 2 places prints side by side."));
    box->setIconSize({picturePixels, picturePixels});
    const auto fill = [=] {
        const QSignalBlocker quiet(box);
        box->clear();
        box->addItem(ShapeChoosers::tr("None"), QString());
        for (const std::string_view builtIn : core::builtInAlphas())
            box->addItem(pictureOf(core::builtInAlpha(builtIn)), nameOf(builtIn),
                         QString::fromUtf8(builtIn.data(), static_cast<qsizetype>(builtIn.size())));
        addFiles(box, shapes->alphas(), alphaOf(*brush),
                 [shapes](const QString& file) { return pictureOf(shapes->alpha(file)); });
        if (shapes->mayLoad())
            box->addItem(ShapeChoosers::tr("Load Image…"), loadEntry);
        box->setCurrentIndex(box->findData(alphaOf(*brush)));
    };
    const auto show = [=] {
        const int chosen = box->findData(alphaOf(*brush));
        chosen < 0 ? fill() : box->setCurrentIndex(chosen);
        box->setEnabled(core::usesAlpha(brush->tool()));
    };
    QObject::connect(box, &QComboBox::activated, shapes, [=] {
        const QString source = box->currentData().toString();
        show(); // shows the old choice until the file has been read
        if (source != loadEntry)
            return shapes->chooseAlpha(source);
        askForAlpha(box->window(), Settings().lastFolder(), alphaEndings(),
                    [shapes](const QString& path) { shapes->chooseAlpha(path); });
    });
    QObject::connect(brush, &BrushSettings::changed, box, show);
    QObject::connect(shapes, &BrushShapes::changed, box, fill);
    fill();
    return box;
}

QComboBox* modelChooser(BrushSettings* brush, BrushShapes* shapes)
{
    QComboBox* box = chooser(
        QStringLiteral("stampShape"), ShapeChoosers::tr("Stamp"),
        ShapeChoosers::tr("The model that Stamp presses in or raises, with its top outwards, and that Add Ball adds."));
    const auto fill = [=] {
        const QSignalBlocker quiet(box);
        box->clear();
        box->addItem(ShapeChoosers::tr("Ball"), QString());
        addFiles(box, shapes->models(), modelOf(*brush), [](const QString&) { return QIcon(); });
        if (shapes->mayLoad()) {
            box->addItem(ShapeChoosers::tr("This Model"), ownModelEntry);
            box->setItemData(box->count() - 1, ShapeChoosers::tr("The model that you sculpt, as it is now."),
                             Qt::ToolTipRole);
            box->addItem(ShapeChoosers::tr("Load Model…"), loadEntry);
        }
        box->setCurrentIndex(box->findData(modelOf(*brush)));
    };
    const auto show = [=] {
        const int chosen = box->findData(modelOf(*brush));
        chosen < 0 ? fill() : box->setCurrentIndex(chosen);
    };
    QObject::connect(box, &QComboBox::activated, shapes, [=] {
        const QString path = box->currentData().toString();
        show();
        if (path == ownModelEntry)
            return shapes->chooseOwnModel();
        if (path != loadEntry)
            return shapes->chooseModel(path);
        askForModel(box->window(), ModelUse::Brush, Settings().lastFolder(),
                    [shapes](const QString& chosen) { shapes->chooseModel(chosen); });
    });
    QObject::connect(brush, &BrushSettings::changed, box, show);
    QObject::connect(shapes, &BrushShapes::changed, box, fill);
    fill();
    return box;
}
} // namespace ui
