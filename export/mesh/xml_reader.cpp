// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/mesh/xml_reader.h"

#include <exception>
#include <utility>

#include <expat.h>

#include "design/file_error.h"

namespace latticast {

std::optional<std::string_view> XmlAttributes::find(std::string_view name) const {
  for (const char** pair = pairs_; *pair != nullptr; pair += 2) {
    if (name == *pair) {
      return pair[1];
    }
  }
  return std::nullopt;
}

struct XmlReader::Parser {
  struct Free {
    void operator()(XML_Parser parser) const { XML_ParserFree(parser); }
  };

  [[noreturn]] void fail(const std::string& reason) const {
    throw FileError(file, "line " + std::to_string(XML_GetCurrentLineNumber(expat.get())) +
                              " of the XML inside: " + reason);
  }

  // Exceptions must not pass through the parser, which is C.
  template <typename Event>
  void guard(Event event) {
    try {
      if (!thrown) {
        event();
      }
    } catch (...) {
      thrown = std::current_exception();
      XML_StopParser(expat.get(), XML_FALSE);
    }
  }

  void parse(std::string_view piece, bool last) {
    const XML_Status status =
        XML_Parse(expat.get(), piece.data(), static_cast<int>(piece.size()), last ? 1 : 0);
    if (thrown) {
      std::rethrow_exception(thrown);
    }
    if (status != XML_STATUS_OK) {
      fail(XML_ErrorString(XML_GetErrorCode(expat.get())));
    }
  }

  static Parser& of(void* data) { return *static_cast<Parser*>(data); }

  static void start(void* data, const char* name, const char** attributes) {
    Parser& parser = of(data);
    parser.guard([&] { parser.events.start(name, XmlAttributes(attributes)); });
  }

  static void end(void* data, const char* name) {
    Parser& parser = of(data);
    parser.guard([&] { parser.events.end(name); });
  }

  static void refuse_document_type(void* data, const char* /*name*/, const char* /*system*/,
                                   const char* /*public_name*/, int /*internal*/) {
    Parser& parser = of(data);
    parser.guard([&] { parser.fail("has a document type"); });
  }

  std::filesystem::path file;
  Events events;
  std::unique_ptr<XML_ParserStruct, Free> expat{XML_ParserCreateNS(nullptr, '|')};
  std::exception_ptr thrown;
};

XmlReader::XmlReader(std::filesystem::path file, Events events)
    : parser_(std::make_unique<Parser>()) {
  parser_->file = std::move(file);
  parser_->events = std::move(events);
  XML_SetUserData(parser_->expat.get(), parser_.get());
  XML_SetElementHandler(parser_->expat.get(), &Parser::start, &Parser::end);
  XML_SetStartDoctypeDeclHandler(parser_->expat.get(), &Parser::refuse_document_type);
}

XmlReader::~XmlReader() = default;

void XmlReader::read(std::string_view piece) {
  parser_->parse(piece, false);
}

void XmlReader::finish() {
  parser_->parse({}, true);
}

std::size_t XmlReader::line_number() const {
  return XML_GetCurrentLineNumber(parser_->expat.get());
}

}  // namespace latticast
