// The topics of `raytracer -help TOPIC`: what is to be known beside the list of arguments.
//
// A text is plain ASCII in lines of at most 80 columns. A line in capitals is a heading, other
// lines that begin at the left are paragraphs, and indented ones are shown as they stand (the
// manual page sets them so too).
#pragma once
#include <string>
#include <vector>

struct HelpTopic {
  const char* name;     // one word, small letters
  const char* summary;  // what it is about, at most 60 columns, for the list of topics
  const char* text;     // ends with a line's end
};

/// All topics, in the order in which a beginner may want them.
const std::vector<HelpTopic>& helpTopics();

/// The topic of this name, or nullptr.
const HelpTopic* findTopic(const std::string& name);
