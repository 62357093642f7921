#include "ui/classroom/pin_dialog.h"

#include "ui/classroom/classroom.h"
#include "ui/widgets/dialog_helpers.h"

#include <QCoreApplication>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>

namespace ui
{
namespace
{
constexpr int pinTextWidth = 320;
constexpr int freeTries = 3;
constexpr int firstRest = 5, longestRest = 300; ///< seconds
constexpr int mostDoublings = 6;                ///< which the longest rest ends
constexpr int tickMs = 500;

class PinDialog : public QDialog
{
    Q_DECLARE_TR_FUNCTIONS(ui::PinDialog)

public:
    PinDialog(PinGate* gate, const QString& why, QWidget* parent) : QDialog(parent), m_gate(gate), m_pin(new QLineEdit)
    {
        QVBoxLayout* column = beginDialog(this, "pinDialog", tr("Teacher's PIN"));
        column->addWidget(dialogText(why, pinTextWidth));
        m_pin->setObjectName(QStringLiteral("pin"));
        m_pin->setAccessibleName(tr("Teacher's PIN"));
        m_pin->setPlaceholderText(tr("Teacher's PIN"));
        m_pin->setEchoMode(QLineEdit::Password);
        m_pin->setMaxLength(mostPinLength);
        m_word = dialogText({}, pinTextWidth);
        m_word->setObjectName(QStringLiteral("pinWord"));
        column->addWidget(m_pin);
        column->addWidget(m_word);
        m_agree = addAnswers(this, tr("&Go On"));
        auto* tick = new QTimer(this);
        connect(tick, &QTimer::timeout, this, &PinDialog::showRest);
        tick->start(tickMs);
        showRest();
        m_pin->setFocus();
    }

    void accept() override
    {
        if (m_gate->isRight(m_pin->text()))
            return QDialog::accept();
        m_pin->clear();
        m_word->setText(tr("This is not the PIN."));
        showRest();
    }

private:
    void showRest()
    {
        const int rest = m_gate->restSeconds();
        const bool hasRested = rest == 0 && !m_pin->isEnabled();
        m_pin->setEnabled(rest == 0);
        m_agree->setEnabled(rest == 0);
        if (rest > 0)
            m_word->setText(tr("Too often wrong: the next try is possible in %n seconds.", nullptr, rest));
        if (!hasRested)
            return;
        m_word->clear();
        m_pin->setFocus();
    }

    PinGate* m_gate;
    QLineEdit* m_pin;
    QLabel* m_word;
    QPushButton* m_agree;
};
} // namespace

PinGate::PinGate(IsPin isPin, QWidget* window) : QObject(window), m_isPin(std::move(isPin)), m_window(window) {}

int PinGate::restSeconds() const
{
    return static_cast<int>((m_rest.remainingTime() + 999) / 1000);
}

bool PinGate::isRight(const QString& pin)
{
    if (restSeconds() > 0)
        return false;
    if (m_isPin(pin)) {
        m_wrong = 0;
        return true;
    }
    if (++m_wrong >= freeTries)
        m_rest.setRemainingTime(1000 *
                                std::min(firstRest << std::min(m_wrong - freeTries, mostDoublings), longestRest));
    return false;
}

void PinGate::ask(const QString& why, const std::function<void()>& goOn)
{
    if (m_dialog)
        return m_dialog->raise();
    m_dialog = new PinDialog(this, why, m_window);
    connect(m_dialog, &QDialog::accepted, this, goOn);
    m_dialog->open();
}
} // namespace ui
