// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/study.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <utility>

#include <fmt/core.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace latticast {
namespace {

std::string text_of(const Cell& cell, const char* number_format) {
  if (const auto* words = std::get_if<std::string>(&cell)) return *words;
  return fmt::format(fmt::runtime(number_format), std::get<double>(cell));
}

std::string line(const std::vector<Cell>& row, const char* number_format, const char* begin,
                 const char* between, const char* end) {
  std::string result = begin;
  for (std::size_t i = 0; i < row.size(); ++i) {
    result += (i == 0 ? "" : between) + text_of(row[i], number_format);
  }
  return result + end;
}

void write_text(const std::filesystem::path& path, const std::string& text) {
  std::ofstream file(path);
  file << text;
  if (!file.flush()) throw std::runtime_error("cannot write " + path.string());
}

double processor_now() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// All that the child writes until it ends, or until the time is over.
bool read_until_end(int pipe, double limit_s, std::string& text) {
  timespec start{};
  clock_gettime(CLOCK_MONOTONIC, &start);
  while (true) {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    const double passed = static_cast<double>(now.tv_sec - start.tv_sec) +
                          1e-9 * static_cast<double>(now.tv_nsec - start.tv_nsec);
    if (passed > limit_s) return false;
    pollfd waiting{pipe, POLLIN, 0};
    if (poll(&waiting, 1, static_cast<int>(1000 * (limit_s - passed)) + 1) <= 0) continue;
    char buffer[4096];
    const ssize_t count = read(pipe, buffer, sizeof buffer);
    if (count <= 0) return true;
    text.append(buffer, static_cast<std::size_t>(count));
  }
}

[[noreturn]] void run_child(const std::function<std::string()>& call, int pipe, double limit_s) {
  const auto seconds = static_cast<rlim_t>(limit_s) + 1;
  const rlimit limit{seconds, seconds};
  setrlimit(RLIMIT_CPU, &limit);
  int status = 0;
  try {
    const std::string result = call();
    const ssize_t written = write(pipe, result.data(), result.size());
    if (written != static_cast<ssize_t>(result.size())) status = 1;
  } catch (...) {
    status = 1;
  }
  _exit(status);
}

}  // namespace

StudyTable::StudyTable(std::string name, std::vector<std::string> columns)
    : name_(std::move(name)), columns_(std::move(columns)) {}

void StudyTable::add(std::vector<Cell> row) {
  if (row.size() != columns_.size()) {
    throw std::invalid_argument(name_ + ": a row has not as many cells as there are columns");
  }
  rows_.push_back(std::move(row));
}

void StudyTable::write(const std::filesystem::path& folder, bool on_page) const {
  const std::vector<Cell> head(columns_.begin(), columns_.end());
  std::string csv = line(head, "", "", ",", "\n");
  std::string page = line(head, "", "| ", " | ", " |\n") + "|";
  for (std::size_t i = 0; i < columns_.size(); ++i) page += "---|";
  page += "\n";
  for (const std::vector<Cell>& row : rows_) {
    csv += line(row, "{:.17g}", "", ",", "\n");
    page += line(row, "{:.3g}", "| ", " | ", " |\n");
  }
  write_text(folder / (name_ + ".csv"), csv);
  if (on_page) write_text(folder / (name_ + ".md"), page);
}

void write_sentence(const std::filesystem::path& folder, const std::string& name,
                    const std::string& text) {
  write_text(folder / (name + ".md"), text + "\n");
}

std::filesystem::path study_folder(int count, char** arguments) {
  if (count != 2) {
    fmt::print(stderr, "usage: {} FOLDER\n", arguments[0]);
    std::exit(2);
  }
  std::filesystem::path folder = arguments[1];
  std::filesystem::create_directories(folder);
  return folder;
}

double processor_seconds(const std::function<void()>& call, double least_batch_s) {
  double best = std::numeric_limits<double>::infinity();
  for (int batch = 0; batch < 3; ++batch) {
    const double begin = processor_now();
    double passed = 0;
    int calls = 0;
    for (int next = 1; passed < least_batch_s; next = calls) {
      for (int i = 0; i < next; ++i) call();
      calls += next;
      passed = processor_now() - begin;
    }
    best = std::min(best, passed / calls);
    if (passed > 1) break;
  }
  return best;
}

double fitted_exponent(std::span<const double> x, std::span<const double> y) {
  const auto n = static_cast<double>(x.size());
  double mean_x = 0;
  double mean_y = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    mean_x += std::log(x[i]) / n;
    mean_y += std::log(y[i]) / n;
  }
  double above = 0;
  double below = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double apart = std::log(x[i]) - mean_x;
    above += apart * (std::log(y[i]) - mean_y);
    below += apart * apart;
  }
  return above / below;
}

double peak_memory_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

Cost in_own_process(const std::function<std::string()>& call, double limit_s) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("cannot make a pipe");
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("cannot start a process");
  if (child == 0) {
    close(ends[0]);
    run_child(call, ends[1], limit_s);
  }
  close(ends[1]);
  Cost cost;
  // Others may keep the processor busy; but a child that sleeps must end, too.
  const bool in_time = read_until_end(ends[0], 10 * limit_s, cost.result);
  close(ends[0]);
  if (!in_time) kill(child, SIGKILL);
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  cost.finished = in_time && WIFEXITED(status) && WEXITSTATUS(status) == 0;
  cost.seconds = seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
  cost.memory_mb = static_cast<double>(usage.ru_maxrss) / 1024;
  return cost;
}

}  // namespace latticast
