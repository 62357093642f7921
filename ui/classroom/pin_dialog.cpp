#include "ui/classroom/pin_dialog.h"

#include "ui/classroom/classroom.h"
#include "ui/widgets/dialog_helpers.h"
#include "ui/widgets/named.h"

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
constexpr int freeAttempts = 3;
constexpr int firstLockout = 5, maxLockout = 300; ///< seconds
constexpr int maxDoublings = 6;                   ///< doublings of the first lockout until it reaches maxLockout
constexpr int tickMs = 500;

class PinDialog : public QDialog
{
    Q_DECLARE_TR_FUNCTIONS(ui::PinDialog)

public:
    PinDialog(PinPrompt* gate, const QString& why, QWidget* parent)
        : QDialog(parent)
        , m_prompt(gate)
        , m_pin(new QLineEdit)
    {
        QVBoxLayout* column = beginDialog(this, "pinDialog", tr("Teacher's PIN"));
        column->addWidget(dialogText(why, pinTextWidth));
        named(m_pin, "pin", {}, tr("Teacher's PIN"));
        m_pin->setPlaceholderText(tr("Teacher's PIN"));
        m_pin->setEchoMode(QLineEdit::Password);
        m_pin->setMaxLength(maxPinLength);
        m_word = dialogText({}, pinTextWidth);
        m_word->setObjectName(QStringLiteral("pinWord"));
        column->addWidget(m_pin);
        column->addWidget(m_word);
        m_accept = addDialogButtons(this, tr("End &Class"));
        auto* tick = new QTimer(this);
        connect(tick, &QTimer::timeout, this, &PinDialog::showLockout);
        tick->start(tickMs);
        showLockout();
        m_pin->setFocus();
    }

    void accept() override
    {
        if (m_prompt->isRight(m_pin->text()))
            return QDialog::accept();
        m_pin->clear();
        m_word->setText(tr("This is not the PIN."));
        showLockout();
    }

private:
    void showLockout()
    {
        const int lockout = m_prompt->lockoutSeconds();
        const bool lockoutEnded = lockout == 0 && !m_pin->isEnabled();
        m_pin->setEnabled(lockout == 0);
        m_accept->setEnabled(lockout == 0);
        if (lockout > 0)
            m_word->setText(tr("Too many wrong PINs. Try again in %n seconds.", nullptr, lockout));
        if (!lockoutEnded)
            return;
        m_word->clear();
        m_pin->setFocus();
    }

    PinPrompt* m_prompt;
    QLineEdit* m_pin;
    QLabel* m_word;
    QPushButton* m_accept;
};
} // namespace

PinPrompt::PinPrompt(IsPin isPin, QWidget* window) : QObject(window), m_isPin(std::move(isPin)), m_window(window) {}

int PinPrompt::lockoutSeconds() const
{
    return static_cast<int>((m_lockout.remainingTime() + 999) / 1000);
}

bool PinPrompt::isRight(const QString& pin)
{
    if (lockoutSeconds() > 0)
        return false;
    if (m_isPin(pin)) {
        m_wrong = 0;
        return true;
    }
    if (++m_wrong >= freeAttempts)
        m_lockout.setRemainingTime(
            1000 * std::min(firstLockout << std::min(m_wrong - freeAttempts, maxDoublings), maxLockout));
    return false;
}

void PinPrompt::ask(const QString& why, const std::function<void()>& proceed)
{
    if (m_dialog)
        return m_dialog->raise();
    m_dialog = new PinDialog(this, why, m_window);
    connect(m_dialog, &QDialog::accepted, this, proceed);
    m_dialog->open();
}
} // namespace ui
