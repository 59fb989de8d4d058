// SPDX-License-Identifier: MIT
// OpenGL's header with its later functions declared; Mesa's library has them all.
#pragma once

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
