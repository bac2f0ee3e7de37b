/**
 * The table of options itself, for what reads it: parsing, --help and completion.
 */
#ifndef OptionTable_h
#define OptionTable_h

#include "CommandLine.h"

#include <CLI/CLI.hpp>

#include <functional>
#include <map>
#include <string>
#include <vector>

class OptionTable
{
public:
  /** Options whose values go to `options`, which has to outlive the table. */
  explicit OptionTable(Options& options);

  CLI::App& GetApp() { return this->App; }

  /** All options that --help lists, in its order. */
  std::vector<const CLI::Option*> GetOptions() const;

  /** What an option's value is one of; empty if it can be anything. */
  std::vector<std::string> GetChoices(const CLI::Option* option) const;

private:
  using Setter = std::function<void(Options&, const std::string& name, const std::string& value)>;
  void Add(
    const std::string& names, const std::string& value, const std::string& text, const Setter& set);
  void AddFlag(
    const std::string& names, bool Options::*member, bool value, const std::string& text);
  void AddChoice(const std::string& names, const std::string& value, std::string Options::*member,
    const std::vector<std::string>& choices, const std::string& text);
  void AddFile(const std::string& names, const std::string& value, std::string Options::*member,
    const std::string& text);
  void AddRemeshing();
  void AddOptimization();
  void AddEmbedding();
  void AddCoordinates();
  void AddComputedFields();
  void AddComputation();
  void AddFiles();
  void AddOther();

  Options& Result;
  CLI::App App;
  std::string Group;
  std::map<const CLI::Option*, std::vector<std::string>> Choices;
};

#endif
