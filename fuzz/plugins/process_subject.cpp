#include "fuzz/plugins/process_subject.hpp"

#include <algorithm>
#include <cstdio>

#include "fuzz/answer_text.hpp"
#include "fuzz/words.hpp"

namespace graze::fuzz {
namespace {

template <Real T>
constexpr std::size_t precision_index = sizeof(T) == sizeof(double);

constexpr std::string_view error_word = "error ";

/// What a line says; a line that is no answer is a failure.
template <Real T>
Reply<T> read_reply(const Case<T>& input, const std::string& line) {
  if (line == not_offered_line) return {};
  if (line.starts_with(error_word)) return Reply<T>::failed(printable(std::string_view(line).substr(error_word.size())));
  auto answer = parse_answer(input, line);
  if (auto* a = std::get_if<Answer<T>>(&answer)) return std::move(*a);
  return Reply<T>::failed("answered what is no answer: " + std::get<LineError>(answer).what);
}

std::string seconds(double limit) {
  char text[32];
  std::snprintf(text, sizeof text, "%g s", limit);
  return text;
}

}  // namespace

std::unique_ptr<Process> ProcessSubject::take(std::size_t precision, std::string& wrong) const {
  {
    const std::scoped_lock lock(mutex_);
    if (!waiting_[precision].empty()) {
      std::unique_ptr<Process> process = std::move(waiting_[precision].back());
      waiting_[precision].pop_back();
      return process;
    }
  }
  auto started = Process::start(settings_.commands[precision]);
  if (auto* error = std::get_if<std::string>(&started)) {
    wrong = *error;
    return nullptr;
  }
  return std::get<std::unique_ptr<Process>>(std::move(started));
}

void ProcessSubject::give_back(std::size_t precision, std::unique_ptr<Process> process) const {
  const std::scoped_lock lock(mutex_);
  waiting_[precision].push_back(std::move(process));
}

template <Real T>
ProcessSubject::Failure ProcessSubject::answer_at_once(std::span<const Case<T>> inputs, std::span<Reply<T>> replies) const {
  Failure failure;
  std::unique_ptr<Process> process = take(precision_index<T>, failure.how);
  if (process == nullptr) return failure;
  std::string text;
  for (const Case<T>& input : inputs) text.append(format_case(input)).append("\n");
  std::vector<std::string> lines;
  const std::size_t count = inputs.size();
  const Process::Seconds limit(settings_.time_limit);
  const auto outcome = settings_.stays ? process->ask(text, count, lines, limit) : process->run(text, count, lines, limit);

  failure.place = std::min(lines.size(), count - 1);
  const std::string end = outcome == Process::Outcome::ended ? process->end() : "";
  if (outcome == Process::Outcome::hung) {
    failure.how = "hung: no answer within " + seconds(settings_.time_limit);
    failure.is_hang = true;
  } else if (outcome == Process::Outcome::too_long) {
    failure.how = "answered a line without end";
  } else if (lines.size() > count) {
    failure.how = "answered more lines than there were cases";
  } else if (lines.size() < count) {
    failure.how = end + " and gave no answer";
  } else if (outcome == Process::Outcome::ended && process->exit_status() > 128) {
    failure.how = end;
  }
  for (std::size_t i = 0; i < std::min(lines.size(), count); ++i) {
    replies[i] = read_reply(inputs[i], lines[i]);
    if (replies[i].failure().empty() || !failure.how.empty()) continue;
    failure.how = replies[i].failure();
    failure.place = i;
  }
  if (!failure.how.empty()) {
    process->kill();
  } else if (settings_.stays) {
    give_back(precision_index<T>, std::move(process));
  }
  return failure;
}

template <Real T>
bool ProcessSubject::answer_parts(std::span<const Case<T>> inputs, std::span<Reply<T>> replies) const {
  if (inputs.empty()) return true;
  const std::size_t count = inputs.size();
  const auto part = [&](std::size_t from, std::size_t to) {
    return answer_parts(inputs.subspan(from, to - from), replies.subspan(from, to - from));
  };
  if (hangs_ >= most_hangs) {
    for (Reply<T>& reply : replies) {
      reply = Reply<T>::failed("was not asked: it had hung on " + std::to_string(most_hangs) + " cases");
    }
    return false;
  }
  if (count > most_at_once_) {
    const bool first = part(0, count / 2);
    return part(count / 2, count) && first;
  }
  const Failure failure = answer_at_once(inputs, replies);
  if (failure.how.empty()) return true;
  if (count == 1) {
    if (failure.is_hang) ++hangs_;
    replies[0] = Reply<T>::failed(failure.how);
    return false;
  }
  // The case behind the last line is at fault, unless lines were kept in a buffer or are too many.
  const std::size_t k = failure.place;
  if (!part(k, k + 1)) {
    part(0, k);
    part(k + 1, count);
    return false;
  }
  const bool first = part(0, count / 2), second = part(count / 2, count);
  if (!first || !second) return false;
  if (failure.is_hang) {
    // It is slow, and its lines come all together.
    most_at_once_ = std::min<std::size_t>(most_at_once_, count / 2);
    return true;
  }
  const auto told =
      std::find_if(replies.begin(), replies.end(), [](const Reply<T>& reply) { return static_cast<bool>(reply); });
  if (told == replies.end()) return true;
  *told =
      Reply<T>::failed(failure.how + ", but only when it was asked " + std::to_string(count) + " cases at once, this one too");
  return false;
}

template <Real T>
void ProcessSubject::answer_all(std::span<const Case<T>> inputs, std::span<Reply<T>> replies) const {
  std::vector<Case<T>> offered;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    replies[i] = {};
    if (!settings_.declaration.offers_query(inputs[i])) continue;
    offered.push_back(inputs[i]);
    places.push_back(i);
  }
  std::vector<Reply<T>> answers(offered.size());
  (void)answer_parts(std::span<const Case<T>>(offered), std::span(answers));
  for (std::size_t i = 0; i < places.size(); ++i) replies[places[i]] = std::move(answers[i]);
}

template <Real T>
Reply<T> ProcessSubject::answer_one(const Case<T>& input) const {
  Reply<T> reply;
  answer_all(std::span(&input, 1), std::span(&reply, 1));
  return reply;
}

template Reply<float> ProcessSubject::answer_one(const Case<float>&) const;
template Reply<double> ProcessSubject::answer_one(const Case<double>&) const;
template void ProcessSubject::answer_all(std::span<const Case<float>>, std::span<Reply<float>>) const;
template void ProcessSubject::answer_all(std::span<const Case<double>>, std::span<Reply<double>>) const;

}  // namespace graze::fuzz
