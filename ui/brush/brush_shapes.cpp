#include "ui/brush/brush_shapes.h"

#include <algorithm>
#include <utility>

namespace ui
{
namespace
{
constexpr int maxRecent = 6;
/// Spacing of dabs at which adjacent prints of an alpha do not overlap, in radii.
constexpr double printSpacing = 2;

void putFirst(QStringList& files, const QString& path)
{
    files.removeAll(path);
    files.prepend(path);
    files.resize(std::min<qsizetype>(files.size(), maxRecent));
}

QString sourceOf(const std::shared_ptr<const core::BrushModel>& model)
{
    return model ? QString::fromStdString(model->source()) : QString();
}
} // namespace

BrushShapes::BrushShapes(BrushSettings* brush, Settings* settings, QObject* parent)
    : QObject(parent)
    , m_brush(brush)
    , m_settings(settings)
    , m_stored(settings->get<StoredShapes>())
    , m_alphas(brush->tools(), settings)
{
    settings->onReset([this] { restore(); });
    connect(&m_alphas, &ToolAlphas::fileRead, this,
            [this](const QString& path, const std::shared_ptr<const core::Alpha>& alpha) {
                putFirst(m_stored.alphas, path);
                remember(path, alpha);
                save();
                Q_EMIT changed();
            });
    connect(&m_alphas, &ToolAlphas::fileRefused, this, [this](const QString& problem) {
        save();
        Q_EMIT refused(tr("The brush is without its alpha: %1", "a sentence that says why").arg(problem));
        Q_EMIT changed();
    });
}

BrushShapes::~BrushShapes() = default;

void BrushShapes::restore()
{
    m_stored = m_settings->get<StoredShapes>();
    const StoredShapes wanted = m_stored;
    ++m_alphaRequest;
    m_alphas.restore({wanted.alpha, wanted.alphaFollows});
    readModel(wanted.model, Origin::Restore);
    connect(m_brush, &BrushSettings::changed, this, &BrushShapes::save,
            Qt::UniqueConnection); // not connected earlier: save() would overwrite the stored choice
    Q_EMIT changed();
}

void BrushShapes::setMayLoad(bool mayLoad)
{
    m_mayLoad = mayLoad;
    Q_EMIT changed();
}

std::shared_ptr<const core::Alpha> BrushShapes::alpha(const QString& source) const
{
    const auto builtIn = core::builtInAlpha(source.toStdString());
    return builtIn ? builtIn : m_read.value(source);
}

void BrushShapes::chooseAlpha(const QString& source, AlphaSpacing spacing)
{
    const core::Tool tool = m_brush->tool();
    const int request = ++m_alphaRequest;
    if (const auto builtIn = core::builtInAlpha(source.toStdString()); builtIn || source.isEmpty())
        return setAlpha(tool, builtIn, spacing);
    m_background.run([source] { return readAlpha(source); },
                     [this, source, tool, request, spacing](const BrushFile<core::Alpha>& file) {
                         if (request != m_alphaRequest)
                             return;
                         if (!file.what) {
                             m_read.remove(source);
                             return refuse(&StoredShapes::alphas, source, file.problem);
                         }
                         putFirst(m_stored.alphas, source);
                         remember(source, file.what);
                         setAlpha(tool, file.what, spacing);
                     });
}

void BrushShapes::setAlpha(core::Tool tool, const std::shared_ptr<const core::Alpha>& alpha, AlphaSpacing spacing)
{
    m_alphas.forget(tool);
    ToolValues values = m_brush->tools()->of(tool);
    if (spacing == AlphaSpacing::Readable && alpha && !values.alpha)
        values.spacing = printSpacing;
    if (spacing == AlphaSpacing::Readable && !alpha && values.alpha && values.spacing == printSpacing)
        values.spacing = defaultSpacing;
    values.alpha = alpha;
    m_brush->tools()->set(tool, values);
    save();
    Q_EMIT changed();
}

void BrushShapes::chooseModel(const QString& path)
{
    readModel(path, Origin::User);
}

void BrushShapes::readModel(const QString& path, Origin origin)
{
    const int request = ++m_modelRequest;
    if (path.isEmpty())
        return setModel(nullptr);
    m_isRestoringModel = origin == Origin::Restore;
    m_background.run([path] { return readBrushModel(path); },
                     [this, path, origin, request](const BrushFile<core::BrushModel>& file) {
                         if (request != m_modelRequest)
                             return;
                         if (file.what) {
                             putFirst(m_stored.models, path);
                             return setModel(file.what);
                         }
                         m_isRestoringModel = false;
                         if (origin == Origin::User)
                             return refuse(&StoredShapes::models, path, file.problem);
                         save();
                         Q_EMIT refused(tr("Stamp has a ball again: %1", "a sentence that says why").arg(file.problem));
                         Q_EMIT changed();
                     });
}

void BrushShapes::setModel(const std::shared_ptr<const core::BrushModel>& model)
{
    ++m_modelRequest;
    m_isRestoringModel = false;
    m_brush->set(&core::StrokeSettings::model, model);
    save();
    Q_EMIT changed();
}

/// Reports a refused file that the user chose and removes it from the recent files. Not used for files restored at the
/// start, which stay in the list because their disk may only be unmounted.
void BrushShapes::refuse(QStringList StoredShapes::*files, const QString& path, const QString& problem)
{
    (m_stored.*files).removeAll(path);
    save();
    Q_EMIT refused(problem);
    Q_EMIT changed();
}

void BrushShapes::remember(const QString& path, const std::shared_ptr<const core::Alpha>& alpha)
{
    m_read.insert(path, alpha);
    m_read.removeIf([this](std::pair<const QString&, std::shared_ptr<const core::Alpha>&> read) {
        return !m_stored.alphas.contains(read.first);
    });
}

/// Updates the stored choice of the model. It stays while the stored file is being read, because the brush has no model
/// yet. If the user has chosen a model meanwhile, that one is stored and the result of reading is dropped.
void BrushShapes::storeModel()
{
    const std::shared_ptr<const core::BrushModel>& model = m_brush->stroke().model;
    if (m_isRestoringModel && !model)
        return;
    if (std::exchange(m_isRestoringModel, false))
        ++m_modelRequest;
    m_stored.model = sourceOf(model);
}

/// Saves alphas and model. Pull's alpha is also written to the old key, which versions with one alpha for all tools
/// read.
void BrushShapes::save()
{
    m_alphas.save();
    const StoredToolAlpha& ofFirst = m_alphas.stored(core::Tool::Pull);
    m_stored.alpha = ofFirst.alpha;
    m_stored.alphaFollows = ofFirst.alphaFollows;
    storeModel();
    if (m_stored != m_settings->get<StoredShapes>())
        m_settings->set(m_stored);
}
} // namespace ui
