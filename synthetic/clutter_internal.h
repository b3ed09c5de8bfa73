// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cvo_slam/synthetic/furniture_internal.h"

// The things of an office and of a household; (x, y, z) as in Wall.

namespace cvo_slam::synthetic {

void mug(const Wall& wall, const Vector3& at);
/// Sheets of paper, or books, each turned a little.
void paper_pile(const Wall& wall, const Vector3& at, int sheets);
void desk_lamp(const Wall& wall, const Vector3& at);
/// A pot with a bush of that height on the whole.
void plant(const Wall& wall, const Vector3& at, double height);
void waste_bin(const Wall& wall, const Vector3& at);
/// A chair whose back is away from the wall, its seat's centre above (x, y).
void chair(const Wall& wall, double x, double y, double turn);
void office_chair(const Wall& wall, double x, double y, double turn);

/// A row of ring binders.
void binders(const Wall& wall, const Vector3& at, double width);
/// A shelf of binders, books and boxes.
void filing_shelf(const Wall& wall, double x, double width, int boards);
/// A desk with a screen and all that gathers on desks.
void workplace(const Wall& wall, double x, double width);
void whiteboard(const Wall& wall, double x, double width, double height);

}  // namespace cvo_slam::synthetic
