// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/interrupt.h"

#include <csignal>

namespace cvo_slam {
namespace {

volatile std::sig_atomic_t interrupt_requested = 0;

}  // namespace

InterruptGuard::InterruptGuard() {
  interrupt_requested = 0;
  previous_ = std::signal(SIGINT, [](int) {
    interrupt_requested = 1;
    std::signal(SIGINT, SIG_DFL);
  });
}

InterruptGuard::~InterruptGuard() { std::signal(SIGINT, previous_); }

bool InterruptGuard::requested() { return interrupt_requested != 0; }

}  // namespace cvo_slam
