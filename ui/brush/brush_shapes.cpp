#include "ui/brush/brush_shapes.h"

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

template <class What> QString sourceOf(const std::shared_ptr<const What>& shape)
{
    return shape ? QString::fromStdString(shape->source()) : QString();
}
} // namespace

BrushShapes::BrushShapes(BrushSettings* brush, Settings* settings, QObject* parent)
    : QObject(parent)
    , m_brush(brush)
    , m_settings(settings)
    , m_stored(settings->shapes())
{
    settings->onReset([this] { restore(); });
}

BrushShapes::~BrushShapes() = default;

void BrushShapes::restore()
{
    m_stored = m_settings->shapes();
    const StoredShapes wanted = m_stored;
    m_brush->set(&core::StrokeSettings::alphaFollows, wanted.alphaFollows);
    m_alpha.isRestoring = m_model.isRestoring = true; // neither goes while the other is taken
    if (const auto builtIn = core::builtInAlpha(wanted.alpha.toStdString()))
        take(m_alpha, builtIn);
    else
        choose(m_alpha, wanted.alpha, Asked::ByRestoring);
    choose(m_model, wanted.model, Asked::ByRestoring);
    connect(m_brush, &BrushSettings::changed, this, &BrushShapes::keep,
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
        take(m_alpha, builtIn);
    else
        choose(m_alpha, source, Asked::ByHand);
}

void BrushShapes::chooseModel(const QString& path)
{
    choose(m_model, path, Asked::ByHand);
}

template <class What> void BrushShapes::choose(Choice<What>& choice, const QString& path, Asked asked)
{
    if (path.isEmpty())
        return take(choice, std::shared_ptr<const What>());
    choice.isRestoring = asked == Asked::ByRestoring;
    const int question = ++choice.question;
    m_aside.run([path, read = choice.read] { return read(path); },
                [this, &choice, path, asked, question](const BrushFile<What>& file) {
                    if (question != choice.question)
                        return;
                    if (!file.what)
                        return refuse(choice, path, asked, file.problem);
                    putFirst(m_stored.*choice.files, path);
                    remember(path, file.what);
                    take(choice, file.what);
                });
}

template <class What> void BrushShapes::take(Choice<What>& choice, const std::shared_ptr<const What>& what)
{
    ++choice.question;
    choice.isRestoring = false;
    m_brush->set(choice.inBrush, what);
    keep();
    Q_EMIT changed();
}

/// What a hand chose and was refused is not offered again; a stored file may only be away.
template <class What>
void BrushShapes::refuse(Choice<What>& choice, const QString& path, Asked asked, const QString& problem)
{
    choice.isRestoring = false;
    if (asked == Asked::ByHand) {
        (m_stored.*choice.files).removeAll(path);
        m_read.remove(path);
    }
    keep();
    Q_EMIT refused(asked == Asked::ByHand ? problem : goneWord(static_cast<What*>(nullptr)).arg(problem));
    Q_EMIT changed();
}

QString BrushShapes::goneWord(const core::Alpha*) const
{
    return tr("The brush is without its alpha: %1", "a sentence that says why");
}

QString BrushShapes::goneWord(const core::BrushModel*) const
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
template <class What> void BrushShapes::note(Choice<What>& choice)
{
    const std::shared_ptr<const What>& shape = m_brush->stroke().*choice.inBrush;
    if (choice.isRestoring && !shape)
        return;
    if (std::exchange(choice.isRestoring, false))
        ++choice.question;
    m_stored.*choice.chosen = sourceOf(shape);
}

void BrushShapes::keep()
{
    note(m_alpha);
    note(m_model);
    m_stored.alphaFollows = m_brush->stroke().alphaFollows;
    if (m_stored != m_settings->shapes())
        m_settings->setShapes(m_stored);
}
} // namespace ui
