  // SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
  // SPDX-License-Identifier: BSD-3-Clause
  // Each end has a say; far from it, it has none.
  vec2 fromStart = vec2(-nprPlaceVSOut.x, -nprPlaceVSOut.y);
  vec2 fromEnd = vec2(nprPlaceVSOut.x - nprSizeVSOut.x, nprPlaceVSOut.y);
  coverage = min(endCoverage(fromStart, nprNeighboursVSOut.xy, radius, -axis),
    endCoverage(fromEnd, nprNeighboursVSOut.zw, radius, axis));
  if (coverage <= 0.0)
  {
    discard;
  }
  vec2 lengths = mix(nprLengthsVSOut.xz, nprLengthsVSOut.yw, t);
  float dashPixels = nprSizeVSOut.x / max(nprLengthsVSOut.w - nprLengthsVSOut.z, 1e-6);
  lengths += (nprPlaceVSOut.x - along) / vec2(1.0, dashPixels);
  float visibleDash =
    dashCoverage(nprDashes, lengths.y, dashPixels, nprPlaceVSOut.y, radius);
  float hiddenDash =
    dashCoverage(nprHiddenDashes, lengths.y, dashPixels, nprPlaceVSOut.y, radius);
  shown = mix(nprHiddenOpacity * hiddenDash, visibleDash, visible);
  opacity = deposit(vec2(lengths.x, nprPlaceVSOut.y / max(radius, 0.5)), radius, opacity);
