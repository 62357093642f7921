#pragma once

#include "core/operations/starter_models.h"

#include <QObject>
#include <QString>

#include <functional>
#include <memory>
#include <optional>

namespace core
{
struct JobControl;
struct RepairOptions;
} // namespace core

namespace app
{
class Document;
struct LoadedModel;
struct MeshFacts;

/// Opens other models in place of the present one. The latest choice wins: what is being opened is given up for it,
/// what is being written or changed is finished first. Thread: gui; models are made on another.
class ModelOpener : public QObject
{
    Q_OBJECT

public:
    explicit ModelOpener(Document* document);

    /// Called before changes are lost. False keeps the present model; `proceed` may be called later, when they are
    /// saved.
    using DiscardPrompt = std::function<bool(const std::function<void()>& proceed)>;
    void setDiscardPrompt(DiscardPrompt prompt);
    bool canDiscard(const std::function<void()>& proceed) const;

    /// Makes a model that may be sculpted, or says why not. Thread: another.
    using Make = std::function<LoadedModel(const core::JobControl& control)>;
    struct Choice
    {
        QString what; ///< the busy text
        Make make;
        std::shared_ptr<const void> mark = {}; ///< by which the caller knows the model
        bool discardsChanges = false;          ///< the user knows it: no prompt
        QString path = {};                     ///< of the file; empty: it comes from none
    };
    void openMade(const Choice& choice);
    /// The mark of the present model; null: a file's, or a starter.
    const std::shared_ptr<const void>& mark() const { return m_mark; }
    /// Another model is loaded. What is done to the present one now is lost if that one comes.
    bool isOpening() const { return m_isLoading; }

    /// Opens what was chosen while something else went on.
    void openNext();
    void forgetNext() { m_next.reset(); }

public Q_SLOTS:
    void open(const QString& path);
    /// As open(), without a prompt.
    void openDiscardingChanges(const QString& path);
    /// As open(); a model that is not sound is repaired. It has no file then.
    void openRepaired(const QString& path, const core::RepairOptions& options);
    /// Opens the ball that the program begins with.
    void openBall();
    void openStarter(core::Starter starter);
    /// Opens a document that the recovery store offers, with its history.
    void recover(quint64 offer, const QString& name);

Q_SIGNALS:
    /// The model of a file is not sound: openRepaired() may take it.
    void repairable(const QString& path, const QString& problem);
    /// What was done to the model that is opened, step by step.
    void repaired(const QString& name, const QStringList& steps);

private:
    Choice choiceOf(const QString& path) const;
    void chooseNext(const Choice& choice);
    void load(const Choice& choice);
    void refuse(const LoadedModel& model, bool isStopped);
    void install(LoadedModel& model, const std::shared_ptr<const void>& mark);
    void finish(const MeshFacts& facts);

    Document* m_document;
    DiscardPrompt m_prompt;
    std::shared_ptr<const void> m_mark;
    std::optional<Choice> m_next; ///< to be opened when the present job has ended
    bool m_isLoading = false;
    bool m_isDiscardAgreed = false; ///< for what is being opened; the user made no change since
    QString m_discardAgreedFor;     ///< a file that was not opened but may be repaired: the same holds for it
};
} // namespace app
