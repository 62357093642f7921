#include "app/commands/stroke_assets.h"

#include "app/commands/command_line.h"
#include "app/model/model_loader.h"

#include "ui/brush/brush_files.h"
#include "ui/util/stroke_file_messages.h"

#include <QFileInfo>

#include <map>

namespace app
{
namespace
{
class StrokeAssets
{
    Q_DECLARE_TR_FUNCTIONS(app::StrokeAssets)

public:
    explicit StrokeAssets(const QString& strokes) : m_strokes(strokes) {}

    void read(core::Stroke& stroke, std::size_t index)
    {
        requireAlpha(stroke.alpha.file, index);
        resolve(stroke.settings.alpha, stroke.alpha, index, m_alphas, ui::readAlpha);
        resolve(stroke.settings.model, stroke.model, index, m_models, ui::readBrushModel);
    }

private:
    template <class What> using Read = std::map<std::string, ui::BrushFile<What>>;

    [[noreturn]] void fail(std::size_t index, const QString& reason) const
    {
        core::StrokeFileError place(core::StrokeFileError::Kind::UnknownValue);
        place.stroke = index;
        const QString sentence =
            tr("%1: %2: %3", "file: place: reason").arg(m_strokes, ui::StrokeFileMessages::place(place), reason);
        CommandLine::fail(sentence);
    }

    /// Fails if the name is neither a file nor a built-in alpha. The reader has already resolved the built-in ones.
    void requireAlpha(const std::string& file, std::size_t index) const
    {
        if (file.empty() || QFileInfo::exists(pathOf(file)))
            return;
        fail(index, tr("alpha: \"%1\" is none of %2, and no file")
                        .arg(QString::fromStdString(file), ui::builtInAlphaNames().join(QStringLiteral(", "))));
    }

    QString pathOf(const std::string& file) const
    {
        return QString::fromStdU16String(
            (toPath(m_strokes).parent_path() / toPath(QString::fromStdString(file))).u16string());
    }

    template <class What, class Reader>
    void resolve(std::shared_ptr<const What>& what, const core::StrokeNeed& need, std::size_t index, Read<What>& before,
                 Reader reader)
    {
        if (need.file.empty())
            return;
        auto [found, isNew] = before.try_emplace(need.file);
        if (isNew)
            found->second = reader(pathOf(need.file));
        if (!found->second.what)
            fail(index, found->second.problem);
        what = found->second.what;
        if (!need.fingerprint.empty() && what->fingerprint() != need.fingerprint)
            fail(index, tr("%1 has changed since this stroke was recorded.").arg(QString::fromStdString(need.file)));
    }

    QString m_strokes;
    Read<core::Alpha> m_alphas;
    Read<core::BrushModel> m_models;
};
} // namespace

void readStrokeAssets(std::vector<core::FileEntry>& entries, const QString& strokes)
{
    StrokeAssets assets(strokes);
    for (std::size_t i = 0; i < entries.size(); ++i) {
        if (auto* const stroke = std::get_if<core::Stroke>(&entries[i]))
            assets.read(*stroke, i);
    }
}
} // namespace app
