// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRIllustrationStyle
 * @brief How an illustration looks: shading, lights, lines and paper, read from a JSON document.
 *
 * A style is a small JSON file; the built-in ones ("technical", "toon", "ink", "pencil", "brush",
 * "plain") are such files too, and the command, Python and C++ read the same. A document that is
 * not valid is refused as a whole, with a message that names the key.
 *
 * @code
 * vtkNew<vtkNPRIllustrationStyle> style;
 * style->LoadBuiltIn("ink");
 * @endcode
 *
 * @sa vtkNPRIllustration
 */
#ifndef vtkNPRIllustrationStyle_h
#define vtkNPRIllustrationStyle_h

#include "vtkNPRRenderingIllustrationModule.h"
#include <vtkObject.h>

#include <memory> // for the document
#include <string> // for names and messages
#include <vector> // for lists of names

class vtkNPRDrawingStyle;

#ifndef __VTK_WRAP__
namespace npr
{
struct LineStyle;
struct StyleDocument;
}
#endif

class VTKNPRRENDERINGILLUSTRATION_EXPORT vtkNPRIllustrationStyle : public vtkObject
{
public:
  static vtkNPRIllustrationStyle* New();
  vtkTypeMacro(vtkNPRIllustrationStyle, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The names of the styles that come with the library, in the order in which to show them.
  static std::vector<std::string> GetBuiltInNames();

  /// The document of a built-in style, to start one of your own from; empty for an unknown name.
  static std::string GetBuiltInJson(const std::string& name);

  /// @name Loading
  /// Each returns false, reports an error and leaves the style as it was when the document can't
  /// be read or is not valid. A new object holds the built-in style "technical".
  ///@{
  bool LoadBuiltIn(const std::string& name);
  bool LoadFile(const std::string& fileName);
  bool LoadString(const std::string& json);
  ///@}

  /// A built-in name, or else the path of a style file, which has a dot or a slash in it.
  bool Load(const std::string& nameOrFile);

  /// Draw only these kinds of lines. Kinds that the style has keep their look; others get the look
  /// of the style's first line that is made from curvature (smoothed, mostly) or not, as they are,
  /// else of its first, or plain black. An empty list means no lines.
  /// A line that the style gives a name of its own goes by that, too.
  bool SelectLines(const std::vector<std::string>& types);

  /// Draw these kinds of lines, too, where they are not drawn yet. They look as by SelectLines().
  bool AddLines(const std::vector<std::string>& types);

  /// Whether lines of the kind are drawn to which neither the style nor SetLineParameter() gives
  /// this parameter, so that its default counts.
  bool UsesLineDefault(const std::string& type, const std::string& parameter) const;

  /// Set a parameter of the kind of lines that are drawn: a text, or numbers parted by commas.
  bool SetLineParameter(
    const std::string& type, const std::string& parameter, const std::string& value);

  /// Have the points of lines carry a quantity of the surface: any that
  /// vtkNPRFeatureLines::AddQuantity() knows.
  bool AddQuantity(const std::string& name);

  /// @name Outline
  /// Outlines that cost no extraction of lines; their look is the style's (its section "outline").
  /// They are no strokes: no chains, no tapering, no paper. For the full control of lines choose
  /// NoOutline and lines such as "contours".
  ///  - BackFaces: back faces enlarged by a width; an even rim around closed, smooth surfaces.
  ///  - Grazing: dark where a surface is seen nearly edge-on; the cheapest, of uneven width.
  ///  - ImageEdges: where depth, normal or actor change from pixel to pixel; sharp edges, too.
  ///
  /// @sa vtkNPRShadingPass, vtkNPREdgePass
  ///@{
  enum OutlineKind
  {
    NoOutline = 0,
    BackFaces = 1,
    Grazing = 2,
    ImageEdges = 3
  };
  void SetOutline(int kind);
  int GetOutline() const;
  /// Their names in style files, by their kinds: "none", "back-faces", "grazing", "image-edges".
  static std::vector<std::string> GetOutlineNames();
  ///@}

  /// Set the paper to one colour: "#rrggbb" or an HTML colour name.
  bool SetBackground(const std::string& color);

  /// How the lines look on paper, where the picture's shorter side is so many millimetres long (see
  /// vtkNPRDrawingWriter::GetShorterSide()): for the strokes of vtkNPRIllustration::GetStrokes().
  void GetDrawingStyle(vtkNPRDrawingStyle* inks, double shorterSide) const;

  /// Whether the style shades surfaces. If not, they have the colour of the paper.
  bool HasShading() const;

  std::string GetName() const;
  std::string GetDescription() const;

  /// What was wrong at the last failure, as one line; empty if nothing was.
  vtkGetMacro(ErrorMessage, std::string);

protected:
  vtkNPRIllustrationStyle();
  ~vtkNPRIllustrationStyle() override;

private:
  vtkNPRIllustrationStyle(const vtkNPRIllustrationStyle&) = delete;
  void operator=(const vtkNPRIllustrationStyle&) = delete;

  friend class vtkNPRIllustration; // which makes what the document says
  bool Fail(const std::string& message);
  bool LoadDocument(const std::string& json, const std::string& origin);
  npr::LineStyle MakeLine(const std::string& type) const;

  std::unique_ptr<npr::StyleDocument> Document;
  std::string ErrorMessage;
};

#endif
