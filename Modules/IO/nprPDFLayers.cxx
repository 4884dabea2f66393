// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprPDFLayers.h"

#include "nprPageComposer.h"

#include <qpdf/Buffer.hh>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFObjectHandle.hh>
#include <qpdf/QPDFPageDocumentHelper.hh>
#include <qpdf/QPDFPageObjectHelper.hh>
#include <qpdf/QPDFWriter.hh>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <stdexcept>

namespace npr
{
namespace
{
using Object = QPDFObjectHandle;

/// What a page shows, to be drawn anywhere. Its bytes stay as they are, compressed. It is no
/// transparency group, as the page is: printers would make pixels of the whole of it.
Object MakeForm(QPDFPageObjectHelper& page)
{
  page.coalesceContentStreams();
  Object form = page.getObjectHandle().getKey("/Contents");
  Object facts = form.getDict();
  facts.replaceKey("/Type", Object::newName("/XObject"));
  facts.replaceKey("/Subtype", Object::newName("/Form"));
  facts.replaceKey("/BBox", page.getMediaBox());
  facts.replaceKey("/Resources", page.getAttribute("/Resources", false));
  return form;
}

void LayPages(QPDF& document, const std::vector<std::string>& names)
{
  QPDFPageDocumentHelper pages(document);
  std::vector<QPDFPageObjectHelper> layers = pages.getAllPages();
  if (layers.size() != std::max<std::size_t>(names.size(), 1))
  {
    throw std::runtime_error("it has " + std::to_string(layers.size()) + " pages for " +
      std::to_string(names.size()) + " layers");
  }
  Object groups = Object::newArray();
  Object forms = Object::newDictionary();
  Object properties = Object::newDictionary();
  std::string contents;
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    Object group = document.makeIndirectObject(Object::newDictionary());
    group.replaceKey("/Type", Object::newName("/OCG"));
    group.replaceKey("/Name", Object::newUnicodeString(names[i]));
    groups.appendItem(group);
    const std::string key = "/Layer" + std::to_string(i + 1);
    forms.replaceKey(key, MakeForm(layers[i]));
    properties.replaceKey(key, group);
    contents += "/OC " + key + " BDC " + key + " Do EMC\n";
    if (i > 0)
    {
      pages.removePage(layers[i]);
    }
  }

  Object resources = Object::newDictionary();
  resources.replaceKey("/XObject", forms);
  resources.replaceKey("/Properties", properties);
  Object page = layers[0].getObjectHandle();
  page.replaceKey("/Resources", resources);
  page.replaceKey("/Contents", Object::newStream(&document, contents));
  if (!names.empty())
  {
    // Programs list them from the top, and so do people who draw.
    std::vector<Object> order = groups.getArrayAsVector();
    std::reverse(order.begin(), order.end());
    Object configuration = Object::newDictionary();
    configuration.replaceKey("/Order", Object::newArray(order));
    Object optional = Object::newDictionary();
    optional.replaceKey("/OCGs", groups);
    optional.replaceKey("/D", configuration);
    document.getRoot().replaceKey("/OCProperties", optional);
  }
}

std::string Write(QPDF& document)
{
  QPDFWriter writer(document);
  writer.setOutputMemory();
  writer.setDecodeLevel(qpdf_dl_none);
  writer.setObjectStreamMode(qpdf_o_generate);
  writer.setMinimumPDFVersion("1.5"); // of layers, and of streams of objects
  writer.setDeterministicID(true);
  writer.write();
  const auto bytes = writer.getBufferSharedPointer();
  return { reinterpret_cast<const char*>(bytes->getBuffer()), bytes->getSize() };
}
}

//------------------------------------------------------------------------------
std::string LayPagesAsLayers(const std::string& pdf, const std::vector<std::string>& names)
{
  try
  {
    QPDF document;
    document.setSuppressWarnings(true);
    document.processMemoryFile("pages", pdf.data(), pdf.size());
    LayPages(document, names);
    return Write(document);
  }
  catch (const std::exception& error)
  {
    throw DrawingError("qpdf can't make layers of what cairo wrote: " + std::string(error.what()) +
      ". Write an SVG instead.");
  }
}
}
