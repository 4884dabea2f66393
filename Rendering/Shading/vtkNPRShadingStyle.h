// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRShadingStyle
 * @brief How a lit surface gets its colour: a piece of GLSL and its uniforms.
 *
 * A style knows nothing about VTK's shader templates: vtkNPRShadingPass puts its code into them.
 * The code declares the style's uniforms and defines one function,
 * `vec3 nprShade(NprSurface s)`, called for each fragment of a lit surface. It gets the
 * structures and functions of vtkNPRShadingFS.glsl:
 *
 * ```
 * struct NprSurface { vec3 position, normal, view, ambient, diffuse, specular; float power,
 * opacity; }; struct NprLight { vec3 direction, color; float attenuation; }; uniform int
 * nprLightCount; NprLight nprGetLight(int i, NprSurface s);                    // i in [0,
 * nprLightCount) float nprSpecularReflection(NprSurface s, vec3 direction);    // (r.v)^power float
 * nprSpecularHalfway(NprSurface s, vec3 direction);       // (n.h)^power
 * ```
 *
 * Vectors are in view coordinates; s.normal, s.view (to the eye) and light.direction (to the light)
 * are unit vectors; ambient, diffuse and specular are the material's colours times its
 * coefficients, vertex colours and mapped scalars included; light.color is colour times intensity.
 * How something changes from pixel to pixel is its difference to nprNeighbour(), not dFdx and dFdy,
 * which are undefined with depth peeling. The returned colour need not be clamped. A texture of the
 * actor multiplies it, as VTK does.
 *
 * Lambert's law as an example, with no uniforms:
 *
 * ```
 * vec3 nprShade(NprSurface s)
 * {
 *   vec3 color = s.ambient;
 *   for (int i = 0; i < nprLightCount; ++i)
 *   {
 *     NprLight l = nprGetLight(i, s);
 *     color += l.attenuation * l.color * max(dot(s.normal, l.direction), 0.0) * s.diffuse;
 *   }
 *   return color;
 * }
 * ```
 *
 * @par Adding a style:
 * one subclass with one .glsl file that implements GetCode() and SetUniforms(), and one line in
 * vtkNPRShadingStyles. Its parameters are set/get macros; DeclareParameter() in the constructor
 * makes each of them known by name to style files and the command line.
 * Names at global scope begin with npr and the style's name: npr alone is the pass's, others VTK's.
 *
 * @sa vtkNPRShadingPass vtkNPRShadingStyles vtkNPRSnippetStyle
 */
#ifndef vtkNPRShadingStyle_h
#define vtkNPRShadingStyle_h

#include "nprVTKCompat.h"
#include "vtkNPRRenderingShadingModule.h"
#include <vtkObject.h>

#include <functional> // for the parameters' accessors
#include <string>     // for code and names
#include <vector>     // for the parameters

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;
VTK_ABI_NAMESPACE_END

class VTKNPRRENDERINGSHADING_EXPORT vtkNPRShadingStyle : public vtkObject
{
public:
  vtkTypeMacro(vtkNPRShadingStyle, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The declarations of the style's uniforms and the definition of nprShade, in GLSL 1.50.
   */
  virtual std::string GetCode() = 0;

  /**
   * When GetCode() last began to return something else. Only then are shaders built anew.
   */
  vtkMTimeType GetCodeMTime() { return this->CodeTime.GetMTime(); }

  /**
   * Sets the style's uniforms in a program that has its code.
   */
  virtual void SetUniforms(vtkShaderProgram* program) = 0;

  /// @name Resources
  /// Textures of the style are bound before the first surface is drawn and let go after the last.
  /// The window's context is current.
  ///@{
  virtual void Activate(vtkOpenGLRenderWindow* window);
  virtual void Deactivate();
  virtual void ReleaseGraphicsResources(vtkWindow* window);
  ///@}

  /// @name Parameters by name
  /// The same parameters as the class's set/get functions, for style files, the command line and
  /// dialogues, so that these need not know the styles. A colour has three values from 0 to 1, a
  /// switch is 0 or 1.
  ///@{
  /// An index that does not exist gives nullptr or 0, and leaves the range as it is.
  int GetNumberOfParameters();
  const char* GetParameterName(int index);
  const char* GetParameterDescription(int index);
  /// How many values the parameter has; 0: any number up to MaximumSize.
  int GetParameterSize(int index);
  /// Least and greatest allowed value.
  void GetParameterRange(int index, double range[2]);
  /// False (and nothing changes) if there is no such parameter, or values are too many, too few,
  /// not finite or out of range.
  bool SetParameter(const char* name, int numberOfValues, const double* values)
    VTK_SIZEHINT(values, numberOfValues);
#ifndef __VTK_WRAP__
  /// The most values that a parameter of any number takes: what every OpenGL's textures hold.
  static constexpr int MaximumSize = 4096;
  bool SetParameter(const std::string& name, const std::vector<double>& values);
  /// Empty if there is no such parameter.
  std::vector<double> GetParameter(const std::string& name);
#endif
  ///@}

protected:
  vtkNPRShadingStyle();
  ~vtkNPRShadingStyle() override;

  /// To be called whenever GetCode() returns something else.
  void CodeModified();

#ifndef __VTK_WRAP__
  struct Parameter
  {
    std::string Name; // lower case, words joined by _
    std::string Description;
    int Size; // 0: any number
    double Range[2];
    std::function<void(const std::vector<double>&)> Set;
    std::function<std::vector<double>()> Get;
  };
  void DeclareParameter(Parameter parameter);
#endif

private:
#ifndef __VTK_WRAP__
  const Parameter* FindParameter(int index) const; ///< Null if there is none of that index.
#endif

  vtkNPRShadingStyle(const vtkNPRShadingStyle&) = delete;
  void operator=(const vtkNPRShadingStyle&) = delete;

  vtkTimeStamp CodeTime;
#ifndef __VTK_WRAP__
  std::vector<Parameter> Parameters;
#endif
};

#endif
