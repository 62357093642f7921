#include "ui/headset/headset_actions.h"

#include "ui/actions/actions.h"
#include "ui/headset/partner_bar.h"
#include "ui/viewport/viewport.h"

#include <QAction>
#include <QCoreApplication>
#include <QKeyEvent>

#include <algorithm>

namespace ui
{
namespace
{
const QString enterId = QStringLiteral("vr.enter"), followId = QStringLiteral("vr.follow"),
              findId = QStringLiteral("vr.status"), pointId = QStringLiteral("vr.point"),
              takeOverId = QStringLiteral("vr.takeOver");
constexpr qint64 heldMs = 400; ///< a key that is down for longer counts as held instead of tapped
} // namespace

HeadsetActions::HeadsetActions(const Parts& parts, QObject* parent)
    : QObject(parent)
    , m_parts(parts)
    , m_enterText(action(enterId)->text())
    , m_takeOverText(action(takeOverId)->text())
{
    connect(action(enterId), &QAction::triggered, this, [this] {
        if (m_state == HeadsetState::In)
            Q_EMIT leaveRequested();
        else
            Q_EMIT enterRequested();
    });
    QAction* follow = action(followId);
    Viewport* viewport = parts.viewport;
    connect(follow, &QAction::toggled, viewport, [follow, viewport](bool on) {
        viewport->navigation()->setFollowing(on);
        follow->setChecked(viewport->navigation()->isFollowing());
    });
    connect(viewport->navigation(), &ViewNavigation::followingChanged, follow, &QAction::setChecked);
    connectPointing();
    connectTakeOver();
    show(HeadsetState::Out);
}

QAction* HeadsetActions::action(const QString& id) const
{
    return m_parts.actions->get(id);
}

void HeadsetActions::connectPointing()
{
    QAction* point = action(pointId);
    point->setAutoRepeat(false);
    connect(point, &QAction::toggled, this, [this](bool on) {
        m_sincePointing.start();
        m_parts.viewport->spotlight()->setOn(on);
    });
    connect(m_parts.viewport->input(), &PointerInput::modeChanged, point,
            [point](PointerMode mode) { point->setChecked(mode == PointerMode::Point); });
    QCoreApplication::instance()->installEventFilter(this);
}

void HeadsetActions::connectTakeOver()
{
    connect(action(takeOverId), &QAction::toggled, this,
            [this](bool on) { m_parts.actions->rename(takeOverId, on ? tr("&Give Back") : m_takeOverText); });
}

/// Stops pointing when the key is released after being held; a tapped key leaves pointing on.
bool HeadsetActions::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::KeyRelease && m_parts.viewport->spotlight()->isOn() &&
        m_sincePointing.elapsed() > heldMs) {
        const auto* key = static_cast<QKeyEvent*>(event);
        QAction* point = action(pointId);
        const QList<QKeySequence> own = point->shortcuts();
        const auto isIts = [key](const QKeySequence& keys) { return keys.count() == 1 && keys[0].key() == key->key(); };
        if (!key->isAutoRepeat() && std::ranges::any_of(own, isIts))
            point->setChecked(false);
    }
    return QObject::eventFilter(watched, event);
}

void HeadsetActions::show(HeadsetState state)
{
    m_state = state;
    const bool isIn = state == HeadsetState::In;
    action(enterId)->setEnabled(state != HeadsetState::Changing);
    action(findId)->setEnabled(state == HeadsetState::Out);
    for (const QString& id : {followId, pointId, takeOverId})
        action(id)->setEnabled(isIn);
    if (state != HeadsetState::Changing)
        m_parts.actions->rename(enterId, isIn ? tr("L&eave VR") : m_enterText);
    m_parts.bar->setWorn(isIn);
    if (isIn)
        return;
    action(pointId)->setChecked(false);
    action(takeOverId)->setChecked(false);
    if (state == HeadsetState::Out)
        m_parts.viewport->showAvatar({});
}
} // namespace ui
