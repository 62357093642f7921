#include "ui/files/file_item_delegate.h"

#include "ui/files/file_list_model.h"
#include "ui/widgets/named.h"
#include "ui/widgets/spacing.h"
#include "ui/widgets/themed_icon.h"

#include <QLineEdit>
#include <QPainter>
#include <QPixmapCache>

namespace ui
{
namespace
{
constexpr int iconSize = 40;
constexpr double cornerRadius = 6;

/// Returns the picture reduced smoothly, each pixel the mean of those it replaces; painting at a smaller scale would
/// alias. Results are cached.
QPixmap scaled(const QPixmap& picture, int size, double ratio)
{
    const QString key = QStringLiteral("thumbnail/%1/%2/%3").arg(picture.cacheKey()).arg(size).arg(ratio);
    QPixmap result;
    if (!QPixmapCache::find(key, &result)) {
        const int pixels = qRound(size * ratio);
        result = picture.scaled(pixels, pixels, Qt::KeepAspectRatio, Qt::SmoothTransformation);
        result.setDevicePixelRatio(ratio);
        QPixmapCache::insert(key, result);
    }
    return result;
}
} // namespace

FileItemDelegate::FileItemDelegate(const FileListModel* files, const FileSorter* sorter, QObject* parent)
    : QStyledItemDelegate(parent)
    , m_files(files)
    , m_sorter(sorter)
    , m_picture(defaultPictureSize)
{}

QSize FileItemDelegate::cell(const QFontMetrics& metrics) const
{
    return {qMax(m_picture, metrics.horizontalAdvance(FileListModel::longStamp())) + 2 * gap,
            m_picture + 3 * metrics.lineSpacing() + 2 * gap};
}

QSize FileItemDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const
{
    return cell(option.fontMetrics);
}

QRect FileItemDelegate::nameRect(const QStyleOptionViewItem& option) const
{
    const QRect all = option.rect;
    return {all.left() + gap / 2, all.top() + m_picture + gap, all.width() - gap, option.fontMetrics.lineSpacing()};
}

void FileItemDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const
{
    const QModelIndex file = m_sorter->mapToSource(index);
    const bool isChosen = option.state & QStyle::State_Selected, hasFocus = option.state & QStyle::State_HasFocus;
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    const QRectF frame = QRectF(option.rect).adjusted(1, 1, -1, -1);
    painter->setPen(hasFocus ? QPen(option.palette.color(isChosen ? QPalette::Text : QPalette::Highlight), 1.5)
                             : QPen(Qt::NoPen));
    painter->setBrush(isChosen ? option.palette.brush(QPalette::Highlight) : QBrush(Qt::NoBrush));
    painter->drawRoundedRect(frame, cornerRadius, cornerRadius);
    paintPicture(painter, {option.rect.left(), option.rect.top() + gap / 2, option.rect.width(), m_picture}, file);

    QRect line = nameRect(option);
    painter->setFont(option.font);
    painter->setPen(option.palette.color(isChosen ? QPalette::HighlightedText : QPalette::Text));
    for (const QString& text : {m_files->name(file), m_files->measure(file), m_files->stamp(file)}) {
        const auto cut = line == nameRect(option) ? Qt::ElideMiddle : Qt::ElideRight;
        painter->drawText(line, Qt::AlignCenter, option.fontMetrics.elidedText(text, cut, line.width()));
        line.translate(0, line.height());
        if (!isChosen)
            painter->setPen(option.palette.color(QPalette::PlaceholderText));
    }
    painter->restore();
}

void FileItemDelegate::paintPicture(QPainter* painter, const QRect& area, const QModelIndex& file) const
{
    const auto picture = file.data(Qt::DecorationRole).value<QPixmap>();
    if (!picture.isNull()) {
        const QPixmap small = scaled(picture, m_picture, painter->device()->devicePixelRatioF());
        painter->drawPixmap(area.center().x() - m_picture / 2, area.top(), small);
        return;
    }
    const bool isBroken = !file.data(FileListModel::ProblemRole).toString().isEmpty();
    const QString icon = m_files->entry(file).isFolder ? QStringLiteral("folder")
                         : isBroken                    ? QStringLiteral("unreadable")
                                                       : QStringLiteral("wait");
    themedIcon(icon).paint(painter, QRect(area.center() - QPoint(iconSize, iconSize) / 2, QSize(iconSize, iconSize)));
}

QWidget* FileItemDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem&, const QModelIndex& index) const
{
    auto* editor =
        named(new QLineEdit(index.data(Qt::EditRole).toString(), parent), "files.rename", {}, tr("New name"));
    editor->setAlignment(Qt::AlignCenter);
    return editor;
}

void FileItemDelegate::updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                                            const QModelIndex&) const
{
    const int height = editor->sizeHint().height();
    const QRect name = nameRect(option);
    editor->setGeometry(option.rect.left(), name.center().y() - height / 2, option.rect.width(), height);
}
} // namespace ui
