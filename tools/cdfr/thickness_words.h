/// The words of cdfr thickness for its choices.
#pragma once

#include <map>
#include <string>

#include "cdfr/analysis/thickness.h"

namespace cdfr::command {

inline const std::map<std::string, ThicknessMethod> methods{{"sphere", ThicknessMethod::sphere},
                                                            {"ray", ThicknessMethod::ray}};
inline const std::map<std::string, SampleAt> sample_places{{"faces", SampleAt::faces},
                                                           {"vertices", SampleAt::vertices}};
inline const std::map<std::string, EdgePolicy> edge_policies{
    {"sphere", EdgePolicy::sphere}, {"extrapolate", EdgePolicy::extrapolate}, {"skip", EdgePolicy::skip}};

template <class Value>
std::string word_of(const std::map<std::string, Value>& words, Value value) {
  for (const auto& [word, meant] : words) {
    if (meant == value) return word;
  }
  return {};
}

inline std::string method_word(ThicknessMethod method) { return word_of(methods, method); }
inline std::string edges_word(EdgePolicy edges) { return word_of(edge_policies, edges); }
/// --spacing is an option of its own.
inline std::string at_word(SampleAt at) {
  return at == SampleAt::spacing ? "spacing" : word_of(sample_places, at);
}

}  // namespace cdfr::command
