#pragma once

#include <QList>
#include <QString>

#include <array>
#include <optional>

namespace ui
{
/// A question that a class asks after a turn, with a scale of seven points, the higher the better. Source: appendix A
/// of Zhu and Yang 2024.
enum class Question { Mastering, Functions, Errors, Details, Topology, Overall };
inline constexpr std::size_t questionCount = 6;
inline constexpr int minAnswer = 1, maxAnswer = 7;

/// The words of a question in the person's language. Thread: any.
struct QuestionWords
{
    QString question;
    QString low, high; ///< the meaning of the scale's ends

    static QuestionWords of(Question question);
};

/// The answers of one pupil. Any question may be left out.
struct Questionnaire
{
    std::array<std::optional<int>, questionCount> answers; ///< minAnswer to maxAnswer, in the order of Question

    bool isEmpty() const;
    bool operator==(const Questionnaire&) const = default;
};

/// The sum of the answers to one question.
struct AnswerSum
{
    std::array<int, maxAnswer> counts{}; ///< of 1, 2 and so on

    int total() const;
    double mean() const; ///< 0 without answers
};

/// Returns the sums in the order of Question. Answers that are left out count nowhere.
std::array<AnswerSum, questionCount> sumsOf(const QList<Questionnaire>& questionnaires);
} // namespace ui
