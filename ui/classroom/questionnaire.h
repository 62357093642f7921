#pragma once

#include <QList>
#include <QString>

#include <array>
#include <optional>

namespace ui
{
/// What a class asks after a turn; each has a scale of seven points, the higher the better. From the evaluation of Zhu
/// and Yang 2024, appendix A.
enum class Question { Mastering, Functions, Errors, Details, Topology, Overall };
inline constexpr std::size_t questionCount = 6;
inline constexpr int minAnswer = 1, maxAnswer = 7;

/// A question in the person's language. Any thread.
struct QuestionWords
{
    QString question;
    QString low, high; ///< what the ends of the scale mean

    static QuestionWords of(Question question);
};

/// What one pupil answered. Any question may be left out.
struct Questionnaire
{
    std::array<std::optional<int>, questionCount> answers; ///< minAnswer to maxAnswer, in the order of Question

    bool isEmpty() const;
    bool operator==(const Questionnaire&) const = default;
};

/// What many answered to one question.
struct AnswerSum
{
    std::array<int, maxAnswer> counts{}; ///< of 1, 2 and so on

    int total() const;
    double mean() const; ///< 0 without answers
};

/// Sums in the order of Question. Answers that are left out count nowhere.
std::array<AnswerSum, questionCount> sumsOf(const QList<Questionnaire>& questionnaires);
} // namespace ui
