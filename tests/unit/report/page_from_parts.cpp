// SPDX-License-Identifier: GPL-3.0-or-later
// page_from_parts TITLE FOLDER FILE: the page of FOLDER's report.json, view.json and model.glb.
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>

#include "report/report_page.h"

namespace {

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read " + path);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

int main(int argument_count, char** arguments) {
  if (argument_count != 4) {
    std::cerr << "usage: page_from_parts TITLE FOLDER FILE\n";
    return 2;
  }
  const std::string folder = arguments[2];
  std::ofstream(arguments[3], std::ios::binary)
      << latticast::report_page({arguments[1], bytes_of(folder + "/report.json"),
                                 bytes_of(folder + "/view.json"), bytes_of(folder + "/model.glb")});
  return 0;
}
