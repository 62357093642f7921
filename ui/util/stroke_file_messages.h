#pragma once

#include "core/io/stroke/stroke_file.h"

#include <QCoreApplication>
#include <QString>

namespace ui
{
/// Says what is wrong with a stroke file or a preset file, for people: one sentence with file, place and reason.
class StrokeFileMessages
{
    Q_DECLARE_TR_FUNCTIONS(ui::StrokeFileMessages)

public:
    static QString sentence(const QString& path, const core::StrokeFileError& error);
    /// Line, stroke and sample, as far as they are known.
    static QString place(const core::StrokeFileError& error);
    static QString reason(const core::StrokeFileError& error);

private:
    static QString wrongType(const QString& key, core::StrokeFileError::Value wanted);
};
} // namespace ui
