#include "headset_actions.h"

#include "actions.h"
#include "viewport.h"

#include <QAction>

namespace ui
{
namespace
{
const QString enterId = QStringLiteral("vr.enter"), followId = QStringLiteral("vr.follow"),
              findId = QStringLiteral("vr.status");
} // namespace

HeadsetActions::HeadsetActions(Actions& actions, Viewport* viewport, QObject* parent)
    : QObject(parent)
    , m_actions(actions)
    , m_viewport(viewport)
    , m_enterText(actions.get(enterId)->text())
{
    connect(actions.get(enterId), &QAction::triggered, this, [this] {
        if (m_state == HeadsetState::In)
            Q_EMIT leaveRequested();
        else
            Q_EMIT enterRequested();
    });
    QAction* follow = actions.get(followId);
    connect(follow, &QAction::toggled, viewport, [follow, viewport](bool on) {
        viewport->setFollowing(on);
        follow->setChecked(viewport->isFollowing());
    });
    connect(viewport, &Viewport::followingChanged, follow, &QAction::setChecked);
    show(HeadsetState::Out);
}

void HeadsetActions::show(HeadsetState state)
{
    m_state = state;
    m_actions.get(enterId)->setEnabled(state != HeadsetState::Changing);
    m_actions.get(followId)->setEnabled(state == HeadsetState::In);
    m_actions.get(findId)->setEnabled(state == HeadsetState::Out);
    if (state != HeadsetState::Changing)
        m_actions.rename(enterId, state == HeadsetState::In ? tr("L&eave VR") : m_enterText);
    if (state == HeadsetState::Out)
        m_viewport->showWearer({});
}
} // namespace ui
