// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/frontend/registration.h"

namespace cvo_slam {
namespace {

KernelOptions paper_kernel() {
  KernelOptions kernel;
  kernel.sigma = 0.1;
  kernel.sparsification = 1e-3;
  return kernel;
}

PointCloud point(const std::array<float, PointCloud::kFeatures>& features) {
  PointCloud cloud;
  cloud.resize(1);
  for (std::size_t f = 0; f < features.size(); ++f) cloud.features[f][0] = features[f];
  return cloud;
}

TEST(SupportRadius, IsThatOfThePaper) {
  // sqrt(2 ln(0.1^2 / 1e-3)) = sqrt(2 ln 10)
  EXPECT_NEAR(support_radius(paper_kernel(), 1.0), 2.145966, 1e-6);
  EXPECT_NEAR(support_radius(paper_kernel(), 0.15), 0.15 * 2.145966, 1e-7);
}

TEST(SupportRadius, IsWhereTheKernelFallsToTheSparsification) {
  const KernelOptions kernel = paper_kernel();
  const double radius = support_radius(kernel, 0.1);
  EXPECT_NEAR(kernel.sigma * kernel.sigma * std::exp(-radius * radius / (2 * 0.1 * 0.1)),
              kernel.sparsification, 1e-15);
}

TEST(SupportRadius, IsZeroWhereNothingReachesTheSparsification) {
  KernelOptions kernel = paper_kernel();
  kernel.sigma = 0.5;
  kernel.sparsification = 0.25;  // sigma^2
  EXPECT_EQ(support_radius(kernel, 0.1), 0.0);
  kernel.sparsification = 1;
  EXPECT_EQ(support_radius(kernel, 0.1), 0.0);
}

TEST(LabelProduct, LinearIsThePapersProductOfColoursAlone) {
  KernelOptions kernel = paper_kernel();
  kernel.color_kernel = ColorKernel::kLinear;
  const PointCloud a = point({10, 20, 30, 5, -5});
  const PointCloud b = point({1, 2, 3, 100, 100});
  EXPECT_NEAR(label_product(kernel, a, 0, b, 0), 1e-5 * (10 + 40 + 90), 1e-15);
  EXPECT_EQ(label_product(kernel, a, 0, b, 0), label_product(kernel, b, 0, a, 0));
}

TEST(LabelProduct, SquaredExponentialFallsWithTheDifferencesInTheirScales) {
  KernelOptions kernel = paper_kernel();
  kernel.color_kernel = ColorKernel::kSquaredExponential;
  kernel.color_scale = 100;
  kernel.gradient_scale = 10;
  const PointCloud a = point({10, 20, 30, 5, -5});
  EXPECT_EQ(label_product(kernel, a, 0, a, 0), 1.0);
  // One colour scale away, in all three colours together: 100^2 = 60^2 + 80^2.
  EXPECT_NEAR(label_product(kernel, a, 0, point({70, 100, 30, 5, -5}), 0), std::exp(-0.5), 1e-12);
  // Two gradient scales away.
  EXPECT_NEAR(label_product(kernel, a, 0, point({10, 20, 30, 5, 15}), 0), std::exp(-2.0), 1e-12);
  EXPECT_NEAR(label_product(kernel, a, 0, point({70, 100, 30, -15, -5}), 0), std::exp(-2.5), 1e-12);
}

TEST(KernelOptions, HaveRanges) {
  KernelOptions kernel;
  EXPECT_NO_THROW(describe(kernel).check());
  for (const char* key : {"sigma", "sparsification", "color_scale", "gradient_scale"}) {
    EXPECT_THROW(describe(kernel).set(key, "0"), OptionError) << key;
    EXPECT_THROW(describe(kernel).set(key, "-1"), OptionError) << key;
    EXPECT_THROW(describe(kernel).set(key, "nan"), OptionError) << key;
    EXPECT_THROW(describe(kernel).set(key, "1e9"), OptionError) << key;
  }
  EXPECT_THROW(describe(kernel).set("color_kernel", "cubic"), OptionError);
}

TEST(KernelOptions, AreSetByName) {
  KernelOptions kernel;
  describe(kernel).set("color_kernel", "linear");
  EXPECT_EQ(kernel.color_kernel, ColorKernel::kLinear);
  describe(kernel).set("color_kernel", "squared_exponential");
  EXPECT_EQ(kernel.color_kernel, ColorKernel::kSquaredExponential);
  describe(kernel).set("sigma", "0.25");
  EXPECT_EQ(kernel.sigma, 0.25);
}

TEST(KernelOptions, SetByCodeAreChecked) {
  KernelOptions kernel;
  kernel.sigma = 0;
  EXPECT_THROW(describe(kernel).check(), OptionError);
}

}  // namespace
}  // namespace cvo_slam
