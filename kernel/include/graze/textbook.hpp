// The formulas as they are taught, uncertified: the baseline that the kernel's answers, errors and times are measured against.
// Each says how it is known to fail. Do not decide with them.
#pragma once

#include "graze/textbook/implicit.hpp"
#include "graze/textbook/parametric.hpp"
#include "graze/textbook/sphere.hpp"
#include "graze/textbook/triangle.hpp"
