// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Measures what place recognition costs, beside the cost of comparing descriptors one by one.
#include <map>
#include <memory>
#include <random>
#include <vector>

#include <benchmark/benchmark.h>

#include "cvo_slam/loop/descriptor.h"
#include "cvo_slam/loop/loop_detector.h"
#include "cvo_slam/loop/vocabulary.h"
#include "cvo_slam/synthetic/sensor.h"
#include "cvo_slam/synthetic/sequence.h"
#include "cvo_slam/synthetic/world.h"

namespace cvo_slam {
namespace {

constexpr std::size_t kFeatures = 1000;
constexpr std::size_t kKeyframes = 10000;

std::vector<Descriptor> random_descriptors(std::size_t count) {
  std::mt19937_64 engine(1);
  std::vector<Descriptor> descriptors(count);
  for (auto& descriptor : descriptors) {
    for (auto& word : descriptor.words) word = engine();
  }
  return descriptors;
}

/// Returns a bag of `words` random words. Words with small indices are more frequent: the most
/// frequent ones are in about a tenth of all bags, as in real images.
BagOfWords random_bag(std::size_t vocabulary, std::size_t words, std::mt19937& engine) {
  std::map<WordId, float> counts;
  for (std::size_t i = 0; i < words; ++i) {
    const double u = static_cast<double>(engine()) / 4294967296.0;
    counts[static_cast<WordId>(static_cast<double>(vocabulary) * u * u)] += 1;
  }
  BagOfWords bag;
  for (const auto& [word, count] : counts) {
    bag.push_back({word, count / static_cast<float>(words)});
  }
  return bag;
}

/// Returns a frame of the house as a Kinect sees it, `seconds` after the start.
RgbdFrame house_frame(double seconds) {
  const auto world = synthetic::make_world("house", {.seed = 1});
  const synthetic::Sensor sensor(
      world.scene, [path = world.path](double t) { return path.T_world_camera(t); },
      world.path.duration(), synthetic::synthetic_camera(640, 480),
      synthetic::sensor_preset("kinect"), 1);
  const auto capture = sensor.capture(0, {.color = seconds, .depth = seconds});
  RgbdFrame frame;
  frame.color = capture.color;
  frame.depth = capture.depth;
  return frame;
}

void load_vocabulary(benchmark::State& state) {
  for ([[maybe_unused]] auto iteration : state) benchmark::DoNotOptimize(builtin_vocabulary());
}
BENCHMARK(load_vocabulary)->Unit(benchmark::kMillisecond);

void transform_1000_descriptors(benchmark::State& state) {
  const auto vocabulary = builtin_vocabulary();
  const auto descriptors = random_descriptors(kFeatures);
  for ([[maybe_unused]] auto iteration : state)
    benchmark::DoNotOptimize(vocabulary->transform(descriptors, 1));
}
BENCHMARK(transform_1000_descriptors)->Unit(benchmark::kMillisecond);

/// For comparison: each descriptor against every word.
void find_1000_words_one_by_one(benchmark::State& state) {
  std::vector<Descriptor> words;
  for (const auto& node : builtin_vocabulary()->tree()) {
    if (node.is_word) words.push_back(node.descriptor);
  }
  const auto descriptors = random_descriptors(kFeatures);
  for ([[maybe_unused]] auto iteration : state) {
    for (const auto& descriptor : descriptors) {
      benchmark::DoNotOptimize(nearest_descriptor(descriptor, words));
    }
  }
}
BENCHMARK(find_1000_words_one_by_one)->Unit(benchmark::kMillisecond);

void query_10000_keyframes(benchmark::State& state) {
  const std::size_t word_count = builtin_vocabulary()->words();
  std::mt19937 engine(1);
  KeyframeDatabase database(word_count);
  for (std::size_t i = 0; i < kKeyframes; ++i)
    database.add(random_bag(word_count, kFeatures, engine));
  const BagOfWords bag = random_bag(word_count, kFeatures, engine);
  for ([[maybe_unused]] auto iteration : state)
    benchmark::DoNotOptimize(database.query(bag, kKeyframes));
  state.counters["bytes_a_keyframe"] = static_cast<double>(database.bytes()) / kKeyframes;
}
BENCHMARK(query_10000_keyframes)->Unit(benchmark::kMillisecond);

/// For comparison: the features of one image against those of another one.
void match_1000_with_1000_one_by_one(benchmark::State& state) {
  const auto a = random_descriptors(kFeatures);
  const auto b = random_descriptors(2 * kFeatures);
  const std::span<const Descriptor> others(b.data() + kFeatures, kFeatures);
  for ([[maybe_unused]] auto iteration : state) {
    for (const auto& descriptor : a) {
      benchmark::DoNotOptimize(nearest_descriptor(descriptor, others));
    }
  }
}
BENCHMARK(match_1000_with_1000_one_by_one)->Unit(benchmark::kMillisecond);

void extract_features(benchmark::State& state) {
  const RgbdFrame frame = house_frame(1);
  const Camera camera = synthetic::synthetic_camera(640, 480);
  for ([[maybe_unused]] auto iteration : state)
    benchmark::DoNotOptimize(extract_orb(frame, camera));
}
BENCHMARK(extract_features)->Unit(benchmark::kMillisecond);

void verify_a_loop(benchmark::State& state) {
  const Camera camera = synthetic::synthetic_camera(640, 480);
  const LoopDetector detector(camera);
  const auto a = detector.extract(house_frame(1));
  const auto b = detector.extract(house_frame(1.1));
  const LoopVerifier verifier(camera);
  for ([[maybe_unused]] auto iteration : state) benchmark::DoNotOptimize(verifier.verify(*a, *b));
}
BENCHMARK(verify_a_loop)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace cvo_slam
