#include "ui/history/time_lapse_dialog.h"

#include "ui/widgets/dialog_helpers.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QDialog>
#include <QFormLayout>
#include <QLabel>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>

namespace ui
{
namespace
{
constexpr int textWidth = 340;
constexpr QSize sizes[] = {{1920, 1080}, {1280, 720}, {1080, 1080}};

class TimeLapseDialog : public QDialog
{
    Q_DECLARE_TR_FUNCTIONS(ui::TimeLapseDialog)

public:
    TimeLapseDialog(QWidget* parent, int steps) : QDialog(parent), m_size(new QComboBox), m_every(new QSpinBox)
    {
        QVBoxLayout* column = beginDialog(this, "timeLapse", tr("Export Time-Lapse"));
        column->setSpacing(dialogMargin);
        column->addWidget(dialogText(tr("Draws the model after each step, from the current view, as numbered PNG files "
                                        "in a folder that you choose. Sculpting is paused while it runs."),
                                     textWidth));
        auto* form = new QFormLayout;
        form->setSpacing(dialogGap);
        column->addLayout(form);
        m_size->setObjectName(QStringLiteral("frameSize"));
        for (const QSize& size : sizes)
            m_size->addItem(tr("%1 × %2 pixels").arg(size.width()).arg(size.height()), size);
        form->addRow(tr("&Size:"), m_size);
        m_every->setObjectName(QStringLiteral("everySteps"));
        m_every->setRange(1, std::max(1, steps));
        form->addRow(tr("Steps per &picture:"), m_every);
        auto* count = new QLabel;
        count->setObjectName(QStringLiteral("frameCount"));
        const auto show = [this, count, steps] {
            count->setText(tr("%Ln pictures", nullptr, (steps + m_every->value() - 1) / m_every->value() + 1));
        };
        connect(m_every, &QSpinBox::valueChanged, count, show);
        show();
        form->addRow(QString(), count);
        addDialogButtons(this, tr("&Choose Folder…"));
    }

    TimeLapseSettings options() const
    {
        const QSize size = m_size->currentData().toSize();
        return {size.width(), size.height(), m_every->value()};
    }

private:
    QComboBox* m_size;
    QSpinBox* m_every;
};
} // namespace

void askForTimeLapse(QWidget* parent, int steps, const std::function<void(const TimeLapseSettings&)>& callback)
{
    auto* dialog = new TimeLapseDialog(parent, steps);
    QObject::connect(dialog, &QDialog::accepted, dialog, [dialog, callback] { callback(dialog->options()); });
    dialog->open();
}
} // namespace ui
