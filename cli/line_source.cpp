#include "cli/line_source.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <system_error>

namespace graze::cli {

LineSource::LineSource(const std::string& path)
    : input_(path == "-" ? &std::cin : &file_), name_(path == "-" ? "<stdin>" : path), buffer_(longest_line + 2) {
  if (path == "-") return;
  // A directory opens like a file and fails only when it is read.
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    error_ = "graze: cannot read '" + path + "': it is a directory; name a file in it";
    return;
  }
  errno = 0;
  file_.open(path, std::ios::in | std::ios::binary);
  if (file_.is_open()) return;
  const int reason = errno;
  error_ = "graze: cannot read '" + path + "': " + std::strerror(reason);
  error_ += reason == EACCES   ? "; allow it with chmod u+r"
            : reason == ENOENT ? "; check the path, or leave it out to read standard input"
                               : "; name another file, or leave it out to read standard input";
}

bool LineSource::next() {
  if (!error_.empty() || !input_->good()) return false;
  errno = 0;
  input_->getline(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
  const int reason = errno;
  auto length = static_cast<std::size_t>(input_->gcount());
  if (input_->bad()) {
    error_ = "graze: cannot read " + name_ + (number_ == 0 ? "" : " beyond line " + std::to_string(number_)) + ": " +
             (reason != 0 ? std::strerror(reason) : "input error") + "; give a file that can be read";
    return false;
  }
  if (input_->eof() && length == 0) return false;
  ++number_;
  if (!input_->eof() && !input_->fail()) --length;  // gcount counts the newline
  if (length > longest_line) {
    error_ = place() + ": the line is longer than " + std::to_string(longest_line) + " bytes";
    return false;
  }
  line_ = {buffer_.data(), length};
  return true;
}

std::string LineSource::place() const {
  return name_ + ":" + std::to_string(number_);
}

}  // namespace graze::cli
