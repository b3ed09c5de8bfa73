// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cvo_slam/apps/command_line.h"
#include "cvo_slam/apps/progress.h"
#include "cvo_slam/apps/training_images.h"
#include "cvo_slam/core/error.h"
#include "cvo_slam/core/parallel.h"
#include "cvo_slam/loop/orb_features.h"
#include "cvo_slam/loop/vocabulary.h"

namespace cvo_slam {
namespace {

struct VocabArguments {
  std::vector<std::string> sources;
  std::filesystem::path input;
  std::filesystem::path output;
  TrainingOptions training;
  OrbOptions orb;
  Thinning thinning;
  int threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  bool json = false;
  bool quiet = false;
};

bool is_text(const std::filesystem::path& file) { return file.extension() == ".txt"; }

/// Writes the format that the name of the file stands for.
void write_either(const std::filesystem::path& file, const Vocabulary& vocabulary) {
  if (is_text(file)) {
    write_vocabulary_text(file, vocabulary);
  } else {
    write_vocabulary(file, vocabulary);
  }
}

/// Collects the descriptors of every image of all sources, in their order.
class DescriptorCollector {
 public:
  explicit DescriptorCollector(const VocabArguments& arguments) : arguments_(arguments) {
    for (const auto& source : arguments.sources) {
      sources_.push_back(open_training_images(source, arguments.thinning));
      total_ += sources_.back().count;
    }
  }

  std::vector<std::vector<Descriptor>> collect(const Executor& executor) {
    std::vector<std::vector<Descriptor>> images;
    Progress progress(total_, arguments_.quiet);
    for (const TrainingImages& source : sources_) {
      for (std::size_t first = 0; first < source.count; first += kBatch) {
        const std::size_t count = std::min(kBatch, source.count - first);
        images.resize(images.size() + count);
        auto* const batch = images.data() + (images.size() - count);
        executor.for_each_chunk(count, 1, [&](std::size_t i, std::size_t, std::size_t) {
          batch[i] = extract_orb(source.read(first + i), Camera(), arguments_.orb).descriptors;
        });
        progress.update(images.size(), "");
      }
    }
    return images;
  }

 private:
  static constexpr std::size_t kBatch = 8;

  const VocabArguments& arguments_;
  std::vector<TrainingImages> sources_;
  std::size_t total_ = 0;
};

/// Finds before minutes of work what would fail after them.
void check(VocabArguments arguments) {
  describe(arguments.training).check();
  const auto folder = std::filesystem::absolute(arguments.output).parent_path();
  if (!std::filesystem::is_directory(folder)) {
    throw OutputError(arguments.output, "its folder does not exist; make it first");
  }
}

int train(const VocabArguments& arguments) {
  check(arguments);
  const Executor executor(arguments.threads);
  const auto images = DescriptorCollector(arguments).collect(executor);
  std::size_t features = 0;
  for (const auto& image : images) features += image.size();
  const Vocabulary vocabulary = train_vocabulary(images, arguments.training, executor);
  write_either(arguments.output, vocabulary);
  if (!arguments.quiet) {
    fmt::print("{}: {} words of {} features in {} images\n", arguments.output.string(),
               vocabulary.words(), features, images.size());
  }
  return kDone;
}

int convert(const VocabArguments& arguments) {
  write_either(arguments.output, read_vocabulary(arguments.input));
  return kDone;
}

int info(const VocabArguments& arguments) {
  const bool built_in = arguments.input.empty();
  const auto start = std::chrono::steady_clock::now();
  const auto vocabulary =
      built_in ? builtin_vocabulary()
               : std::make_shared<const Vocabulary>(read_vocabulary(arguments.input));
  const std::chrono::duration<double, std::milli> elapsed =
      std::chrono::steady_clock::now() - start;
  float largest = 0;
  for (WordId word = 0; word < vocabulary->words(); ++word) {
    largest = std::max(largest, vocabulary->weight(word));
  }
  const nlohmann::ordered_json json = {{"name", built_in ? "built in" : arguments.input.string()},
                                       {"branching", vocabulary->branching()},
                                       {"levels", vocabulary->levels()},
                                       {"words", vocabulary->words()},
                                       {"nodes", vocabulary->nodes()},
                                       {"largest_weight", largest},
                                       {"binary_bytes", vocabulary_bytes(*vocabulary).size()},
                                       {"load_ms", elapsed.count()}};
  if (arguments.json) {
    fmt::print("{}\n", json.dump(2));
  } else {
    for (const auto& [key, value] : json.items()) {
      fmt::print("{:<16}{}\n", key, value.is_string() ? value.get<std::string>() : value.dump());
    }
  }
  return kDone;
}

void add_train(Command& parent, Action& action, const std::shared_ptr<VocabArguments>& a) {
  Command command(parent, "train", "Learn a vocabulary from images");
  command
      .add("sources", &a->sources,
           "Folders of data sets or of images, or synthetic worlds as synth:<world>:<seed>")
      .required();
  command.add("-o,--output", &a->output, "File to write; *.txt = the text format of ORB-SLAM")
      .required();
  command.add("--step", &a->thinning.step, "Use every n-th recorded image")
      .in_range(1, 1000000)
      .show_default();
  command.add("--rate", &a->thinning.synthetic_rate, "Images per second of a synthetic world [Hz]")
      .in_range(0.01, 100.0)
      .show_default();
  command.add("-k,--branching", &a->training.branching, "Number of children of a node")
      .show_default();
  command.add("-L,--levels", &a->training.levels, "Number of steps from the root to a word")
      .show_default();
  command.add("--seed", &a->training.seed, "Seed of the first centres of the clusters")
      .show_default();
  command.add("--features", &a->orb.features, "Largest number of features of an image")
      .in_range(10, 20000)
      .show_default();
  command.add("--threads", &a->threads, "Number of threads; the result does not depend on it")
      .in_range(1, 1024)
      .show_default();
  command.add("--quiet", &a->quiet, "Print nothing");
  command.on_parsed(action, [a] { return train(*a); });
}

void add_convert(Command& parent, Action& action, const std::shared_ptr<VocabArguments>& a) {
  Command command(parent, "convert",
                  "Convert between our binary format and the text format of ORB-SLAM");
  command.add("in", &a->input, "A vocabulary in either format").required();
  command.add("out", &a->output, "File to write: *.txt = text, any other name = binary").required();
  command.on_parsed(action, [a] { return convert(*a); });
}

void add_info(Command& parent, Action& action, const std::shared_ptr<VocabArguments>& a) {
  Command command(parent, "info", "Describe a vocabulary");
  command.add("file", &a->input, "A vocabulary in either format (default: the built-in one)");
  command.add("--json", &a->json, "Print one JSON object instead of text");
  command.on_parsed(action, [a] { return info(*a); });
}

}  // namespace

void add_vocab_command(CLI::App& app, Action& action) {
  const auto arguments = std::make_shared<VocabArguments>();
  Command command(app, "vocab", "Train, convert and describe visual vocabularies");
  command.require_subcommand();
  add_train(command, action, arguments);
  add_convert(command, action, arguments);
  add_info(command, action, arguments);
}

}  // namespace cvo_slam
