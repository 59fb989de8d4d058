// SPDX-License-Identifier: MIT
#pragma once
#include "tests/support/seen_threads/seen_threads.h"
