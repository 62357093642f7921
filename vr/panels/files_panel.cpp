#include "vr/panels/panel_builder.h"
#include "vr/panels/panel_content.h"
#include "vr/panels/panel_theme.h"

#include <algorithm>
#include <iterator>

namespace vr
{
namespace
{
constexpr double filesWidth = 980, tileHeight = 224, buttonHeight = 92, statusHeight = 84, arrowWidth = 84,
                 pageWidth = 120, openWidth = 316, titleWidth = 340, groupGap = 8;
constexpr double filesDistance = 0.6; ///< metres from which the panel is read: arm's length
} // namespace

bool FileTile::operator==(const FileTile& other) const
{
    return path == other.path && name == other.name && isBroken == other.isBroken &&
           picture.cacheKey() == other.picture.cacheKey();
}

int FilesPanel::pageCount() const
{
    return std::max(1, static_cast<int>((files.size() + tilesPerPage - 1) / tilesPerPage));
}

int FilesPanel::shownPage() const
{
    return std::clamp(page, 0, pageCount() - 1);
}

FilesPanel FilesPanel::after(const PanelAction& action) const
{
    FilesPanel panel = *this;
    if (const auto* shown = std::get_if<ShowPage>(&action))
        panel.page = shown->page;
    else if (const auto* file = std::get_if<ChooseFile>(&action))
        panel.chosen = file->path;
    return panel;
}

/// Returns whether the chosen file can be opened. It may have disappeared from the folder since it was chosen.
bool FilesPanel::canOpen() const
{
    return !isBusy &&
           std::ranges::any_of(files, [&](const FileTile& file) { return file.path == chosen && !file.isBroken; });
}

QString FilesPanel::status() const
{
    if (isBusy)
        return tr("One moment…");
    if (hasUnsavedChanges && canOpen())
        return tr("The model has unsaved changes: save it first, or hold to open.");
    //: %1: names of files
    return saved.isEmpty() ? QString() : tr("Saved: %1").arg(saved);
}

void FilesPanel::addTiles(PanelBuilder& builder) const
{
    const QRectF first = builder.nextRow(tileHeight), second = builder.nextRow(tileHeight);
    if (files.isEmpty())
        builder.add(first | second, TextLook{.text = tr("There are no models here yet. Save adds the first one."),
                                             .role = TextRole::Faint,
                                             .alignment = Qt::AlignCenter,
                                             .lines = 3});
    std::vector<QRectF> places = evenCells(first, columns);
    std::ranges::copy(evenCells(second, columns), std::back_inserter(places));
    const qsizetype from = shownPage() * tilesPerPage, to = std::min<qsizetype>(from + tilesPerPage, files.size());
    for (qsizetype i = from; i < to; ++i) {
        const FileTile& file = files[i];
        const QString icon = file.isBroken ? QStringLiteral("unreadable") : QStringLiteral("wait");
        builder.add({places[static_cast<std::size_t>(i - from)],
                     TileLook{file.name, file.picture, icon, file.path == chosen}, ChooseFile{file.path},
                     !file.isBroken});
    }
}

void FilesPanel::addButtons(PanelBuilder& builder) const
{
    const int shown = shownPage();
    const std::vector<QRectF> places =
        cells(builder.nextRow(buttonHeight), {arrowWidth, pageWidth, arrowWidth, openWidth, 0});
    builder.add(places[0], {{.icon = QStringLiteral("previous")}, ShowPage{shown - 1}, shown > 0});
    builder.add(places[1], TextLook{tr("%1 / %2").arg(shown + 1).arg(pageCount()), TextRole::Number, Qt::AlignCenter});
    builder.add(places[2], {{.icon = QStringLiteral("next")}, ShowPage{shown + 1}, shown + 1 < pageCount()});
    const QString open = hasUnsavedChanges ? tr("Hold to open") : tr("Open");
    builder.add(places[3], {{.text = open, .icon = QStringLiteral("open")},
                            OpenFile{chosen, hasUnsavedChanges},
                            canOpen(),
                            hasUnsavedChanges});
    builder.add(places[4], {{.text = tr("Save"), .icon = QStringLiteral("save")}, PanelCommand::SaveModel, !isBusy});
}

PanelLayout FilesPanel::layout() const
{
    PanelBuilder builder(PanelKind::Files, filesWidth, filesDistance);
    builder.addTitle({tr("Files"), folder, titleWidth},
                     {{{.icon = QStringLiteral("panel-close"), .isFlat = true}, ShowPanel{PanelKind::Files, false}}});
    addTiles(builder);
    builder.skip(groupGap);
    addButtons(builder);
    builder.add(builder.nextRow(statusHeight), TextLook{.text = status(), .role = TextRole::Faint, .lines = 2});
    return builder.finished();
}
} // namespace vr
