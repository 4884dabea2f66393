// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprPDFReading.h
 * @brief Layers of a PDF, and what is painted in each, read back by qpdf.
 */
#ifndef nprPDFReading_h
#define nprPDFReading_h

#include <qpdf/QPDF.hh>
#include <qpdf/QPDFObjectHandle.hh>
#include <qpdf/QPDFPageDocumentHelper.hh>
#include <qpdf/QPDFPageObjectHelper.hh>
#include <qpdf/QPDFWriter.hh>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace nprtest
{
struct PDFReading
{
  struct Layer
  {
    std::string Name;
    int Painted = 0; // strokes, filled areas, texts and images
  };
  int Pages = 0;
  std::vector<Layer> Layers; // as viewers list them
  std::string Problems;      // what no PDF of ours may have
};

/// Follows what is drawn through a stream of contents and the forms that it draws.
class PDFContents : public QPDFObjectHandle::ParserCallbacks
{
public:
  static constexpr int NoLayer = -1;

  /// Whatever is drawn there is drawn in a layer already, or in none.
  PDFContents(QPDFObjectHandle resources, const std::vector<QPDFObjectHandle>& groups, int layer,
    PDFReading& reading)
    : Resources(resources), Groups(groups), Layer(layer), Reading(reading)
  {
  }

  void handleObject(QPDFObjectHandle object) override
  {
    if (object.isInlineImage())
    {
      this->Paint();
    }
    else if (!object.isOperator())
    {
      this->Operands.push_back(object);
    }
    else
    {
      this->Follow(object.getOperatorValue());
      this->Operands.clear();
    }
  }

  void handleEOF() override
  {
    if (!this->Open.empty())
    {
      this->Tell(this->Open.back() + " has no end");
    }
  }

private:
  void Follow(const std::string& name)
  {
    static const std::set<std::string> Painting = { "S", "s", "f", "F", "f*", "B", "B*", "b", "b*",
      "sh", "Tj", "TJ", "'", "\"" };
    if (name == "q" || name == "BT" || name == "BMC" || name == "BDC")
    {
      this->Open.push_back(name);
      if (name == "BDC" && this->Operands.size() == 2 && this->Operands[0].getName() == "/OC")
      {
        this->Open.back() = "layer";
        this->Enter(this->Resources.getKey("/Properties").getKey(this->Operands[1].getName()));
      }
    }
    else if (name == "Q")
    {
      this->Close({ "q" });
    }
    else if (name == "ET")
    {
      this->Close({ "BT" });
    }
    else if (name == "EMC")
    {
      if (this->Close({ "BMC", "BDC", "layer" }) == "layer")
      {
        this->Layer = NoLayer;
      }
    }
    else if (name == "Do")
    {
      this->Draw(this->Resources.getKey("/XObject").getKey(this->Operands.at(0).getName()));
    }
    else if (Painting.count(name) > 0)
    {
      this->Paint();
    }
  }

  void Draw(QPDFObjectHandle object)
  {
    if (object.getDict().getKey("/Subtype").getName() != "/Form")
    {
      this->Paint();
      return;
    }
    PDFContents form(
      object.getDict().getKey("/Resources"), this->Groups, this->Layer, this->Reading);
    object.parseAsContents(&form);
  }

  void Enter(QPDFObjectHandle group)
  {
    if (this->Layer != NoLayer)
    {
      this->Tell("a layer begins in another");
    }
    for (std::size_t i = 0; i < this->Groups.size(); ++i)
    {
      if (this->Groups[i].getObjGen() == group.getObjGen())
      {
        this->Layer = static_cast<int>(i);
        return;
      }
    }
    this->Tell("a layer that is not listed");
  }

  std::string Close(const std::set<std::string>& names)
  {
    if (this->Open.empty() || names.count(this->Open.back()) == 0)
    {
      this->Tell("an end of " + *names.begin() + " where it is not the last to be open");
      return "";
    }
    const std::string name = this->Open.back();
    this->Open.pop_back();
    return name;
  }

  void Paint()
  {
    if (this->Layer == NoLayer)
    {
      this->Tell("something is painted in no layer");
      return;
    }
    ++this->Reading.Layers[this->Layer].Painted;
  }

  void Tell(const std::string& problem) { this->Reading.Problems += problem + "; "; }

  QPDFObjectHandle Resources;
  const std::vector<QPDFObjectHandle>& Groups;
  int Layer;
  PDFReading& Reading;
  std::vector<QPDFObjectHandle> Operands;
  std::vector<std::string> Open;
};

inline PDFReading ReadPDF(const std::string& file)
{
  PDFReading reading;
  QPDF document;
  document.setSuppressWarnings(true);
  document.processFile(file.c_str());
  QPDFObjectHandle optional = document.getRoot().getKey("/OCProperties");
  std::vector<QPDFObjectHandle> groups;
  if (optional.isDictionary())
  {
    // Listed from the top.
    groups = optional.getKey("/D").getKey("/Order").getArrayAsVector();
    std::reverse(groups.begin(), groups.end());
    if (optional.getKey("/OCGs").getArrayNItems() != static_cast<int>(groups.size()))
    {
      reading.Problems += "not all layers are listed; ";
    }
    if (optional.getKey("/D").hasKey("/OFF") || optional.getKey("/D").hasKey("/BaseState"))
    {
      reading.Problems += "a layer is off; ";
    }
  }
  for (QPDFObjectHandle& group : groups)
  {
    if (group.getKey("/Type").getName() != "/OCG")
    {
      reading.Problems += "a layer is no optional content group; ";
    }
    reading.Layers.push_back({ group.getKey("/Name").getUTF8Value() });
  }
  for (QPDFPageObjectHelper& page : QPDFPageDocumentHelper(document).getAllPages())
  {
    ++reading.Pages;
    PDFContents contents(
      page.getAttribute("/Resources", false), groups, PDFContents::NoLayer, reading);
    page.parseContents(&contents);
  }
  for (const QPDFExc& warning : document.getWarnings())
  {
    reading.Problems += warning.getMessageDetail() + "; ";
  }
  return reading;
}

/// Writes the file anew with the layer off by default; false if there is no such layer.
inline bool SwitchOff(const std::string& from, const std::string& layer, const std::string& to)
{
  QPDF document;
  document.processFile(from.c_str());
  QPDFObjectHandle optional = document.getRoot().getKey("/OCProperties");
  for (QPDFObjectHandle& group : optional.getKey("/OCGs").getArrayAsVector())
  {
    if (group.getKey("/Name").getUTF8Value() == layer)
    {
      QPDFObjectHandle off = QPDFObjectHandle::newArray();
      off.appendItem(group);
      optional.getKey("/D").replaceKey("/OFF", off);
      QPDFWriter(document, to.c_str()).write();
      return true;
    }
  }
  return false;
}
}

#endif
