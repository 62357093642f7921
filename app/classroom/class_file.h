#pragma once

#include "ui/classroom/classroom.h"

#include <QCoreApplication>

namespace app
{
/// One sentence that names file, line or key, and reason.
struct ClassFileError
{
    QString sentence;
};

/// The file that a teacher makes for a class: UTF-8, a line for each key, "key = value", lines that begin with # or ;
/// or [ left out. Any thread.
class ClassFile
{
    Q_DECLARE_TR_FUNCTIONS(app::ClassFile)

public:
    /// A folder that is named relatively is sought from the file; whether it is there is not asked. Throws
    /// ClassFileError.
    static ui::Classroom read(const QString& path);
    /// Whole or not at all: empty, or what is wrong. The title has no line break.
    static QString write(const QString& path, const ui::Classroom& classroom);
    /// Returns why the class cannot have its lesson: one sentence; empty if it can, or has none.
    static QString lessonProblem(const ui::Classroom& classroom);
};
} // namespace app
