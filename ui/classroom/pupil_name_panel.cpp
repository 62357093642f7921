#include "ui/classroom/pupil_name_panel.h"

#include "ui/actions/actions.h"
#include "ui/classroom/classroom.h"
#include "ui/lesson/lesson_panel.h"
#include "ui/widgets/named.h"
#include "ui/widgets/spacing.h"

#include <QAction>
#include <QButtonGroup>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace ui
{
namespace
{
constexpr QSize starterSize{64, 64};
constexpr int starterWidth = 84, nameWidth = 320, maxRows = 10;
constexpr int nameRole = Qt::UserRole;
constexpr int lessonTile = 1000; ///< tile of the lesson; not a value of core::Starter
constexpr double headScale = 1.6;
} // namespace

/// Lays out tiles of one size in as many rows as the width requires.
class TileRows : public QWidget
{
public:
    TileRows()
    {
        QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Preferred);
        policy.setHeightForWidth(true);
        setSizePolicy(policy);
    }

    void add(QWidget* tile, bool isFirst)
    {
        tile->setParent(this);
        if (isFirst && !m_tiles.isEmpty())
            setTabOrder(tile, m_tiles.constFirst());
        m_tiles.insert(isFirst ? 0 : m_tiles.size(), tile);
        setHidden(m_tiles.size() == 1); // a single tile is no choice
    }
    QSize sizeHint() const override { return {widthOf(static_cast<int>(m_tiles.size())), tileSize().height()}; }
    QSize minimumSizeHint() const override { return tileSize(); }
    int heightForWidth(int width) const override
    {
        const int rows = rowsIn(width);
        return rows * tileSize().height() + (rows - 1) * gap;
    }

protected:
    void resizeEvent(QResizeEvent*) override
    {
        const int count = static_cast<int>(m_tiles.size()), rows = rowsIn(width());
        const int across = (count + rows - 1) / rows, height = tileSize().height();
        for (int i = 0; i < count; ++i) {
            const int left = i % across * (width() + gap) / across, right = (i % across + 1) * (width() + gap) / across;
            m_tiles[i]->setGeometry(left, i / across * (height + gap), right - left - gap, height);
        }
    }

private:
    QSize tileSize() const
    {
        QSize size(starterWidth, 0);
        for (const QWidget* tile : m_tiles)
            size = size.expandedTo(tile->sizeHint());
        return size;
    }
    int widthOf(int tiles) const { return tiles * (tileSize().width() + gap) - gap; }
    int rowsIn(int width) const
    {
        const int count = static_cast<int>(m_tiles.size());
        const int across = std::clamp((width + gap) / (tileSize().width() + gap), 1, count);
        return (count + across - 1) / across;
    }

    QList<QWidget*> m_tiles;
};

PupilNamePanel::PupilNamePanel(const Classroom& classroom, const Actions& actions, QWidget* over)
    : CoverPanel(over)
    , m_name(new QLineEdit)
    , m_pupils(new QListWidget)
    , m_tiles(new TileRows)
    , m_starters(new QButtonGroup(this))
    , m_begin(new QPushButton(tr("&Begin")))
{
    setObjectName(QStringLiteral("namePanel"));
    setAccessibleName(tr("The next turn"));
    auto* buttons = new QHBoxLayout;
    buttons->addStretch(1);
    buttons->addWidget(m_begin);
    setCard(content(classroom, actions), buttons, nameWidth);
}

QWidget* PupilNamePanel::content(const Classroom& classroom, const Actions& actions)
{
    auto* title = new QLabel(tr("Who is next?"));
    QFont font = title->font();
    font.setPointSizeF(font.pointSizeF() * headScale);
    title->setFont(font);
    named(m_name, "pupilName", {}, tr("Name"));
    m_name->setPlaceholderText(tr("Name or nickname"));
    m_name->setMaxLength(maxPupilNameLength);
    m_name->setVisible(classroom.allowsOthers);
    addPupils(classroom.names);
    named(m_begin, "beginTurn", tr("Starts the turn. (Return)"));
    m_begin->setDefault(true);
    connect(m_name, &QLineEdit::textChanged, m_begin,
            [this](const QString& text) { m_begin->setEnabled(!text.trimmed().isEmpty()); });
    connect(m_name, &QLineEdit::returnPressed, this, &PupilNamePanel::begin);
    connect(m_begin, &QPushButton::clicked, this, &PupilNamePanel::begin);

    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(0, 0, 0, gap);
    column->setSpacing(2 * gap);
    column->addWidget(title);
    column->addWidget(m_pupils);
    column->addWidget(m_name);
    column->addWidget(m_tiles); // before the tiles get children, which would otherwise be shown as windows
    addTiles(classroom.starters, actions);
    return content;
}

void PupilNamePanel::addPupils(const QStringList& names)
{
    named(m_pupils, "pupils", {}, tr("Pupils"));
    m_pupils->setVisible(!names.isEmpty());
    for (const QString& name : names)
        (new QListWidgetItem(name, m_pupils))->setData(nameRole, name);
    m_pupils->setFixedHeight(m_pupils->sizeHintForRow(0) * std::min<int>(static_cast<int>(names.size()), maxRows) +
                             2 * m_pupils->frameWidth());
    connect(m_pupils, &QListWidget::itemSelectionChanged, this, [this] {
        if (const auto chosen = m_pupils->selectedItems(); !chosen.isEmpty())
            m_name->setText(chosen.constFirst()->data(nameRole).toString());
    });
    connect(m_pupils, &QListWidget::itemActivated, this, &PupilNamePanel::begin);
    connect(m_name, &QLineEdit::textEdited, m_pupils, &QListWidget::clearSelection);
}

void PupilNamePanel::setHadTurn(const QStringList& pupils)
{
    for (int row = 0; row < m_pupils->count(); ++row) {
        QListWidgetItem* item = m_pupils->item(row);
        const QString name = item->data(nameRole).toString();
        item->setText(pupils.contains(name) ? tr("%1 ✓ has had a turn").arg(name) : name);
    }
}

void PupilNamePanel::addTiles(const QList<core::Starter>& starters, const Actions& actions)
{
    m_tiles->hide();
    for (const core::Starter starter : starters) {
        const QAction* action = actions.get(QStringLiteral("new.") + QString::fromUtf8(core::name(starter)));
        named(addTile(static_cast<int>(starter), action->iconText(), action->icon()),
              QStringLiteral("turn.") + action->objectName(), action->statusTip());
    }
}

QToolButton* PupilNamePanel::addTile(int id, const QString& text, const QIcon& icon)
{
    auto* tile = new QToolButton;
    tile->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    tile->setIcon(icon);
    tile->setIconSize(starterSize);
    tile->setText(text);
    tile->setCheckable(true);
    tile->setFocusPolicy(Qt::StrongFocus);
    m_starters->addButton(tile, id);
    m_tiles->add(tile, id == lessonTile);
    return tile;
}

void PupilNamePanel::offerLesson(const LessonCard& lesson)
{
    named(addTile(lessonTile, tr("Lesson"), QPixmap::fromImage(lesson.picture)), "turn.lesson", lesson.title);
}

void PupilNamePanel::open()
{
    m_name->clear();
    m_begin->setEnabled(false);
    QAbstractButton* const lesson = m_starters->button(lessonTile);
    (lesson ? lesson : m_starters->buttons().constFirst())->setChecked(true);
    cover();
    m_pupils->clearSelection();
    if (m_pupils->count() > 0)
        m_pupils->setFocus();
    else
        m_name->setFocus();
}

/// Begins the turn on Return, wherever the focus is; tiles ignore Return, so it arrives here.
bool PupilNamePanel::event(QEvent* event)
{
    const bool isReturn =
        event->type() == QEvent::KeyPress && (static_cast<QKeyEvent*>(event)->key() == Qt::Key_Return ||
                                              static_cast<QKeyEvent*>(event)->key() == Qt::Key_Enter);
    if (isReturn)
        begin();
    return CoverPanel::event(event);
}

void PupilNamePanel::begin()
{
    const QString name = m_name->text().simplified();
    if (name.isEmpty())
        return;
    const int id = m_starters->checkedId();
    Q_EMIT begun(name, id == lessonTile ? std::nullopt : std::optional(static_cast<core::Starter>(id)));
}
} // namespace ui
