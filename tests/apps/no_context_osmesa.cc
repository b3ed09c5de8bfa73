// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A libOSMesa.so.8 that can be loaded and gives no context, as on a machine whose Mesa is broken.
#include <GL/osmesa.h>

extern "C" {

OSMesaContext OSMesaCreateContextExt(GLenum /*format*/, GLint /*depth*/, GLint /*stencil*/,
                                     GLint /*accum*/, OSMesaContext /*share*/) {
  return nullptr;
}

void OSMesaDestroyContext(OSMesaContext /*context*/) {}

GLboolean OSMesaMakeCurrent(OSMesaContext /*context*/, void* /*buffer*/, GLenum /*type*/,
                            GLsizei /*width*/, GLsizei /*height*/) {
  return GL_FALSE;
}

OSMESAproc OSMesaGetProcAddress(const char* /*name*/) { return nullptr; }
}
