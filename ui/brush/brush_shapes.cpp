#include "ui/brush/brush_shapes.h"

#include <algorithm>
#include <utility>

namespace ui
{
namespace
{
constexpr int maxRecent = 6;

void putFirst(QStringList& files, const QString& path)
{
    files.removeAll(path);
    files.prepend(path);
    files.resize(std::min<qsizetype>(files.size(), maxRecent));
}

template <class What> QString sourceOf(const std::shared_ptr<const What>& shape)
{
    return shape ? QString::fromStdString(shape->source()) : QString();
}
} // namespace

BrushShapes::BrushShapes(BrushSettings* brush, Settings* settings, QObject* parent)
    : QObject(parent)
    , m_brush(brush)
    , m_settings(settings)
    , m_stored(settings->get<StoredShapes>())
{
    settings->onReset([this] { restore(); });
}

BrushShapes::~BrushShapes() = default;

void BrushShapes::restore()
{
    m_stored = m_settings->get<StoredShapes>();
    const StoredShapes wanted = m_stored;
    m_brush->set(&core::StrokeSettings::alphaFollows, wanted.alphaFollows);
    m_alpha.isRestoring = m_model.isRestoring = true; // neither goes while the other is taken
    if (const auto builtIn = core::builtInAlpha(wanted.alpha.toStdString()))
        setShape(m_alpha, builtIn);
    else
        choose(m_alpha, wanted.alpha, Origin::Restore);
    choose(m_model, wanted.model, Origin::Restore);
    connect(m_brush, &BrushSettings::changed, this, &BrushShapes::save,
            Qt::UniqueConnection); // not before: what is stored would be lost
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
    if (const auto builtIn = core::builtInAlpha(source.toStdString()))
        setShape(m_alpha, builtIn);
    else
        choose(m_alpha, source, Origin::User);
}

void BrushShapes::chooseModel(const QString& path)
{
    choose(m_model, path, Origin::User);
}

template <class What> void BrushShapes::choose(ShapeSlot<What>& slot, const QString& path, Origin origin)
{
    if (path.isEmpty())
        return setShape(slot, std::shared_ptr<const What>());
    slot.isRestoring = origin == Origin::Restore;
    const int request = ++slot.request;
    m_background.run([path, read = slot.read] { return read(path); },
                     [this, &slot, path, origin, request](const BrushFile<What>& file) {
                         if (request != slot.request)
                             return;
                         if (!file.what)
                             return refuse(slot, path, origin, file.problem);
                         putFirst(m_stored.*slot.files, path);
                         remember(path, file.what);
                         setShape(slot, file.what);
                     });
}

template <class What> void BrushShapes::setShape(ShapeSlot<What>& slot, const std::shared_ptr<const What>& what)
{
    ++slot.request;
    slot.isRestoring = false;
    m_brush->set(slot.inBrush, what);
    save();
    Q_EMIT changed();
}

/// Drops a refused file that the user chose from the list; a stored file stays, as its disk may only be unmounted.
template <class What>
void BrushShapes::refuse(ShapeSlot<What>& slot, const QString& path, Origin origin, const QString& problem)
{
    slot.isRestoring = false;
    if (origin == Origin::User) {
        (m_stored.*slot.files).removeAll(path);
        m_read.remove(path);
    }
    save();
    Q_EMIT refused(origin == Origin::User ? problem : missingFileMessage(static_cast<What*>(nullptr)).arg(problem));
    Q_EMIT changed();
}

QString BrushShapes::missingFileMessage(const core::Alpha*) const
{
    return tr("The brush is without its alpha: %1", "a sentence that says why");
}

QString BrushShapes::missingFileMessage(const core::BrushModel*) const
{
    return tr("Stamp has a ball again: %1", "a sentence that says why");
}

void BrushShapes::remember(const QString& path, const std::shared_ptr<const core::Alpha>& alpha)
{
    m_read.insert(path, alpha);
    m_read.removeIf([this](std::pair<const QString&, std::shared_ptr<const core::Alpha>&> read) {
        return !m_stored.alphas.contains(read.first);
    });
}

/// While the stored file is being read the brush has none yet, and what is stored stays; whoever gives it one meanwhile
/// has chosen later.
template <class What> void BrushShapes::store(ShapeSlot<What>& slot)
{
    const std::shared_ptr<const What>& shape = m_brush->stroke().*slot.inBrush;
    if (slot.isRestoring && !shape)
        return;
    if (std::exchange(slot.isRestoring, false))
        ++slot.request;
    m_stored.*slot.chosen = sourceOf(shape);
}

void BrushShapes::save()
{
    store(m_alpha);
    store(m_model);
    m_stored.alphaFollows = m_brush->stroke().alphaFollows;
    if (m_stored != m_settings->get<StoredShapes>())
        m_settings->set(m_stored);
}
} // namespace ui
