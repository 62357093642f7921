#include "ui/classroom/questionnaire_panel.h"

#include "ui/classroom/answer_scale.h"
#include "ui/widgets/named.h"
#include "ui/widgets/spacing.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace ui
{
namespace
{
constexpr int formWidth = 672; ///< pixels
constexpr double titleScale = 1.6;

QLabel* sentence(const QString& text)
{
    auto* label = new QLabel(text);
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    return label;
}
} // namespace

QuestionnairePanel::QuestionnairePanel(QWidget* over)
    : CoverPanel(over)
    , m_title(sentence({}))
    , m_skip(new QPushButton(tr("S&kip")))
    , m_done(new QPushButton(tr("D&one")))
{
    setObjectName(QStringLiteral("questionnairePanel"));
    setAccessibleName(tr("Questions after the turn"));
    setCard(content(), buttons(), formWidth);
    setTabOrder(m_done, m_skip); // pressing Return repeatedly leads to Done
}

QWidget* QuestionnairePanel::content()
{
    QFont font = m_title->font();
    font.setPointSizeF(font.pointSizeF() * titleScale);
    m_title->setFont(font);
    auto* list = new QWidget;
    auto* column = new QVBoxLayout(list);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(gap / 2);
    column->addWidget(m_title);
    column->addSpacing(gap / 2);
    column->addWidget(sentence(
        tr("Six questions about the program. Answer what you like: press a number; press it again to clear it.")));
    column->addSpacing(gap / 2);
    for (std::size_t i = 0; i < questionCount; ++i) {
        const QuestionWords words = QuestionWords::of(static_cast<Question>(i));
        QLabel* question = sentence(words.question);
        column->addWidget(question);
        auto* scale = new AnswerScale(QStringLiteral("question%1").arg(i + 1), words);
        connect(scale, &AnswerScale::changed, this, [this] { Q_EMIT answered(questionnaire()); });
        m_scales << scale;
        column->addWidget(scale);
        column->addSpacing(gap / 2);
    }
    return list;
}

QLayout* QuestionnairePanel::buttons()
{
    named(m_skip, "skipQuestions", tr("Continues without answers; nothing is saved."));
    named(m_done, "questionsDone", tr("Saves the answers with the work, and continues."));
    for (QPushButton* button : {m_skip, m_done})
        button->setAutoDefault(true); // Return presses the focused button
    connect(m_skip, &QPushButton::clicked, this, &QuestionnairePanel::skip);
    connect(m_done, &QPushButton::clicked, this, &QuestionnairePanel::finished);
    auto* row = new QHBoxLayout;
    row->addStretch(1);
    row->addWidget(m_skip);
    row->addWidget(m_done);
    return row;
}

void QuestionnairePanel::open(const QString& pupil)
{
    m_title->setText(tr("How was it, %1?").arg(pupil));
    for (AnswerScale* scale : m_scales)
        scale->setAnswer({});
    cover();
    m_scales.constFirst()->setFocus();
}

Questionnaire QuestionnairePanel::questionnaire() const
{
    Questionnaire read;
    for (std::size_t i = 0; i < questionCount; ++i)
        read.answers[i] = m_scales[static_cast<qsizetype>(i)]->answer();
    return read;
}

void QuestionnairePanel::skip()
{
    for (AnswerScale* scale : m_scales)
        scale->setAnswer({});
    Q_EMIT answered({});
    Q_EMIT finished();
}
} // namespace ui
