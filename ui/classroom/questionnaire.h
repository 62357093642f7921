#pragma once

#include <QList>
#include <QString>

#include <array>
#include <optional>

namespace ui
{
/// Questions after a turn, each with a scale of seven points; 7 is best. Source: appendix A of Zhu and Yang 2024.
enum class Question { Mastering, Functions, Errors, Details, Topology, Overall };
inline constexpr std::size_t questionCount = 6;
inline constexpr int minAnswer = 1, maxAnswer = 7;

/// The texts of a question in the user's language. Thread: any.
struct QuestionWords
{
    QString question;
    QString low, high; ///< meanings of the scale's ends

    static QuestionWords of(Question question);
};

/// The answers of one pupil; every question is optional.
struct Questionnaire
{
    std::array<std::optional<int>, questionCount> answers; ///< minAnswer to maxAnswer, in the order of Question

    bool isEmpty() const;
    bool operator==(const Questionnaire&) const = default;
};

/// Counts and mean of the answers to one question.
struct AnswerSum
{
    std::array<int, maxAnswer> counts{}; ///< number of answers for each point, starting at 1

    int total() const;
    double mean() const; ///< 0 if there are no answers
};

/// Returns the sums in the order of Question. Missing answers are not counted.
std::array<AnswerSum, questionCount> sumsOf(const QList<Questionnaire>& questionnaires);
} // namespace ui
