#include "ui/lesson/lesson_panel.h"

#include "ui/actions/actions.h"
#include "ui/widgets/named.h"
#include "ui/widgets/panel_layout.h"
#include "ui/widgets/side_column.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QStackedWidget>

#include <cmath>
#include <utility>

namespace ui
{
namespace
{
constexpr double speeds[] = {0.25, 0.5, 1, 2, 4};
constexpr int defaultSpeed = 2;                                    ///< index of the default speed
constexpr int pictureSide = 80, cardSide = 72, progressHeight = 8; ///< pixels

/// Returns a label that never widens the panel, so that the view keeps its size when the text changes.
QLabel* label(const char* name)
{
    auto* label = named(new QLabel, name);
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    QSizePolicy policy = label->sizePolicy();
    policy.setHorizontalPolicy(QSizePolicy::Ignored);
    label->setSizePolicy(policy);
    return label;
}

void enlarge(QLabel* label, double factor)
{
    QFont font = label->font();
    font.setBold(true);
    font.setPointSizeF(factor * font.pointSizeF());
    label->setFont(font);
}

QPixmap pixmapOf(const QImage& picture, int side)
{
    return picture.isNull()
               ? QPixmap()
               : QPixmap::fromImage(picture.scaled(side, side, Qt::KeepAspectRatio, Qt::SmoothTransformation));
}
} // namespace

LessonPanel::LessonPanel(QWidget* parent) : QWidget(parent), m_stack(new QStackedWidget)
{
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum); // as high as its content, because the column scrolls
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(0, 0, 0, 0);
    all->addWidget(m_stack);
    addChooser();
    auto* page = new QWidget;
    QVBoxLayout* rows = panelLayout(page);
    addHead(rows);
    addNavigation(rows);
    addText(rows);
    addTeacher(rows);
    addGoals(rows);
    rows->addStretch();
    m_stack->addWidget(page);
}

void LessonPanel::addChooser()
{
    auto* page = new QWidget;
    QVBoxLayout* rows = panelLayout(page);
    m_chooserHead = label("lessonsHead");
    m_chooserHead->setText(tr("Choose a lesson. It starts with its own model."));
    rows->addWidget(m_chooserHead);
    auto* cards = new QWidget;
    m_cards = new QVBoxLayout(cards);
    m_cards->setContentsMargins(0, 0, 0, 0);
    m_cards->setSpacing(gap);
    rows->addWidget(cards);
    auto* file = new QPushButton(tr("Open a Lesson…"));
    file->setToolTip(tr("Opens a lesson from a zip or a folder."));
    connect(file, &QPushButton::clicked, this, &LessonPanel::fileRequested);
    rows->addWidget(file);
    rows->addStretch();
    m_waysOut << cards << file;
    m_stack->addWidget(page);
}

void LessonPanel::addHead(QVBoxLayout* page)
{
    m_lesson = label("lessonTitle");
    m_title = label("lessonStep");
    m_picture = label("lessonPicture");
    enlarge(m_title, 1.2);
    m_picture->setFixedSize(pictureSide, pictureSide);
    m_picture->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    m_picture->setAlignment(Qt::AlignTop);
    auto* words = new QVBoxLayout;
    words->addWidget(m_title);
    words->addWidget(m_lesson);
    words->addStretch();
    auto* row = new QHBoxLayout;
    row->addStrut(pictureSide); // reserves the picture's height, so that the content below stays in place
    row->addWidget(m_picture);
    row->addLayout(words, 1);
    page->addLayout(row);
}

void LessonPanel::addText(QVBoxLayout* page)
{
    m_text = label("lessonText");
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_brush = label("lessonBrush");
    page->addWidget(m_text);
    page->addWidget(m_brush);
}

void LessonPanel::addTeacher(QVBoxLayout* page)
{
    m_progress = new QProgressBar;
    m_progress->setRange(0, 1000);
    m_progress->setTextVisible(false);
    m_progress->setFixedHeight(progressHeight);
    m_progress->setAccessibleName(tr("How far the teacher is"));
    m_play = named(new QPushButton(tr("Show Me")), "lessonPlay");
    m_one = named(new QPushButton(tr("One Stroke")), "lessonOne", tr("Shows the teacher's next stroke alone."));
    m_speed = named(new QComboBox, "lessonSpeed", tr("Speed of the demonstration."), tr("Speed"));
    for (const double speed : speeds)
        m_speed->addItem(tr("%1 ×", "speed").arg(QLocale().toString(speed)));
    m_speed->setCurrentIndex(defaultSpeed);
    m_try =
        named(new QPushButton(tr("Try It")), "lessonTry", tr("Undoes the strokes of this step. Now it is your turn."));
    page->addWidget(m_progress);
    auto* row = new QHBoxLayout;
    row->addWidget(m_play, 1);
    row->addWidget(m_speed);
    page->addLayout(row);
    auto* slower = new QHBoxLayout;
    slower->addWidget(m_one, 1);
    slower->addWidget(m_try, 1);
    page->addLayout(slower);
    m_teachers = named(new QPushButton(tr("Start from the Teacher's Model")), "lessonTeachers",
                       tr("Begins this step with the teacher's model. Undo brings yours back."));
    page->addWidget(m_teachers);
    connect(m_play, &QPushButton::clicked, this, [this] { Q_EMIT playRequested(!m_isPlaying); });
    connect(m_one, &QPushButton::clicked, this, &LessonPanel::singleStrokeRequested);
    connect(m_speed, &QComboBox::currentIndexChanged, this, [this](int index) { Q_EMIT speedChosen(speeds[index]); });
    connect(m_try, &QPushButton::clicked, this, &LessonPanel::tryRequested);
    connect(m_teachers, &QPushButton::clicked, this, &LessonPanel::teachersModelRequested);
}

/// Adds the goals, whose height changes during a step, below all buttons, which therefore stay in place.
void LessonPanel::addGoals(QVBoxLayout* page)
{
    auto* handout = named(new QPushButton(tr("Handout as PDF…")), "lessonHandout",
                          tr("Writes the texts and pictures of all steps to a PDF for pupils."));
    m_difference = new QCheckBox(tr("Show the difference"));
    m_difference->setToolTip(tr("Colours the model by how far it is from the teacher's."));
    m_marks = label("lessonMarks");
    m_marks->setAlignment(Qt::AlignTop);
    page->addWidget(handout);
    page->addWidget(m_difference);
    page->addWidget(m_marks);
    m_waysOut << handout;
    connect(handout, &QPushButton::clicked, this, &LessonPanel::handoutRequested);
    connect(m_difference, &QCheckBox::toggled, this, &LessonPanel::differenceRequested);
}

void LessonPanel::addNavigation(QVBoxLayout* page)
{
    m_back = named(new QPushButton(tr("Back")), "lessonBack");
    m_next = named(new QPushButton(tr("Next")), "lessonNext");
    auto* leave = named(new QPushButton(tr("Leave")), "lessonLeave", tr("Ends the lesson. The model stays as it is."));
    auto* row = new QHBoxLayout;
    for (QPushButton* each : {m_back, m_next, leave})
        row->addWidget(each);
    page->addLayout(row);
    m_waysOut << leave;
    connect(m_back, &QPushButton::clicked, this, [this] { Q_EMIT stepRequested(m_step - 1); });
    connect(m_next, &QPushButton::clicked, this, [this] { Q_EMIT stepRequested(m_step + 1); });
    connect(leave, &QPushButton::clicked, this, &LessonPanel::closed);
}

void LessonPanel::setLessons(const QList<LessonCard>& lessons)
{
    for (const LessonCard& card : lessons) {
        auto* button = new QPushButton(card.title);
        button->setIcon(pixmapOf(card.picture, cardSide));
        button->setIconSize(QSize(cardSide, cardSide));
        button->setStyleSheet(QStringLiteral("text-align: left"));
        button->setToolTip(card.summary);
        m_cards->addWidget(button);
        connect(button, &QPushButton::clicked, this, [this, name = card.name] { Q_EMIT lessonChosen(name); });
    }
}

void LessonPanel::showPage(const LessonPage& page, const QList<LessonMark>& marks)
{
    m_step = page.step;
    const bool isEnd = page.step == page.steps;
    m_lesson->setText(isEnd ? page.lesson
                            : tr("%1: step %2 of %3").arg(page.lesson).arg(page.step + 1).arg(page.steps));
    m_title->setText(page.title);
    m_picture->setPixmap(pixmapOf(page.picture, pictureSide));
    m_picture->setVisible(!page.picture.isNull());
    m_text->setText(page.text);
    m_brush->setText(tr("Brush: %1", "tools and sizes").arg(page.brush));
    m_brush->setVisible(!page.brush.isEmpty());
    m_teachers->setEnabled(page.step > 0 && !isEnd);
    m_try->setEnabled(!isEnd);
    m_play->setEnabled(page.isShown);
    m_one->setEnabled(page.isShown);
    m_difference->setVisible(page.isCompared);
    m_back->setEnabled(page.step > 0);
    m_next->setText(page.step + 1 < page.steps ? tr("Next") : tr("Finish"));
    m_next->setEnabled(!isEnd);
    setPlaying(false);
    setProgress(0);
    m_shown = LessonPanelState{page, {}, false};
    m_marks->clear();
    m_marks->setMinimumHeight(0);
    setMarks(marks, isEnd);
    m_stack->setCurrentIndex(1);
}

/// Shows the list of lessons and resets the options, because another pupil may take the next lesson.
void LessonPanel::showLessons()
{
    m_speed->setCurrentIndex(defaultSpeed);
    m_difference->setChecked(false);
    m_stack->setCurrentIndex(0);
    m_shown.reset();
    Q_EMIT changed();
}

void LessonPanel::lock()
{
    for (QWidget* way : std::as_const(m_waysOut)) {
        way->setEnabled(false);
        way->hide();
    }
    m_chooserHead->setText(tr("This turn has no lesson."));
}

void LessonPanel::press(LessonButton button)
{
    QPushButton* const buttons[] = {m_play, m_try, m_back, m_next};
    if (m_shown)
        buttons[static_cast<std::size_t>(button)]->click();
}

void LessonPanel::setPlaying(bool isPlaying)
{
    m_isPlaying = isPlaying;
    m_play->setText(isPlaying ? tr("Pause") : tr("Show Me"));
    if (m_shown && std::exchange(m_shown->isPlaying, isPlaying) != isPlaying)
        Q_EMIT changed();
}

void LessonPanel::setProgress(double share)
{
    m_progress->setValue(static_cast<int>(std::lround(m_progress->maximum() * share)));
}

/// Shows the marks by symbol and words, not by colour alone. Within a step the label only grows, so that its neighbours
/// do not move up and down.
void LessonPanel::setMarks(const QList<LessonMark>& marks, bool areOfPresent)
{
    QStringList lines;
    for (const LessonMark& mark : marks)
        lines << QStringLiteral("%1 %2").arg(mark.holds ? QStringLiteral("✓") : QStringLiteral("○"), mark.text);
    const QString text = lines.join(QLatin1Char('\n'));
    if (m_marks->isVisible() && !m_marks->text().isEmpty() && m_marks->text() != text)
        m_marks->setMinimumHeight(m_marks->height());
    m_marks->setText(text);
    m_marks->setEnabled(areOfPresent);
    if (m_shown) {
        m_shown->marks = marks;
        Q_EMIT changed();
    }
}

bool LessonPanel::wantsDifference() const
{
    return m_difference->isChecked() && m_difference->isVisibleTo(this);
}

void addLessonPanel(SideColumn* column, const Actions& actions)
{
    column->add(QStringLiteral("lessonPanel"), LessonPanel::tr("Lessons"), new LessonPanel)
        ->openBy(actions.get(QStringLiteral("help.lessons")));
}
} // namespace ui
