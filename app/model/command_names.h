#pragma once

#include "core/operations/model_command.h"

#include <QCoreApplication>
#include <QString>

namespace app
{
/// Whole-model commands in words.
class ModelWords
{
    Q_DECLARE_TR_FUNCTIONS(app::ModelWords)

public:
    /// The undo step.
    static QString name(const core::ModelCommand& command);
    /// Of those in resources/icons.
    static QString icon(const core::ModelCommand& command);
    /// While it goes on.
    static QString doing(const core::ModelCommand& command);
    /// What was not done, where and why: one sentence. `inserted`: the file of the inserted model.
    static QString refusal(const core::ModelChange& change, const QString& inserted);
    /// All was as asked for already.
    static QString nothing(const core::ModelCommand& command);

private:
    struct Words
    {
        QString name, doing;
    };
    static Words wordsOf(const core::Move&);
    static Words wordsOf(const core::Rotate&);
    static Words wordsOf(const core::Scale&);
    static Words wordsOf(const core::Mirror&);
    static Words wordsOf(const core::Recentre&);
    static Words wordsOf(const core::Insert&);
    static Words wordsOf(const core::Fill&);
    static Words wordsOf(const core::MaskOperation& change);
    static Words wordsOf(const core::RemeshUniformly&);
    static Words wordsOf(const core::Symmetrize&);
    static Words wordsOf(const core::Reset&);
    static Words wordsOf(const core::PlaceOnBed&);
    static Words wordsOf(const core::FlattenBase&);
};
} // namespace app
