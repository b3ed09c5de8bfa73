// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Every instruction set gives the same pose, to single precision.
#include "cvo_slam/frontend/simd.h"

#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/tests/frontend/solver_checks.h"

namespace cvo_slam {
namespace {

class Simd : public testing::Test {
 protected:
  ~Simd() override { pin_simd(SimdPath::kBest); }

  /// Returns the paths of this CPU.
  static std::vector<SimdPath> available() {
    std::vector<SimdPath> paths;
    for (const auto& [name, path] : simd_path_names()) {
      try {
        pin_simd(path);
        paths.push_back(path);
      } catch (const OptionError&) {
        EXPECT_NE(path, SimdPath::kScalar) << "every CPU has this one";
      }
    }
    return paths;
  }
};

TEST_F(Simd, EveryPathIsTheOneInUseWhenPinned) {
  std::map<std::string, int> names;
  for (const SimdPath path : available()) {
    pin_simd(path);
    ++names[simd_in_use()];
  }
  pin_simd(SimdPath::kScalar);
  EXPECT_THAT(simd_in_use(), testing::AnyOf("EMU128", "SCALAR"));
  // All paths differ, except the best, which is one of them.
  for (const auto& [name, count] : names) EXPECT_LE(count, 2) << name;
  EXPECT_EQ(names.size() + 1, available().size());
}

TEST_F(Simd, PathsAgreeToSinglePrecision) {
  const PointCloud fixed = centred_cloud(400, 1);
  const PointCloud moving = noisy(transformed(fixed, random_motion(0.02, 0.03, 2).inverse()), 3);
  const auto options =
      exact_options(Solver::kNewton, ColorKernel::kSquaredExponential, {0.1, 0.05, 0.025});
  pin_simd(SimdPath::kScalar);
  const RegistrationResult scalar = align(fixed, moving, SE3(), options);
  for (const SimdPath path : available()) {
    pin_simd(path);
    SCOPED_TRACE(simd_in_use());
    const RegistrationResult result = align(fixed, moving, SE3(), options);
    // Sums in another order and fused multiply-adds: 1e-7 of a metre, and of the objective.
    expect_near(result.T_fixed_moving, scalar.T_fixed_moving, 1e-6, 1e-6);
    EXPECT_NEAR(result.objective, scalar.objective, 1e-5 * scalar.objective);
    EXPECT_LT((result.covariance - scalar.covariance).norm(), 1e-4 * scalar.covariance.norm());
  }
}

}  // namespace
}  // namespace cvo_slam
