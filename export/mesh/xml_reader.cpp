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

  // The parser begins an element anew with each piece until it has all of it: a long one must come
  // in few pieces. They grow twofold while it makes no headway.
  void take(std::string_view piece) {
    waiting.append(piece);
    if (waiting.size() < enough) return;
    const XML_Index before = XML_GetCurrentByteIndex(expat.get());
    parse(waiting, false);
    const bool goes_on = XML_GetCurrentByteIndex(expat.get()) != before;
    enough = goes_on ? least : 2 * enough;
    waiting.clear();
  }

  void finish() {
    parse(waiting, false);
    parse({}, true);
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

  static void text(void* data, const char* characters, int size) {
    Parser& parser = of(data);
    parser.guard(
        [&] { parser.events.text(std::string_view(characters, static_cast<std::size_t>(size))); });
  }

  static void prefix(void* data, const char* name, const char* name_space) {
    Parser& parser = of(data);
    parser.guard([&] {
      parser.events.prefix(name == nullptr ? "" : name, name_space == nullptr ? "" : name_space);
    });
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

  static constexpr std::size_t least = 1U << 16U;
  std::string waiting;
  std::size_t enough = least;
};

XmlReader::XmlReader(std::filesystem::path file, Events events)
    : parser_(std::make_unique<Parser>()) {
  parser_->file = std::move(file);
  parser_->events = std::move(events);
  XML_SetUserData(parser_->expat.get(), parser_.get());
  XML_SetElementHandler(parser_->expat.get(), &Parser::start, &Parser::end);
  if (parser_->events.text) XML_SetCharacterDataHandler(parser_->expat.get(), &Parser::text);
  if (parser_->events.prefix) {
    XML_SetStartNamespaceDeclHandler(parser_->expat.get(), &Parser::prefix);
  }
  XML_SetStartDoctypeDeclHandler(parser_->expat.get(), &Parser::refuse_document_type);
}

XmlReader::~XmlReader() = default;

void XmlReader::read(std::string_view piece) {
  parser_->take(piece);
}

void XmlReader::finish() {
  parser_->finish();
}

std::size_t XmlReader::line_number() const {
  return XML_GetCurrentLineNumber(parser_->expat.get());
}

}  // namespace latticast
