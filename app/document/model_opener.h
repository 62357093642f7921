#pragma once

#include "core/primitives/starter_models.h"

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

/// Opens another model in place of the present one. The latest choice wins: a model still being loaded is abandoned,
/// but a save or change in progress is finished first. Thread: gui; models are loaded on a background thread.
class ModelOpener : public QObject
{
    Q_OBJECT

public:
    explicit ModelOpener(Document* document);

    /// A callback that asks the user before changes are lost. It returns false to keep the present model; it may then
    /// call `proceed` later, once the changes are saved.
    using DiscardPrompt = std::function<bool(const std::function<void()>& proceed)>;
    void setDiscardPrompt(DiscardPrompt prompt);
    bool canDiscard(const std::function<void()>& proceed) const;

    /// Makes a model that can be sculpted, or sets the reason why not. Thread: background.
    using Make = std::function<LoadedModel(const core::JobControl& control)>;
    struct Choice
    {
        QString what; ///< text shown while the model is loading
        Make make;
        std::shared_ptr<const void> mark = {}; ///< any object by which the caller recognises the model
        bool discardsChanges = false;          ///< true: the user has agreed to lose changes, so there is no prompt
        QString path = {};                     ///< path of the model's file; empty: none
    };
    void openMade(const Choice& choice);
    /// Returns the mark of the present model; null if it was opened without one, such as a file or starter.
    const std::shared_ptr<const void>& mark() const { return m_mark; }
    /// Returns whether another model is being loaded. Changes made to the present model meanwhile will be lost.
    bool isOpening() const { return m_isLoading; }

    /// Opens the model that was chosen while another job was running.
    void openNext();
    void forgetNext() { m_next.reset(); }

public Q_SLOTS:
    void open(const QString& path);
    /// Opens a file without asking about unsaved changes.
    void openDiscardingChanges(const QString& path);
    /// Opens a file and repairs its model if it is not sound. A repaired model has no file.
    void openRepaired(const QString& path, const core::RepairOptions& options);
    /// Opens the ball with which the program starts.
    void openBall();
    void openStarter(core::Starter starter);
    /// Opens a document that the recovery store offers, with its history.
    void recover(quint64 offer, const QString& name);

Q_SIGNALS:
    /// Emitted if the model of a file is refused, for example because it is not sound. openRepaired() may succeed.
    void repairable(const QString& path, const QString& problem);
    /// Emitted with the repairs made to the opened model, one sentence each.
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
    /// the user agreed to lose changes for the model being loaded, and has changed nothing since
    bool m_isDiscardAgreed = false;
    /// file that was not opened but may be repaired; the agreement to lose changes also holds for it
    QString m_discardAgreedFor;
};
} // namespace app
