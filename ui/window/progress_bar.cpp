#include "ui/window/progress_bar.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>

namespace ui
{
namespace
{
constexpr int progressSteps = 100;
} // namespace

ProgressBar::ProgressBar(QAction* stop, QWidget* parent)
    : QWidget(parent)
    , m_what(new QLabel)
    , m_progress(new QProgressBar)
    , m_stop(new QToolButton)
{
    m_what->setObjectName(QStringLiteral("busyText"));
    m_progress->setMaximumSize(120, 12);
    m_progress->setTextVisible(false);
    m_stop->setDefaultAction(stop);
    m_stop->setAutoRaise(true);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    for (QWidget* part : std::initializer_list<QWidget*>{m_what, m_progress, m_stop})
        row->addWidget(part);
    end();
}

void ProgressBar::begin(const QString& what)
{
    m_what->setText(what);
    if (isHidden()) {
        m_progress->setRange(0, 0);
        show();
    }
    Q_EMIT activeChanged(true);
}

void ProgressBar::setProgress(double share)
{
    m_progress->setRange(0, progressSteps);
    m_progress->setValue(static_cast<int>(share * progressSteps));
}

void ProgressBar::setStoppable(bool canStop)
{
    m_stop->defaultAction()->setEnabled(canStop);
    m_stop->setVisible(canStop);
}

void ProgressBar::end()
{
    setStoppable(false);
    hide();
    Q_EMIT activeChanged(false);
}
} // namespace ui
