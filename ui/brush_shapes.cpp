#include "brush_shapes.h"

#include <algorithm>
#include <utility>

namespace ui
{
namespace
{
constexpr int mostRecent = 6;

void putFirst(QStringList& files, const QString& path)
{
    files.removeAll(path);
    files.prepend(path);
    files.resize(std::min<qsizetype>(files.size(), mostRecent));
}

QString sourceOf(const std::shared_ptr<const core::Alpha>& alpha)
{
    return alpha ? QString::fromStdString(alpha->source()) : QString();
}
} // namespace

BrushShapes::BrushShapes(BrushSettings* brush, Settings* settings, QObject* parent)
    : QObject(parent), m_brush(brush), m_settings(settings), m_stored(settings->shapes())
{
    settings->onReset([this] { restore(); });
}

BrushShapes::~BrushShapes() = default;

void BrushShapes::restore()
{
    m_stored = m_settings->shapes();
    const QString wanted = m_stored.alpha;
    m_brush->set(&core::StrokeSettings::alphaFollows, m_stored.alphaFollows);
    if (wanted.isEmpty() || core::builtInAlpha(wanted.toStdString()))
        chooseAlpha(wanted);
    else
        readAlpha(wanted, Asked::ByRestoring);
    connect(m_brush, &BrushSettings::changed, this, &BrushShapes::keep, Qt::UniqueConnection); // not before: what is stored would be lost
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

void BrushShapes::chooseAlpha(const QString& source)
{
    const auto builtIn = core::builtInAlpha(source.toStdString());
    if (!source.isEmpty() && !builtIn)
        return readAlpha(source, Asked::ByHand);
    ++m_askedAlphas;
    m_isRestoring = false;
    take(builtIn);
}

void BrushShapes::readAlpha(const QString& path, Asked asked)
{
    m_isRestoring = asked == Asked::ByRestoring;
    m_aside.run([path] { return ui::readAlpha(path); }, [this, path, asked, question = ++m_askedAlphas](const BrushFile<core::Alpha>& file) {
        if (question != m_askedAlphas)
            return;
        m_isRestoring = false;
        if (file.what) {
            putFirst(m_stored.alphas, path);
            m_read.insert(path, file.what);
            m_read.removeIf([this](std::pair<const QString&, std::shared_ptr<const core::Alpha>&> read) { return !m_stored.alphas.contains(read.first); });
            take(file.what);
        } else if (asked == Asked::ByHand) {
            m_stored.alphas.removeAll(path);
            m_read.remove(path);
            m_settings->setShapes(m_stored);
            Q_EMIT refused(file.problem);
        }
        Q_EMIT changed();
    });
}

void BrushShapes::chooseModel(const QString& path)
{
    const int question = ++m_askedModels;
    if (path.isEmpty()) {
        m_brush->set(&core::StrokeSettings::model, std::shared_ptr<const core::BrushModel>());
        Q_EMIT changed();
        return;
    }
    m_aside.run([path] { return readBrushModel(path); }, [this, path, question](const BrushFile<core::BrushModel>& file) {
        if (question != m_askedModels)
            return;
        if (file.what) {
            putFirst(m_stored.models, path);
            m_settings->setShapes(m_stored);
            m_brush->set(&core::StrokeSettings::model, file.what);
        } else {
            m_stored.models.removeAll(path);
            m_settings->setShapes(m_stored);
            Q_EMIT refused(file.problem);
        }
        Q_EMIT changed();
    });
}

void BrushShapes::take(const std::shared_ptr<const core::Alpha>& alpha)
{
    m_brush->set(&core::StrokeSettings::alpha, alpha);
    keep();
    Q_EMIT changed();
}

/// While the stored file is being read the brush has none yet, and what is stored stays; whoever gives it one meanwhile has chosen later.
void BrushShapes::keep()
{
    if (m_isRestoring && !m_brush->stroke().alpha)
        return;
    if (std::exchange(m_isRestoring, false))
        ++m_askedAlphas;
    m_stored.alpha = sourceOf(m_brush->stroke().alpha);
    m_stored.alphaFollows = m_brush->stroke().alphaFollows;
    if (m_stored != m_settings->shapes())
        m_settings->setShapes(m_stored);
}
} // namespace ui
